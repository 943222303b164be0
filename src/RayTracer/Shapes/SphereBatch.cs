using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// All spheres of a scene: six constants each (centre, squared radius, radius, largest coordinate), one row after the other.
/// </summary>
internal sealed unsafe class SphereBatch : ShapeBatch
{
    private const int Constants = 6;
    private const int Radius2 = 3;
    private const int Radius = 4;
    private const int OffsetScale = 5;

    public SphereBatch(IReadOnlyList<Shape> shapes)
        : base(shapes.Count, Constants)
    {
        for (int i = 0; i < shapes.Count; i++)
        {
            var sphere = (Sphere)shapes[i];
            float* q = Table + (i * Constants);
            q[0] = sphere.Center.X;
            q[1] = sphere.Center.Y;
            q[2] = sphere.Center.Z;
            q[Radius2] = sphere.Radius * sphere.Radius;
            q[Radius] = sphere.Radius;
            q[OffsetScale] = Vector3.Abs(sphere.Center).Largest() + sphere.Radius;
        }
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
            // The ray's point nearest to the centre gives the discriminant without cancellation (Haines et al., Precision
            // improvements for ray/sphere intersection, Ray Tracing Gems 2019, eq. 7.5).
            Vec3W fromCenter = o - new Vec3W(q[0], q[1], q[2]);
            FloatW b = Vec3W.Dot(fromCenter, d);
            Vec3W perpendicular = Vec3W.NegatedMultiplyAdd(d, b, fromCenter);
            FloatW root = FloatW.Sqrt(q[Radius2] - Vec3W.Dot(perpendicular, perpendicular));
            FloatW near = -b - root;
            FloatW far = root - b;

            // Where the ray misses, the root is NaN and every comparison is false.
            FloatW t = (near > 0f).Select(near, far);
            MaskW hit = (t > 0f) & (t < nearest);
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

            // The segment's point nearest to the centre decides, without a root.
            Vec3W toCenter = new Vec3W(q[0], q[1], q[2]) - o;
            FloatW t = FloatW.Max(0f, FloatW.Min(end, Vec3W.Dot(toCenter, d)));
            Vec3W nearest = Vec3W.NegatedMultiplyAdd(d, t, toCenter);
            MaskW within = Vec3W.Dot(nearest, nearest) < q[Radius2];
            if ((within & open).Any)
            {
                // A segment that lies inside from end to end crosses nothing.
                Vec3W last = Vec3W.NegatedMultiplyAdd(d, end, toCenter);
                MaskW inside = (Vec3W.Dot(toCenter, toCenter) < q[Radius2]) & (Vec3W.Dot(last, last) < q[Radius2]);
                open = open.Except(within.Except(inside));
            }
        }

        free = open;
    }

    /// <inheritdoc/>
    public override void Describe(in PrimitiveIndex primitives, bool needsUv, ref SurfaceW surface)
    {
        Vec3W center = primitives.ReadVector(Table, 0);
        surface.Normal = Vec3W.Normalize(surface.Point - center);
        surface.Point = Vec3W.MultiplyAdd(surface.Normal, primitives.Read(Table, Radius), center);
        surface.Offset = primitives.Read(Table, OffsetScale) * RayOffset.Relative;
        if (needsUv)
        {
            Uv(surface.Normal, out surface.U, out surface.V);
        }
    }

    /// <inheritdoc/>
    public override void DescribeTangents(in PrimitiveIndex primitives, ref SurfaceW surface)
    {
        Vec3W n = surface.Normal;
        FloatW radius = primitives.Read(Table, Radius);
        FloatW ring = FloatW.Sqrt(FloatW.MultiplyAdd(n.X, n.X, n.Z * n.Z));
        surface.AlongU = new Vec3W(n.Z, 0f, -n.X) * (radius * (2f * float.Pi));
        surface.AlongV = new Vec3W(-n.Y * n.X / ring, ring, -n.Y * n.Z / ring) * (radius * float.Pi);
    }

    /// <summary>Longitude and latitude: u = ½ + atan2(x, z)/2π, v = acos(−y)/π.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Uv(in Vec3W normal, out FloatW u, out FloatW v)
    {
        u = FloatW.MultiplyAdd(LaneMath.Atan2(normal.X, normal.Z), 0.5f / float.Pi, 0.5f);
        v = LaneMath.Acos(FloatW.Max(-1f, FloatW.Min(1f, -normal.Y))) * (1 / float.Pi);
    }
}
