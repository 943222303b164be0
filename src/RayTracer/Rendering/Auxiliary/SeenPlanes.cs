using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What one sample of each pixel sees through mirrors and clear glass, as planes of floats that are written again for each picture of a moving view. Nothing is
/// added up: a filter takes it as it is.
/// </summary>
internal sealed unsafe class SeenPlanes
{
    // How far what surrounds everything stands: points there move with the direction alone.
    private const float Beyond = 1e6f;

    // Points, normals and albedo, three planes each.
    private readonly PinnedBuffer<float> _planes;
    private readonly float* _first;
    private readonly nint _size;

    /// <summary>Makes room.</summary>
    /// <param name="rows">How pixels lie in the planes.</param>
    public SeenPlanes(PaddedRows rows)
    {
        (Rows, Surface, _planes, _size) = (rows, new SurfaceName[rows.Size], new(9L * rows.Size), rows.Size);
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

    /// <summary>Takes what a ray sees.</summary>
    /// <param name="at">The place of its pixel.</param>
    /// <param name="hit">The last surface; <see cref="FirstHit.Primitive"/> is 0 for none.</param>
    /// <param name="instance">The instance that shows it.</param>
    /// <param name="first">The ray from the camera: origin, direction, and the length of the whole path.</param>
    public void Take(long at, in FirstHit hit, int instance, in (Vector3 Origin, Vector3 Direction, float Length) first)
    {
        bool isHit = hit.Primitive > 0;
        Store(0, at, first.Origin + (first.Direction * (isHit ? first.Length : Beyond)));
        Store(3, at, isHit ? hit.Normal : Vector3.Zero);
        Store(6, at, isHit ? new(hit.Albedo.R, hit.Albedo.G, hit.Albedo.B) : Vector3.One);
        Surface[at] = isHit ? new((int)hit.Primitive - 1, instance) : SurfaceName.None;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private float* Plane(int number) => _first + (number * _size);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vec3W Load(int first, int at) => new(FloatW.Load(Plane(first) + at), FloatW.Load(Plane(first + 1) + at), FloatW.Load(Plane(first + 2) + at));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Store(int first, long at, Vector3 v) => (Plane(first)[at], Plane(first + 1)[at], Plane(first + 2)[at]) = (v.X, v.Y, v.Z);
}
