using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// All flat shapes of one kind in a scene. An entry is n and d of the plane n·p = d, two affine maps from a point to the
/// coordinates that the outline is tested in (Wald 2004's idea of a precomputed projection, in three dimensions), the maps to
/// u and v, and the outline.
/// </summary>
internal sealed unsafe class FlatBatch : ShapeBatch
{
    public const int First = 4;
    public const int Second = 8;
    public const int MapU = 12;
    public const int MapV = 16;
    private const int OutlineBits = 20;
    private const int Constants = 21;

    public FlatBatch(IReadOnlyList<Shape> shapes)
        : base(shapes.Count, Constants)
    {
        for (int i = 0; i < shapes.Count; i++)
        {
            float* q = Table + (i * Constants);
            *(Outline*)(q + OutlineBits) = ((FlatShape)shapes[i]).Pack(q);
        }
    }

    /// <summary>Writes the plane of an entry.</summary>
    public static void WritePlane(float* entry, Vector3 normal, Vector3 point)
    {
        entry[0] = normal.X;
        entry[1] = normal.Y;
        entry[2] = normal.Z;
        entry[3] = normal.Dot(point);
    }

    /// <inheritdoc/>
    public override void ClosestHit(int from, int to, in Vec3W origin, in Vec3W direction, ref FloatW distance, ref UIntW primitive)
    {
        Vec3W o = origin;
        Vec3W d = direction;
        FloatW nearest = distance;
        UIntW hitPrimitive = primitive;
        float* q = Table + ((long)from * Constants);
        for (int i = from; i < to; i++, q += Constants)
        {
            var normal = new Vec3W(q[0], q[1], q[2]);
            FloatW t = (q[3] - Vec3W.Dot(normal, o)) / Vec3W.Dot(normal, d);
            MaskW hit = (t > 0f) & (t < nearest);
            Outline outline = *(Outline*)(q + OutlineBits);
            if (outline != Outline.None)
            {
                hit &= IsWithin(outline, q, Vec3W.MultiplyAdd(d, t, o));
            }

            nearest = hit.Select(t, nearest);
            hitPrimitive = hit.Select((uint)(FirstPrimitive + i), hitPrimitive);
        }

        distance = nearest;
        primitive = hitPrimitive;
    }

    /// <inheritdoc/>
    public override void Occlude(int from, int to, in Vec3W origin, in Vec3W direction, in FloatW distance, int skip, ref MaskW free)
    {
        Vec3W o = origin;
        Vec3W d = direction;
        FloatW end = distance;
        MaskW open = free;
        int skipped = skip - FirstPrimitive;
        float* q = Table + ((long)from * Constants);
        for (int i = from; i < to; i++, q += Constants)
        {
            if (i == skipped)
            {
                continue;
            }

            // Something is in the way where the ends of the segment lie on different sides: no division.
            var normal = new Vec3W(q[0], q[1], q[2]);
            FloatW height = Vec3W.Dot(normal, o) - q[3];
            FloatW climb = Vec3W.Dot(normal, d);
            MaskW crossed = height * FloatW.MultiplyAdd(climb, end, height) < 0f;
            Outline outline = *(Outline*)(q + OutlineBits);
            if (outline != Outline.None && (crossed & open).Any)
            {
                crossed &= IsWithin(outline, q, Vec3W.NegatedMultiplyAdd(d, height / climb, o));
            }

            open = open.Except(crossed);
        }

        free = open;
    }

    /// <inheritdoc/>
    public override void Describe(in PrimitiveIndex primitives, bool needsUv, ref SurfaceW surface)
    {
        surface.Normal = primitives.ReadVector(Table, 0);
        FloatW height = Vec3W.Dot(surface.Normal, surface.Point) - primitives.Read(Table, 3);
        surface.Point = Vec3W.NegatedMultiplyAdd(surface.Normal, height, surface.Point);
        Vec3W p = surface.Point;

        // Near the world's origin, the height that was taken off may be more than what is left.
        FloatW largest = FloatW.Max(FloatW.Abs(p.X), FloatW.Max(FloatW.Abs(p.Y), FloatW.Abs(p.Z)));
        surface.Offset = (largest + FloatW.Abs(height)) * RayOffset.Relative;
        if (needsUv)
        {
            surface.U = AffineMap.Apply(primitives, Table, MapU, p);
            surface.V = AffineMap.Apply(primitives, Table, MapV, p);
        }
    }

    /// <inheritdoc/>
    public override void DescribeTangents(in PrimitiveIndex primitives, ref SurfaceW surface)
    {
        // What changes v by nothing, and u by 1; and the other way round.
        Vec3W u = primitives.ReadVector(Table, MapU);
        Vec3W v = primitives.ReadVector(Table, MapV);
        Vec3W keepsV = Vec3W.Cross(v, surface.Normal);
        Vec3W keepsU = Vec3W.Cross(surface.Normal, u);
        surface.AlongU = keepsV * (1f / Vec3W.Dot(u, keepsV));
        surface.AlongV = keepsU * (1f / Vec3W.Dot(v, keepsU));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static MaskW IsWithin(Outline outline, float* q, Vec3W p)
    {
        FloatW first = AffineMap.Apply(q + First, p);
        FloatW second = AffineMap.Apply(q + Second, p);
        if (outline == Outline.Disk)
        {
            return FloatW.MultiplyAdd(first, first, second * second) <= 1f;
        }

        MaskW positive = (first >= 0f) & (second >= 0f);
        return outline == Outline.Triangle ? positive & (first + second <= 1f) : positive & (first <= 1f) & (second <= 1f);
    }
}
