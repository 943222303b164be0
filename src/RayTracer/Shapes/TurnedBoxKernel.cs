using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// Meets boxes that stand askew with rays, slab by slab (Kay &amp; Kajiya 1986). An entry is three maps from a point to its place along the box's axes, as seen from
/// the middle; half the lengths; and the offset of new rays.
/// </summary>
internal readonly unsafe struct TurnedBoxKernel : IShapeKernel
{
    private const int Map = 4;
    private const int Half = 12;
    private const int Offset = 15;

    // As of boxes parallel to the axes.
    private const float Slack = 1 + (1f / (1 << 21));

    public static int Constants => 16;

    public static void Pack(Shape shape, float* entry)
    {
        var box = (TurnedBox)shape;
        AffineMap.Write(entry, box.Axes.X, box.Center, 0);
        AffineMap.Write(entry + Map, box.Axes.Y, box.Center, 0);
        AffineMap.Write(entry + (2 * Map), box.Axes.Z, box.Center, 0);
        entry[Half] = box.Half.X;
        entry[Half + 1] = box.Half.Y;
        entry[Half + 2] = box.Half.Z;
        entry[Offset] = Vector3.Max(Vector3.Abs(box.Bounds.Minimum), Vector3.Abs(box.Bounds.Maximum)).Largest() * RayOffset.Relative;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Meet(float* q, in Vec3W origin, in Vec3W direction)
    {
        FloatW near = float.NegativeInfinity;
        FloatW far = float.PositiveInfinity;
        Slab(q, 0, origin, direction, ref near, ref far);
        Slab(q, 1, origin, direction, ref near, ref far);
        Slab(q, 2, origin, direction, ref near, ref far);
        return (near <= far * Slack).Select((near > 0f).Select(near, far), float.NaN);
    }

    public static void Describe(in PrimitiveIndex primitives, float* table, bool needsUv, ref SurfaceW surface)
    {
        surface.Offset = primitives.Read(table, Offset);
        Vec3W half = primitives.ReadVector(table, Half);
        Vec3W p = surface.Point;
        Vec3W place = new(
            AffineMap.Apply(primitives, table, 0, p), AffineMap.Apply(primitives, table, Map, p), AffineMap.Apply(primitives, table, 2 * Map, p));

        // Of the three pairs of faces, the one that the point is farthest outside of, or least far inside.
        FloatW x = FloatW.Abs(place.X) - half.X;
        FloatW y = FloatW.Abs(place.Y) - half.Y;
        FloatW z = FloatW.Abs(place.Z) - half.Z;
        MaskW isX = (x >= y) & (x >= z);
        MaskW isY = (y >= z).Except(isX);
        MaskW isZ = ~(isX | isY);
        Vec3W side = new(Facing(isX, place.X), Facing(isY, place.Y), Facing(isZ, place.Z));
        Vec3W moved = new(
            Moved(isX, place.X, half.X, side.X, surface.Offset), Moved(isY, place.Y, half.Y, side.Y, surface.Offset), Moved(isZ, place.Z, half.Z, side.Z, surface.Offset));
        Vec3W by = moved - place;
        Frame(primitives, table, out Vec3W alongX, out Vec3W alongY, out Vec3W alongZ);
        surface.Normal = Turned(side, alongX, alongY, alongZ);
        surface.Point = p + Turned(by, alongX, alongY, alongZ);
        if (needsUv)
        {
            BoxKernel.Uv(new(Part(moved.X, half.X), Part(moved.Y, half.Y), Part(moved.Z, half.Z)), side, out surface.U, out surface.V);
        }
    }

    /// <inheritdoc/>
    public static void DescribeTangents(in PrimitiveIndex primitives, float* table, ref SurfaceW surface)
    {
        Frame(primitives, table, out Vec3W alongX, out Vec3W alongY, out Vec3W alongZ);
        Vec3W n = surface.Normal;
        FloatW x = Vec3W.Dot(alongX, n);
        FloatW y = Vec3W.Dot(alongY, n);
        FloatW z = Vec3W.Dot(alongZ, n);
        MaskW isX = FloatW.Abs(x) > 0.5f;
        MaskW isY = FloatW.Abs(y) > 0.5f;
        FloatW side = FloatW.CopySign(2f, isX.Select(x, isY.Select(y, z)));
        Vec3W half = primitives.ReadVector(table, Half);
        surface.AlongU = Turned(new Vec3W(isX.Select(0f, half.X), 0f, isX.Select(-half.Z, 0f)) * side, alongX, alongY, alongZ);
        surface.AlongV = Turned(new Vec3W(0f, isY.Select(0f, half.Y), isY.Select(-half.Z, 0f)) * 2f, alongX, alongY, alongZ);
    }

    // The side on which the ray goes out is that of the direction's sign. Along a face that a ray runs in, the product is 0·∞, and the
    // comparisons leave the slab out.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Slab(float* q, int axis, in Vec3W origin, in Vec3W direction, ref FloatW near, ref FloatW far)
    {
        float* map = q + (Map * axis);
        FloatW place = AffineMap.Apply(map, origin);
        FloatW climb = Vec3W.Dot(new Vec3W(map[0], map[1], map[2]), direction);
        FloatW inverse = 1f / climb;
        FloatW beyond = FloatW.CopySign(q[Half + axis], climb);
        near = FloatW.Max((-beyond - place) * inverse, near);
        far = FloatW.Min((beyond - place) * inverse, far);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Facing(MaskW isAxis, FloatW place) => isAxis.Select((place > 0f).Select(1f, -1f), 0f);

    // Exactly on the face; along it, an offset away from the edges, so that a ray that goes inside starts inside.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Moved(MaskW isAxis, FloatW place, FloatW half, FloatW side, FloatW offset) =>
        isAxis.Select(half * side, FloatW.Max(offset - half, FloatW.Min(half - offset, place)));

    private static FloatW Part(FloatW place, FloatW half) => FloatW.MultiplyAdd(place / half, 0.5f, 0.5f);

    private static void Frame(in PrimitiveIndex primitives, float* table, out Vec3W alongX, out Vec3W alongY, out Vec3W alongZ)
    {
        alongX = primitives.ReadVector(table, 0);
        alongY = primitives.ReadVector(table, Map);
        alongZ = primitives.ReadVector(table, 2 * Map);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vec3W Turned(in Vec3W v, in Vec3W alongX, in Vec3W alongY, in Vec3W alongZ) =>
        Vec3W.MultiplyAdd(alongX, v.X, Vec3W.MultiplyAdd(alongY, v.Y, alongZ * v.Z));
}
