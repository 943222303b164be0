using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Finds out whether the camera stands inside of something opaque, where no light comes.</summary>
internal static unsafe class EnclosingThing
{
    // Rays through the points of a grid on a cube, with so many in each row.
    private const int Row = 9;
    private const int Rays = Row * Row * Row;

    /// <summary>Returns true where rays to all sides meet the backs of what is opaque and dark, with no light among them.</summary>
    public static bool IsAround(Scene scene)
    {
        PathStream rays = new((Rays + 15) / 16 * 16);
        PinnedBuffer<int> hits = new(scene.World.RoomForHits((Rays + 15) / 16 * 16));
        Vec3W origin = scene.Camera.Origin(scene.Render.Shutter.X);
        for (int i = 0; i < Rays; i++)
        {
            (int x, int y, int z) = ((i % Row) - (Row / 2), (i / Row % Row) - (Row / 2), (i / (Row * Row)) - (Row / 2));
            if (int.Max(int.Abs(x), int.Max(int.Abs(y), int.Abs(z))) == Row / 2)
            {
                // Off the axes, so that no ray runs along a surface that scenes are likely to have.
                Append(rays, scene, origin, new Vector3(x + 0.231f, y + 0.117f, z - 0.173f).Unit());
            }
        }

        scene.World.ClosestHit(rays, hits.Pointer);

        // Nothing else holds this memory, which the garbage collector would give away while the trees write to it.
        GC.KeepAlive(hits);
        Bounds around = Bounds.Empty;
        for (int i = 0; i < rays.Count; i++)
        {
            if (!MeetsBack(scene, rays, (uint)i, out Vector3 point))
            {
                return false;
            }

            around = new(Vector3.Min(around.Minimum, point), Vector3.Max(around.Maximum, point));
        }

        return !scene.Lights.Any(l => IsIn(l, around, scene));
    }

    private static void Append(PathStream rays, Scene scene, in Vec3W origin, in Vec3W direction)
    {
        if (scene.IsTimed)
        {
            rays.SetTime(1u, scene.Render.Shutter.X);
        }

        rays.Append(1u, origin, direction, Rgb.White, Rgb.Black, 0u, 0u);
    }

    private static bool MeetsBack(Scene scene, PathStream rays, uint ray, out Vector3 point)
    {
        point = default;
        int number = scene.GroupOfPrimitive[(int)rays.Primitive[(int)ray]];
        if (number >= scene.Groups.Length
            || scene.Groups[number].Traits is { Transmits: true } or { IsTransparent: true } or { IsBoundary: true } or { Emits: true }
            || scene.Groups[number].Traits is { Interior: not null } or { Nesting: not null })
        {
            return false;
        }

        uint* index = stackalloc uint[16];
        new Span<uint>(index, 16).Fill(ray);
        ShadingGroup group = scene.Groups[number];
        SurfaceShader.Describe(scene, group, rays, index, group.Traits.UsesUv, out SurfaceW surface);
        point = new(surface.Point.X[0], surface.Point.Y[0], surface.Point.Z[0]);
        return (SurfaceShader.ComesFromInside(surface).Bits & 1) != 0;
    }

    private static bool IsIn(Lights.LightSource light, in Bounds around, Scene scene)
    {
        Bounds box = light.Extent((scene.Render.Shutter.X, scene.Render.Shutter.Y)).Box;
        return box.IsFinite && Vector3.Max(box.Minimum, around.Minimum) is var low && Vector3.Min(box.Maximum, around.Maximum) is var high
            && low.X <= high.X && low.Y <= high.Y && low.Z <= high.Z;
    }
}
