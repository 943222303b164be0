using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// Meets boxes with rays, slab by slab (Kay &amp; Kajiya 1986). An entry is both corners and the offset of new rays. A ray is inside if and
/// only if its origin is, and then it meets the box: the signs of differences of floats are exact.
/// </summary>
internal readonly unsafe struct BoxKernel : IShapeKernel
{
    private const int Maximum = 3;
    private const int Offset = 6;

    // Quotients are wrong by 3 u at most: rays between two boxes that share a face meet one of them.
    private const float Slack = 1 + (1f / (1 << 21));

    public static int Constants => 7;

    public static void Pack(Shape shape, float* entry)
    {
        Bounds bounds = shape.Bounds;
        for (int axis = 0; axis < 3; axis++)
        {
            entry[axis] = bounds.Minimum[axis];
            entry[Maximum + axis] = bounds.Maximum[axis];
        }

        entry[Offset] = Vector3.Max(Vector3.Abs(bounds.Minimum), Vector3.Abs(bounds.Maximum)).Largest() * RayOffset.Relative;
    }

    public static FloatW Meet(float* q, in Vec3W origin, in Vec3W direction)
    {
        FloatW near = float.NegativeInfinity;
        FloatW far = float.PositiveInfinity;
        Slab(q, 0, origin.X, direction.X, ref near, ref far);
        Slab(q, 1, origin.Y, direction.Y, ref near, ref far);
        Slab(q, 2, origin.Z, direction.Z, ref near, ref far);
        return (near <= far * Slack).Select((near > 0f).Select(near, far), float.NaN);
    }

    public static void Describe(in PrimitiveIndex primitives, float* table, bool needsUv, ref SurfaceW surface)
    {
        Vec3W minimum = primitives.ReadVector(table, 0);
        Vec3W maximum = primitives.ReadVector(table, Maximum);
        surface.Offset = primitives.Read(table, Offset);
        Vec3W p = surface.Point;
        Vec3W above = p - maximum;
        Vec3W below = minimum - p;

        // Of the six faces, the one that the point is farthest outside of, or least far inside.
        FloatW x = FloatW.Max(above.X, below.X);
        FloatW y = FloatW.Max(above.Y, below.Y);
        FloatW z = FloatW.Max(above.Z, below.Z);
        MaskW isX = (x >= y) & (x >= z);
        MaskW isY = (y >= z).Except(isX);
        MaskW isZ = ~(isX | isY);
        surface.Normal = new(Facing(isX, above.X, below.X), Facing(isY, above.Y, below.Y), Facing(isZ, above.Z, below.Z));
        surface.Point = new(
            Place(isX, p.X, minimum.X, maximum.X, surface.Normal.X, surface.Offset),
            Place(isY, p.Y, minimum.Y, maximum.Y, surface.Normal.Y, surface.Offset),
            Place(isZ, p.Z, minimum.Z, maximum.Z, surface.Normal.Z, surface.Offset));
        if (needsUv)
        {
            Vec3W offset = surface.Point - minimum;
            Vec3W size = maximum - minimum;
            Uv(new(offset.X / size.X, offset.Y / size.Y, offset.Z / size.Z), surface.Normal, out surface.U, out surface.V);
        }
    }

    /// <inheritdoc/>
    public static void DescribeTangents(in PrimitiveIndex primitives, float* table, ref SurfaceW surface)
    {
        Vec3W size = primitives.ReadVector(table, Maximum) - primitives.ReadVector(table, 0);
        Vec3W n = surface.Normal;
        FloatW side = n.X + n.Y + n.Z;
        MaskW isX = FloatW.Abs(n.X) > 0f;
        MaskW isY = FloatW.Abs(n.Y) > 0f;
        surface.AlongU = new Vec3W(isX.Select(0f, size.X), 0f, isX.Select(-size.Z, 0f)) * side;
        surface.AlongV = new(0f, isY.Select(0f, size.Y), isY.Select(-size.Z, 0f));
    }

    /// <summary>
    /// uv of a point of the face of a normal, given as parts of the box's size from the corner of the smallest coordinates.
    /// </summary>
    public static void Uv(in Vec3W place, in Vec3W normal, out FloatW u, out FloatW v)
    {
        FloatW side = normal.X + normal.Y + normal.Z;
        MaskW isX = FloatW.Abs(normal.X) > 0f;
        MaskW isY = FloatW.Abs(normal.Y) > 0f;
        FloatW right = isX.Select(1f - place.Z, place.X);
        u = (side > 0f).Select(right, 1f - right);
        v = isY.Select(1f - place.Z, place.Y);
    }

    // In a face that a ray runs along, the quotient is 0/0, and the comparisons leave the slab out.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Slab(float* q, int axis, FloatW origin, FloatW direction, ref FloatW near, ref FloatW far)
    {
        FloatW a = (q[axis] - origin) / direction;
        FloatW b = (q[Maximum + axis] - origin) / direction;
        near = FloatW.Max(FloatW.Min(a, b), near);
        far = FloatW.Min(FloatW.Max(a, b), far);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Facing(MaskW isAxis, FloatW above, FloatW below) => isAxis.Select((above > below).Select(1f, -1f), 0f);

    // Exactly on the face; along it, an offset away from the edges, so that a ray that goes inside starts inside.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Place(MaskW isAxis, FloatW p, FloatW minimum, FloatW maximum, FloatW normal, FloatW offset)
    {
        FloatW onFace = (normal > 0f).Select(maximum, minimum);
        return isAxis.Select(onFace, FloatW.Max(minimum + offset, FloatW.Min(maximum - offset, p)));
    }
}
