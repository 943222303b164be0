using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// All triangles of a scene. An entry is n and d of the plane n·p = d, the affine maps from a point to the barycentric
/// coordinates of the second and third corner (Wald 2004's idea of a precomputed projection, in three dimensions), and the
/// maps to u and v.
/// </summary>
internal sealed unsafe class TriangleBatch : ShapeBatch
{
    private const int Constants = 22;
    private const int MapB = 4;
    private const int MapC = 8;
    private const int MapU = 12;
    private const int MapV = 16;
    private const int OffsetScale = 20;

    public TriangleBatch(IReadOnlyList<Shape> shapes)
        : base(shapes.Count, Constants)
    {
        for (int i = 0; i < shapes.Count; i++)
        {
            var triangle = (Triangle)shapes[i];
            float* q = Table + (i * Constants);
            Vector3 n = triangle.Normal;
            Vector3 ab = triangle.B - triangle.A;
            Vector3 ac = triangle.C - triangle.A;
            q[0] = n.X;
            q[1] = n.Y;
            q[2] = n.Z;
            q[3] = n.Dot(triangle.A);

            // The gradient of a corner's coordinate is perpendicular to the opposite side, and 1 over its height long.
            Vector3 towardsB = ac.Cross(n);
            Vector3 towardsC = n.Cross(ab);
            Vector3 gradientB = towardsB * (1 / ab.Dot(towardsB));
            Vector3 gradientC = towardsC * (1 / ac.Dot(towardsC));
            AffineMap.Write(q + MapB, gradientB, triangle.A, 0);
            AffineMap.Write(q + MapC, gradientC, triangle.A, 0);
            (Vector2 uvA, Vector2 uvB, Vector2 uvC) = triangle.Uv;
            AffineMap.Write(q + MapU, gradientB * (uvB.X - uvA.X) + gradientC * (uvC.X - uvA.X), triangle.A, uvA.X);
            AffineMap.Write(q + MapV, gradientB * (uvB.Y - uvA.Y) + gradientC * (uvC.Y - uvA.Y), triangle.A, uvA.Y);
            q[OffsetScale] = triangle.A.Norm();
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
            MaskW hit = (t > 0f) & (t < nearest) & IsInTriangle(q, Vec3W.MultiplyAdd(d, t, o));
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

            var normal = new Vec3W(q[0], q[1], q[2]);
            FloatW height = Vec3W.Dot(normal, o) - q[3];
            FloatW climb = Vec3W.Dot(normal, d);
            MaskW crossed = height * FloatW.MultiplyAdd(climb, end, height) < 0f;
            if ((crossed & open).Any)
            {
                open = open.Except(crossed & IsInTriangle(q, Vec3W.NegatedMultiplyAdd(d, height / climb, o)));
            }
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
    private static MaskW IsInTriangle(float* q, in Vec3W p)
    {
        FloatW b = AffineMap.Apply(q + MapB, p);
        FloatW c = AffineMap.Apply(q + MapC, p);
        return (b >= 0f) & (c >= 0f) & (b + c <= 1f);
    }
}
