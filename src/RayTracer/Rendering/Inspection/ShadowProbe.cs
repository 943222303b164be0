using System.Numerics;
using RayTracer.Lights;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Finds what stands in the way of a light.</summary>
/// <param name="scene">The scene.</param>
internal sealed unsafe class ShadowProbe(Scene scene)
{
    private const int MostBoundaries = 64;
    private const float Reached = 1 - 1e-4f;
    private const float Step = 1e-4f;
    private readonly PathStream _ray = new(1);
    private readonly PinnedBuffer<int> _hits = new(scene.World.RoomForHits(1));

    /// <summary>Returns the first surface in the way that lets no light through; that of none where none is found.</summary>
    /// <param name="from">The start.</param>
    /// <param name="direction">The unit direction to the light.</param>
    /// <param name="distance">Its distance.</param>
    /// <param name="time">The time in seconds.</param>
    /// <param name="light">The light, which is not in its own way.</param>
    public SurfaceName Blocker(Vector3 from, Vector3 direction, float distance, float time, LightSource light)
    {
        SurfaceName last = SurfaceName.None;
        for (int i = 0; i < MostBoundaries; i++)
        {
            _ray.Count = 0;
            _ray.SetTime(1, time);
            _ray.Append(1, new(from.X, from.Y, from.Z), new(direction.X, direction.Y, direction.Z), Rgb.White, Rgb.Black, 0u, 0u);
            _ray.SetStart(1, 0u, default);
            scene.World.ClosestHit(_ray, _hits.Pointer);
            int primitive = (int)_ray.Primitive[0];
            float met = _ray.Distance[0];
            if (primitive >= scene.World.Count || met >= distance * Reached)
            {
                return last;
            }

            SurfaceName name = new(primitive, scene.World.Instances is null ? 0 : (int)_ray.Instance[0]);
            ShadingGroup group = scene.Groups[scene.GroupOfPrimitive[primitive]];
            bool isLight = primitive == light.Primitive && name.Instance == light.Instance;
            bool letsThrough = isLight || (scene.HasMedia && group.Traits.IsBoundary) || (scene.WeakensShadows && group.Traits.IsTransparent);
            if (!letsThrough)
            {
                return name;
            }

            last = isLight ? last : name;
            float step = met + (Step * Math.Max(met, 1e-3f));
            (from, distance) = (from + (direction * step), distance - step);
        }

        return last;
    }
}
