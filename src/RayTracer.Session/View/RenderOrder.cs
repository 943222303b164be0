using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>What is to be rendered, and how.</summary>
public sealed record RenderOrder
{
    /// <summary>The scene, as it is rendered in the end.</summary>
    public required Scene Scene { get; init; }

    /// <summary>Its camera.</summary>
    public required CameraDescription Camera { get; init; }

    /// <summary>Which picture it is: orders with the same number go on with the samples that there are.</summary>
    public required long Picture { get; init; }

    /// <summary>The part to render; null for all of it.</summary>
    public Tile? Region { get; init; }

    /// <summary>Number of threads.</summary>
    public int Threads { get; init; } = 1;

    /// <summary>What is shown.</summary>
    public ViewMap Map { get; init; }

    /// <summary>Whether rendering goes on.</summary>
    public RenderMode Mode { get; init; }

    /// <summary>Samples that each pixel gets.</summary>
    public int Samples => Scene.Render.SamplesPerPixel;

    /// <summary>The part to render.</summary>
    public Tile Area => Region ?? new(0, 0, Scene.Render.Width, Scene.Render.Height);
}
