using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// All planes of a scene. A plane's entry is n and d of n·p = d, then two affine maps from a
/// point to u and to v; a rectangle is where both lie between 0 and 1.
/// </summary>
internal sealed unsafe class PlaneBatch : ShapeBatch
{
    private const int Constants = 14;
    private const int MapU = 4;
    private const int MapV = 8;
    private const int OffsetScale = 12;
    private readonly int[] _isBounded;

    public PlaneBatch(IReadOnlyList<Shape> shapes)
        : base(shapes.Count, Constants)
    {
        _isBounded = new int[shapes.Count];
        for (int i = 0; i < shapes.Count; i++)
        {
            var plane = (Plane)shapes[i];
            float* q = Table + (i * Constants);
            q[0] = plane.Normal.X;
            q[1] = plane.Normal.Y;
            q[2] = plane.Normal.Z;
            q[3] = plane.Normal.Dot(plane.Point);
            System.Numerics.Vector2 size = plane.Size ?? System.Numerics.Vector2.One;
            float center = plane.Size is null ? 0 : 0.5f;
            AffineMap.Write(q + MapU, plane.Tangent * (1 / size.X), plane.Point, center);
            AffineMap.Write(q + MapV, plane.Bitangent * (1 / size.Y), plane.Point, center);
            q[OffsetScale] = plane.Point.Norm();
            _isBounded[i] = plane.Size is null ? 0 : 1;
        }
    }

    /// <inheritdoc/>
    public override void ClosestHit(in Vec3W origin, in Vec3W direction, ref FloatW distance, ref UIntW primitive)
    {
        Vec3W o = origin;
        Vec3W d = direction;
        FloatW nearest = distance;
        UIntW hitPrimitive = primitive;
        float* q = Table;
        for (int i = 0; i < Count; i++, q += Constants)
        {
            var normal = new Vec3W(q[0], q[1], q[2]);
            FloatW t = (q[3] - Vec3W.Dot(normal, o)) / Vec3W.Dot(normal, d);
            MaskW hit = (t > 0f) & (t < nearest);
            if (_isBounded[i] != 0)
            {
                hit &= IsInRectangle(q, Vec3W.MultiplyAdd(d, t, o));
            }

            nearest = hit.Select(t, nearest);
            hitPrimitive = hit.Select((uint)(FirstPrimitive + i), hitPrimitive);
        }

        distance = nearest;
        primitive = hitPrimitive;
    }

    /// <inheritdoc/>
    public override void Occlude(in Vec3W origin, in Vec3W direction, in FloatW distance, int skip, ref MaskW free)
    {
        Vec3W o = origin;
        Vec3W d = direction;
        FloatW end = distance;
        MaskW open = free;
        int skipped = skip - FirstPrimitive;
        float* q = Table;
        for (int i = 0; i < Count; i++, q += Constants)
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
            if (_isBounded[i] != 0 && (crossed & open).Any)
            {
                crossed &= IsInRectangle(q, Vec3W.NegatedMultiplyAdd(d, height / climb, o));
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
        surface.Offset = FlatSurface.Offset(surface.Point, primitives.Read(Table, OffsetScale));
        if (needsUv)
        {
            surface.U = AffineMap.Apply(primitives, Table, MapU, surface.Point);
            surface.V = AffineMap.Apply(primitives, Table, MapV, surface.Point);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static MaskW IsInRectangle(float* q, in Vec3W p)
    {
        FloatW u = AffineMap.Apply(q + MapU, p);
        FloatW v = AffineMap.Apply(q + MapV, p);
        return (u >= 0f) & (u <= 1f) & (v >= 0f) & (v <= 1f);
    }
}
