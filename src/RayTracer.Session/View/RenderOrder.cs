using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>The scene to render, and how to render it.</summary>
/// <param name="Scene">The scene, as it is rendered in the end.</param>
/// <param name="Camera">Its camera.</param>
/// <param name="Picture">The number of the picture: orders with the same number continue its samples.</param>
/// <param name="Region">The part to render; null for all of it.</param>
/// <param name="Threads">The number of threads.</param>
/// <param name="Map">The map that is shown.</param>
/// <param name="Mode">The state that the user wants of the rendering.</param>
/// <param name="Start">The film whose samples the picture begins with; null for none.</param>
public sealed record RenderOrder(
    Scene Scene, CameraDescription Camera, long Picture, Tile? Region, int Threads, ViewMap Map, RenderMode Mode, FilmStart? Start = null)
{
    /// <summary>The first sample that pixels get: more than 0 where the picture goes on with a part of one.</summary>
    public int First => Start?.Held.First ?? 0;

    /// <summary>One more than the last sample that each pixel gets.</summary>
    public int Samples => First > 0 ? Start!.Header.Wanted.End : Scene.Render.SamplesPerPixel;

    /// <summary>The part to render.</summary>
    public Tile Area => Region ?? new(0, 0, Scene.Render.Width, Scene.Render.Height);
}
