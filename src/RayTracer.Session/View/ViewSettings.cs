using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>What the user wants of the view, beside what the scene says.</summary>
public sealed record ViewSettings
{
    /// <summary>Whether rendering goes on.</summary>
    public RenderMode Mode { get; init; }

    /// <summary>Number of threads. One core is left to the user by default.</summary>
    public int Threads { get; init; } = Math.Max(1, Environment.ProcessorCount - 1);

    /// <summary>What is shown.</summary>
    public ViewMap Map { get; init; } = ViewMap.Light;

    /// <summary>The part of the picture to render; null for all of it.</summary>
    public Tile? Region { get; init; }

    /// <summary>Samples instead of those that the scene asks for; null for those.</summary>
    public int? Samples { get; init; }

    /// <summary>The same in words; null where there are none for it.</summary>
    public RenderQuality? Quality => Samples is { } samples && Enum.IsDefined((RenderQuality)samples) ? (RenderQuality)samples : null;
}
