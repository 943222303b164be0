using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>The scene to render, and how to render it.</summary>
public sealed record RenderOrder
{
    /// <summary>The scene, as it is rendered in the end.</summary>
    public required Scene Scene { get; init; }

    /// <summary>Its camera.</summary>
    public required CameraDescription Camera { get; init; }

    /// <summary>The number of the picture: orders with the same number continue its samples.</summary>
    public required long Picture { get; init; }

    /// <summary>The part to render; null for all of it.</summary>
    public Tile? Region { get; init; }

    /// <summary>Number of threads.</summary>
    public int Threads { get; init; } = 1;

    /// <summary>The map that is shown.</summary>
    public ViewMap Map { get; init; } = ViewMap.Light;

    /// <summary>The state that the user wants of the rendering.</summary>
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
