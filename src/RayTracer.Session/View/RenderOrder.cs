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
    public ViewMap Map { get; init; } = ViewMap.Light;

    /// <summary>Whether rendering goes on.</summary>
    public RenderMode Mode { get; init; }

    /// <summary>The film whose samples the picture begins with; null for none.</summary>
    public FilmStart? Start { get; init; }

    /// <summary>The first sample that pixels get: more than 0 where the picture goes on with a part of one.</summary>
    public int First => Start?.Held.First ?? 0;

    /// <summary>One more than the last sample that each pixel gets.</summary>
    public int Samples => First > 0 ? Start!.Header.Wanted.End : Scene.Render.SamplesPerPixel;

    /// <summary>The part to render.</summary>
    public Tile Area => Region ?? new(0, 0, Scene.Render.Width, Scene.Render.Height);
}
