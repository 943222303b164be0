using RayTracer.Acceleration;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>The stage between generating and shading: what the rays of a stream meet.</summary>
internal static unsafe class NearestHits
{
    /// <summary>Finds the nearest hit of each ray.</summary>
    /// <param name="world">The things that they may meet.</param>
    /// <param name="paths">The rays.</param>
    /// <param name="hits">Room to work in.</param>
    public static void ClosestHit(this World world, PathStream paths, int* hits)
    {
        MeetShapes(world.Itself, paths);
        if (world.Itself.Tree is not null)
        {
            world.Itself.Tree.ClosestHit(paths.Rays(hits));
            uint first = (uint)world.Itself.Mesh!.FirstPrimitive;
            for (int i = 0; i < paths.Count; i++)
            {
                paths.Primitive[i] = hits[i] >= 0 ? first + (uint)hits[i] : paths.Primitive[i];
            }
        }

        if (world.Instances is not null)
        {
            for (int i = 0; i < paths.Count; i++)
            {
                InstanceHit hit = new(paths.Distance[i], (int)paths.Primitive[i], 0);
                world.Instances.ClosestHit(paths.Ray(i), world.Instances.Moves ? paths.Time[i] : 0, ref hit);
                (paths.Distance[i], paths.Primitive[i], paths.Instance[i]) = (hit.Distance, (uint)hit.Primitive, (uint)hit.Instance);
            }
        }
    }

    private static void MeetShapes(Space space, PathStream s)
    {
        ref RayW ray = ref s.Packet;
        for (int i = 0; i < s.Count; i += FloatW.Count)
        {
            ray.Origin = new(FloatW.Load(s.OriginX + i), FloatW.Load(s.OriginY + i), FloatW.Load(s.OriginZ + i));
            ray.Direction = new(FloatW.Load(s.DirectionX + i), FloatW.Load(s.DirectionY + i), FloatW.Load(s.DirectionZ + i));
            space.Primitives.ClosestHit(ray.Origin, ray.Direction, out ray.Distance, out ray.Primitive, s.Count - i);
            ray.Distance.Store(s.Distance + i);
            ray.Primitive.Store(s.Primitive + i);
        }
    }
}
