using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Tells what is seen at points of the picture, through the middle of the lens and when the shutter opens. Each thread has its own.
/// </summary>
public sealed unsafe class SurfaceProbe
{
    private const int StreamSize = 1024;
    private readonly Scene _scene;
    private readonly PathStream _rays = new(StreamSize);
    private readonly PinnedBuffer<int> _hits;

    /// <summary>Prepares.</summary>
    /// <param name="scene">The scene.</param>
    public SurfaceProbe(Scene scene)
    {
        _scene = scene;
        _hits = new(scene.World.RoomForHits(StreamSize));
    }

    /// <summary>Tells which surfaces are seen at points of a row.</summary>
    /// <param name="y">The row, in pixels from the top edge.</param>
    /// <param name="x">The first point's column, in pixels from the left edge.</param>
    /// <param name="step">From a point to the next.</param>
    /// <param name="names">Takes the surfaces.</param>
    public void Name(float y, float x, float step, Span<SurfaceName> names)
    {
        for (int first = 0; first < names.Length; first += StreamSize)
        {
            Span<SurfaceName> some = names[first..Math.Min(names.Length, first + StreamSize)];
            Trace(y, x + (first * step), step, some.Length);
            for (int i = 0; i < some.Length; i++)
            {
                some[i] = NameOf(i);
            }
        }
    }

    /// <summary>Describes what is seen at a point of the picture; null where nothing is.</summary>
    /// <param name="x">Column, in pixels from the left edge.</param>
    /// <param name="y">Row, in pixels from the top edge.</param>
    public SurfaceHit? Describe(float x, float y)
    {
        Trace(y, x, 0, 1);
        SurfaceName name = NameOf(0);
        if (name == SurfaceName.None)
        {
            return null;
        }

        uint* index = stackalloc uint[FloatW.Count];
        new Span<uint>(index, FloatW.Count).Clear();
        ShadingGroup group = _scene.Groups[_scene.GroupOfPrimitive[name.Primitive]];
        SurfaceShader.Describe(_scene, group, _rays, index, group.Traits.UsesUv, out SurfaceW surface);
        return new(
            name, _rays.Distance[0], new(surface.Point.X[0], surface.Point.Y[0], surface.Point.Z[0]), new(surface.Facing.X[0], surface.Facing.Y[0], surface.Facing.Z[0]));
    }

    private void Trace(float y, float x, float step, int count)
    {
        float time = _scene.Render.Shutter.X;
        _rays.Count = 0;
        for (int i = 0; i < count; i++)
        {
            _scene.Camera.CentralRay(float.FusedMultiplyAdd(i, step, x), y, time, out Vec3W origin, out Vec3W direction);
            _rays.SetTime(1, time);
            _rays.Append(1, origin, direction, Rgb.White, Rgb.Black, 0u, 0u);
        }

        _scene.World.ClosestHit(_rays, _hits.Pointer);
    }

    private SurfaceName NameOf(int ray) =>
        _rays.Primitive[ray] == _scene.World.Count ? SurfaceName.None : new((int)_rays.Primitive[ray], _scene.World.Instances is null ? 0 : (int)_rays.Instance[ray]);
}

/// <summary>The point at which a ray meets a surface.</summary>
/// <param name="Name">Which surface.</param>
/// <param name="Distance">The distance from the ray's start.</param>
/// <param name="Position">Where, in the world.</param>
/// <param name="Normal">The unit normal with which the surface is shaded, on the ray's side.</param>
public sealed record SurfaceHit(SurfaceName Name, float Distance, Vector3 Position, Vector3 Normal);

/// <summary>The name of a surface that a ray meets.</summary>
/// <param name="Primitive">The primitive's number; −1 for none.</param>
/// <param name="Instance">The instance that shows it; 0 for the world itself.</param>
public readonly record struct SurfaceName(int Primitive, int Instance)
{
    /// <summary>Nothing is met.</summary>
    public static SurfaceName None => new(-1, 0);
}
