using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>Asks a scene what single rays meet.</summary>
/// <param name="scene">The scene.</param>
internal sealed unsafe class RayProbe(Scene scene)
{
    private readonly PathStream _ray = new(1);
    private readonly PinnedBuffer<int> _hits = new(scene.World.RoomForHits(1));

    /// <summary>The distance to the nearest surface; infinite where there is none.</summary>
    /// <param name="from">Where the ray starts.</param>
    /// <param name="direction">Its unit direction.</param>
    public float Distance(Vector3 from, Vector3 direction)
    {
        float time = scene.Render.Shutter.X;
        _ray.Count = 0;
        _ray.SetTime(1, time);
        _ray.Append(1, new(from.X, from.Y, from.Z), new(direction.X, direction.Y, direction.Z), Rgb.White, Rgb.Black, 0u, 0u);
        _ray.SetStart(1, 0u, default);
        scene.World.ClosestHit(_ray, _hits.Pointer);
        return (int)_ray.Primitive[0] >= scene.World.Count ? float.PositiveInfinity : _ray.Distance[0];
    }
}
