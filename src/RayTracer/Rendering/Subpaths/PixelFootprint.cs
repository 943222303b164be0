using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>How large pixels are where they meet the scene.</summary>
internal static unsafe class PixelFootprint
{
    private const int Edge = 32;

    /// <summary>The median, over a regular grid of the picture's rays, of the side of a pixel across the ray where it meets something; 1 where none does.</summary>
    /// <param name="scene">The scene.</param>
    public static float Median(Scene scene)
    {
        float time = scene.Render.Shutter.X;
        PathStream rays = new(Edge * Edge);
        for (int i = 0; i < Edge * Edge; i++)
        {
            float x = ((i % Edge) + 0.5f) * scene.Render.Width / Edge;
            float y = ((i / Edge) + 0.5f) * scene.Render.Height / Edge;
            scene.Camera.CentralRay(x, y, time, out Vec3W origin, out Vec3W direction);
            rays.SetTime(1, time);
            rays.Append(1, origin, direction, default, default, 0u, 0u);
        }

        PinnedBuffer<int> hits = new(scene.World.RoomForHits(Edge * Edge));
        scene.World.ClosestHit(rays, hits.Pointer);
        List<float> sides = [];
        uint* index = stackalloc uint[16];
        for (int i = 0; i < Edge * Edge; i++)
        {
            if (rays.Primitive[i] < scene.World.Count)
            {
                new Span<uint>(index, 16).Fill((uint)i);
                scene.Camera.Density(rays.PickOrigin(index), rays.PickDirection(index), rays.Distance[i], time, out FloatW density);
                sides.Add(FloatW.Sqrt(1f / density)[0]);
            }
        }

        GC.KeepAlive(hits);
        sides.Sort();
        return sides.Count == 0 ? 1 : sides[sides.Count / 2];
    }
}
