using System.Collections.Immutable;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>The user's settings of the view, beside those of the scene.</summary>
/// <param name="Mode">The state that the user wants of the rendering.</param>
/// <param name="Region">The part of the picture to render; null for all of it.</param>
/// <param name="Samples">The samples instead of those that the scene asks for; null for those.</param>
public sealed record ViewSettings(RenderMode Mode = RenderMode.Running, Tile? Region = null, int? Samples = null)
{
    /// <summary>The number of threads: by default, as many as there are.</summary>
    public int Threads { get; init; } = Environment.ProcessorCount;

    /// <summary>True if pictures are filtered while something moves; else coarse ones are shown as they are.</summary>
    public bool FiltersMotion { get; init; } = true;

    /// <summary>The factors on the light of lights by their names, others are 1; null where they are not kept apart.</summary>
    public ImmutableDictionary<string, Rgb>? LightFactors { get; init; }

    /// <summary>The map that is shown.</summary>
    public ViewMap Map { get; init; } = ViewMap.Light;

    /// <summary>The names of the editions of the renderer, the fast one first.</summary>
    public static IReadOnlyList<string> Editions => Jobs.Edition.Words;

    /// <summary>The edition that renders, as <c>--edition</c> names it; null for the fast one.</summary>
    public string? Edition { get; init; }

    /// <summary>The same settings with an edition by its name.</summary>
    public ViewSettings WithEdition(string name) => this with { Edition = name == Editions[0] ? null : name };

    /// <summary>The same in words; null where there are none for it.</summary>
    public RenderQuality? Quality => Samples is { } samples && Enum.IsDefined((RenderQuality)samples) ? (RenderQuality)samples : null;
}

/// <summary>The state that the user wants of the rendering.</summary>
public enum RenderMode
{
    /// <summary>It goes on to the last sample.</summary>
    Running,

    /// <summary>It waits, and may go on.</summary>
    Paused,

    /// <summary>It has been ended by the user.</summary>
    Stopped,
}

/// <summary>The presets of samples for each pixel. All are squares, as some samplers need.</summary>
public enum RenderQuality
{
    /// <summary>To look at while working.</summary>
    Draft = 16,

    /// <summary>To show to others.</summary>
    Good = 256,

    /// <summary>To print.</summary>
    Final = 1024,
}

/// <summary>The exposure and tone map of the screen.</summary>
/// <param name="Exposure">In stops, −100 to 100, each of which doubles the light; or automatic.</param>
/// <param name="ToneMap">The curve.</param>
public sealed record Tone(Exposure Exposure, ToneMap ToneMap)
{
    /// <summary>The options of files that show the same.</summary>
    public ImageWriteOptions Writing => new() { Exposure = Exposure, ToneMap = ToneMap };

    /// <summary>That of a scene.</summary>
    public static Tone Of(RenderDescription render) => new(render.ShownExposure, render.ShownToneMap);

    /// <summary>Light as it is.</summary>
    public static Tone Plain { get; } = new(0, ToneMap.Clamp);
}
