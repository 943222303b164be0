using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// The light of one sample of each pixel, and what it sees through mirrors and clear glass, as planes of floats that are written again for each picture of a
/// moving view. Nothing is added up: a filter takes it as it is.
/// </summary>
internal sealed unsafe class SeenPlanes
{
    /// <summary>The planes of what is seen: points, normals and albedo, three each.</summary>
    public const int Kinds = 9;

    // How far what surrounds everything stands: points there move with the direction alone.
    private const float Beyond = 1e6f;

    // Points, normals, albedo and light, three planes each.
    private readonly PinnedBuffer<float> _planes;
    private readonly float* _first;
    private readonly nint _size;

    /// <summary>Makes room.</summary>
    /// <param name="rows">How pixels lie in the planes.</param>
    public SeenPlanes(PaddedRows rows)
    {
        (Rows, Surface, _planes, _size) = (rows, new SurfaceName[rows.Size], new(12L * rows.Size), rows.Size);
        _first = _planes.Pointer;
    }

    /// <summary>How pixels lie in the planes.</summary>
    public PaddedRows Rows { get; }

    /// <summary>The position of the camera.</summary>
    public Vector3 Eye { get; set; }

    /// <summary>The surfaces.</summary>
    public SurfaceName[] Surface { get; }

    /// <summary>
    /// The points that are seen, as far behind a mirror as the light has gone: there they stay while the camera moves. Where nothing is seen, points far away.
    /// </summary>
    /// <param name="at">The place of the first pixel.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W Point(int at) => Load(0, at);

    /// <summary>The unit normals there; zero where nothing is seen.</summary>
    /// <param name="at">The place of the first pixel.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W Normal(int at) => Load(3, at);

    /// <summary>The part of the light that comes from there to the camera; white where nothing is seen.</summary>
    /// <param name="at">The place of the first pixel.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W Albedo(int at) => Load(6, at);

    /// <summary>The plane of a coordinate of the normals.</summary>
    public float* Normals(int axis) => Plane(3 + axis);

    /// <summary>The light.</summary>
    /// <param name="at">The place of the first pixel.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W Light(int at) => Load(9, at);

    /// <summary>The surface that a ray meets.</summary>
    public static SurfaceName SurfaceOf(Scene scene, PathStream stream, int ray) =>
        new((int)stream.Primitive[ray], scene.World.Instances is null ? 0 : (int)stream.Instance[ray]);

    /// <summary>Takes the light of a pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void TakeLight(int at, float red, float green, float blue)
    {
        float* to = Plane(9) + at;
        (to[0], to[_size], to[2 * _size]) = (red, green, blue);
    }

    /// <summary>Writes what rays see side by side, for <see cref="Take(uint*, float*, uint)"/>.</summary>
    /// <param name="point">The points, as far behind a mirror as the light has gone.</param>
    /// <param name="normal">The unit normals there.</param>
    /// <param name="albedo">The part of the light that comes from there to the camera.</param>
    /// <param name="to">Takes <see cref="Kinds"/> registers.</param>
    public static void Put(in Vec3W point, in Vec3W normal, in RgbW albedo, float* to)
    {
        point.X.Store(to);
        point.Y.Store(to + FloatW.Count);
        point.Z.Store(to + (2 * FloatW.Count));
        normal.X.Store(to + (3 * FloatW.Count));
        normal.Y.Store(to + (4 * FloatW.Count));
        normal.Z.Store(to + (5 * FloatW.Count));
        albedo.R.Store(to + (6 * FloatW.Count));
        albedo.G.Store(to + (7 * FloatW.Count));
        albedo.B.Store(to + (8 * FloatW.Count));
    }

    /// <summary>Takes what rays see, but for the surfaces.</summary>
    /// <param name="places">The places of their pixels, a register of them.</param>
    /// <param name="seen">What <see cref="Put"/> has written.</param>
    /// <param name="lanes">The rays.</param>
    public void Take(uint* places, float* seen, uint lanes)
    {
        // Camera rays that meet one thing are most often neighbours: registers are stored whole then.
        bool isRow = lanes == MaskW.All.Bits && UIntW.Equal(UIntW.Load(places), UIntW.Iota + places[0]).Bits == lanes;
        float* to = _first;
        for (int kind = 0; kind < Kinds; kind++, to += _size, seen += FloatW.Count)
        {
            if (isRow)
            {
                FloatW.Load(seen).Store(to + places[0]);
                continue;
            }

            for (uint rest = lanes; rest != 0; rest &= rest - 1)
            {
                int lane = BitOperations.TrailingZeroCount(rest);
                to[places[lane]] = seen[lane];
            }
        }
    }

    /// <summary>Takes what a ray sees.</summary>
    /// <param name="at">The place of its pixel.</param>
    /// <param name="point">The point, as far behind a mirror as the light has gone.</param>
    /// <param name="normal">The unit normal there.</param>
    /// <param name="albedo">The part of the light that comes from there to the camera.</param>
    /// <param name="surface">The surface.</param>
    public void Take(int at, Vector3 point, Vector3 normal, Rgb albedo, SurfaceName surface)
    {
        Store(0, at, point);
        Store(3, at, normal);
        Store(6, at, new(albedo.R, albedo.G, albedo.B));
        Surface[at] = surface;
    }

    /// <summary>Takes a ray that meets nothing.</summary>
    /// <param name="at">The place of its pixel.</param>
    /// <param name="origin">Where it leaves the camera.</param>
    /// <param name="direction">Its direction there.</param>
    public void TakeNothing(int at, Vector3 origin, Vector3 direction) => Take(at, origin + (direction * Beyond), Vector3.Zero, Rgb.White, SurfaceName.None);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private float* Plane(int number) => _first + (number * _size);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vec3W Load(int first, int at) => new(FloatW.Load(Plane(first) + at), FloatW.Load(Plane(first + 1) + at), FloatW.Load(Plane(first + 2) + at));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Store(int first, long at, Vector3 v) => (Plane(first)[at], Plane(first + 1)[at], Plane(first + 2)[at]) = (v.X, v.Y, v.Z);
}
