using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// Meets cylinders, cones and frusta with rays. In the local frame, whose origin is the middle of the axis, the side is
/// F = x² + y² − w² = 0 with the radius w = w₀ + k·z, and inside F is negative. A ray is in the solid between the later of its entries
/// into cone and slab and the earlier of its exits, so that edges have no cracks.
/// </summary>
/// <remarks>
/// Along a ray, F is the square of a vector (x, y, w) in a metric that counts w² negatively, and its discriminant is, by Lagrange's
/// identity, made of the areas that this vector spans with its direction: no cancellation but that of a ray that touches. The roots
/// are q/a and c/q, where c = F(origin): its sign alone says whether the ray starts inside, and then it meets the surface. Rays from
/// afar are first moved near the shape. On errors along the normal, see <see cref="RayOffset"/>.
/// </remarks>
internal readonly unsafe struct ConicalKernel : IShapeKernel
{
    private const int Half = 12;
    private const int Middle = 13;
    private const int Slope = 14;
    private const int Reach = 15;
    private const int Caps = 16;
    private const int Offset = 17;
    private const int Cosine = 18;
    private const int Lowest = 19;
    private const int Highest = 20;
    private const int BottomCap = 21;
    private const int TopCap = 22;
    private const int BottomRadius = 23;
    private const int TopRadius = 24;

    public static int Constants => 25;

    public static void Pack(Shape shape, float* entry)
    {
        var s = (ConicalShape)shape;
        s.Frame.Write(entry);
        float half = 0.5f * s.Height;
        float slope = (s.TopRadius - s.Radius) / s.Height;
        float reach = new Vector3(half, float.Max(s.Radius, s.TopRadius), 0).Norm();
        float offset = (Vector3.Abs(s.Frame.Origin).Largest() + reach) * RayOffset.Relative;
        float cosine = 1 / new Vector3(slope, 1, 0).Norm();
        entry[Half] = half;
        entry[Middle] = 0.5f * (s.Radius + s.TopRadius);
        entry[Slope] = slope;
        entry[Reach] = 1.125f * reach;
        entry[Caps] = s.HasCaps ? 1 : 0;
        entry[Offset] = offset;
        entry[Cosine] = cosine;

        // Described points keep away from the edges, and from where both sides are less than two offsets apart: rays that go inside start
        // inside.
        float margin = 2 * offset / cosine;
        float toAxis = slope == 0 ? float.PositiveInfinity : (entry[Middle] - margin) / float.Abs(slope);
        entry[Lowest] = float.Max(-half + (2 * offset), slope > 0 ? -toAxis : float.NegativeInfinity);
        entry[Highest] = float.Min(half - (2 * offset), slope < 0 ? toAxis : float.PositiveInfinity);

        // A height where there is no cap.
        entry[BottomCap] = s.HasCaps && s.Radius > margin ? -half : float.NegativeInfinity;
        entry[TopCap] = s.HasCaps && s.TopRadius > margin ? half : float.PositiveInfinity;
        entry[BottomRadius] = s.Radius;
        entry[TopRadius] = s.TopRadius;
    }

    public static FloatW Meet(float* q, in Vec3W origin, in Vec3W direction)
    {
        Vec3W o = LocalFrame.PointToLocal(q, origin);
        Vec3W d = LocalFrame.ToLocal(q, direction);
        FloatW start = FloatW.Max(-Vec3W.Dot(o, d) - q[Reach], 0f);
        o = Vec3W.MultiplyAdd(d, start, o);
        MeetSide(q, o, d, out FloatW sideNear, out FloatW sideFar);

        // The slab between the ends; parallel to it, all or nothing.
        FloatW a = (-q[Half] - o.Z) / d.Z;
        FloatW b = (q[Half] - o.Z) / d.Z;
        FloatW slabNear = FloatW.Min(a, b);
        FloatW slabFar = FloatW.Max(a, b);
        FloatW near = FloatW.Max(sideNear, slabNear);
        FloatW far = FloatW.Min(sideFar, slabFar);
        MaskW hits = near <= far;
        MaskW enters = near > 0f;
        if (q[Caps] == 0)
        {
            // What is left of the surface is where a ray enters or leaves through the side.
            enters &= sideNear >= slabNear;
            hits &= enters | (sideFar <= slabFar);
        }

        return hits.Select(start + enters.Select(near, far), float.NaN);
    }

    public static void Describe(in PrimitiveIndex primitives, float* table, bool needsUv, ref SurfaceW surface)
    {
        LocalFrameW frame = new(primitives, table);
        Vec3W p = frame.PointToLocal(surface.Point);
        FloatW slope = primitives.Read(table, Slope);
        FloatW cosine = primitives.Read(table, Cosine);
        FloatW middle = primitives.Read(table, Middle);
        FloatW distance = FloatW.Sqrt(FloatW.MultiplyAdd(p.X, p.X, p.Y * p.Y));
        MaskW onAxis = distance <= 0f;
        FloatW x = onAxis.Select(0f, p.X / distance);
        FloatW y = onAxis.Select(1f, p.Y / distance);

        // Of side, bottom and top, the one that the point is farthest outside of, or least far inside.
        FloatW outside = distance - FloatW.MultiplyAdd(slope, p.Z, middle);
        FloatW aboveTop = p.Z - primitives.Read(table, TopCap);
        FloatW belowBottom = primitives.Read(table, BottomCap) - p.Z;
        MaskW isTop = (aboveTop > outside * cosine) & (aboveTop > belowBottom);
        MaskW isBottom = (belowBottom > outside * cosine).Except(isTop);
        MaskW isSide = ~(isTop | isBottom);
        FloatW sign = isTop.Select(1f, -1f);

        FloatW foot = FloatW.MultiplyAdd(slope * cosine * cosine, outside, p.Z);
        FloatW height = FloatW.Max(primitives.Read(table, Lowest), FloatW.Min(primitives.Read(table, Highest), foot));
        surface.Offset = primitives.Read(table, Offset);
        FloatW capRadius = isTop.Select(primitives.Read(table, TopRadius), primitives.Read(table, BottomRadius));
        FloatW onCap = FloatW.Max(FloatW.Min(distance, capRadius - (2f * surface.Offset / cosine)), 0f);
        FloatW radius = isSide.Select(FloatW.MultiplyAdd(slope, height, middle), onCap);
        FloatW half = primitives.Read(table, Half);
        surface.Point = frame.PointToWorld(new(x * radius, y * radius, isSide.Select(height, sign * half)));
        surface.Normal = frame.ToWorld(new(
            isSide.Select(x * cosine, 0f), isSide.Select(y * cosine, 0f), isSide.Select(-slope * cosine, sign)));
        if (needsUv)
        {
            CapUv(x * radius / capRadius, y * radius / capRadius, sign, out FloatW capU, out FloatW capV);
            surface.U = isSide.Select(LocalFrame.Turn(new(x, y, 0f)), capU);
            surface.V = isSide.Select(FloatW.MultiplyAdd(height / half, 0.5f, 0.5f), capV);
        }
    }

    /// <inheritdoc/>
    public static void DescribeTangents(in PrimitiveIndex primitives, float* table, ref SurfaceW surface)
    {
        LocalFrameW frame = new(primitives, table);
        Vec3W p = frame.PointToLocal(surface.Point);
        Vec3W n = frame.ToLocal(surface.Normal);
        MaskW isCap = FloatW.MultiplyAdd(n.X, n.X, n.Y * n.Y) < 1e-10f;
        FloatW capRadius = (n.Z > 0f).Select(primitives.Read(table, TopRadius), primitives.Read(table, BottomRadius));
        FloatW sign = FloatW.CopySign(1f, n.Z);
        FloatW distance = FloatW.Sqrt(FloatW.MultiplyAdd(p.X, p.X, p.Y * p.Y));
        FloatW slope = primitives.Read(table, Slope) / distance;
        Vec3W around = new Vec3W(p.Y, -p.X, 0f) * (2f * float.Pi);
        Vec3W upwards = new Vec3W(p.X * slope, p.Y * slope, 1f) * (primitives.Read(table, Half) * 2f);
        surface.AlongU = frame.ToWorld(isCap.Select(new Vec3W(capRadius * sign * 2f, 0f, 0f), around));
        surface.AlongV = frame.ToWorld(isCap.Select(new Vec3W(0f, capRadius * -2f, 0f), upwards));
    }

    /// <summary>uv on a cap, of a point given in radii: as on the level disk that it is where the shape is upright.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void CapUv(FloatW x, FloatW y, FloatW sign, out FloatW u, out FloatW v)
    {
        u = FloatW.MultiplyAdd(x * sign, 0.5f, 0.5f);
        v = FloatW.MultiplyAdd(y, -0.5f, 0.5f);
    }

    // Where rays enter and leave the infinite cone.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void MeetSide(float* q, in Vec3W o, in Vec3W d, out FloatW near, out FloatW far)
    {
        FloatW w = FloatW.MultiplyAdd(o.Z, q[Slope], q[Middle]);
        FloatW dw = d.Z * q[Slope];
        FloatW a = FloatW.MultiplyAdd(d.X, d.X, FloatW.MultiplyAdd(d.Y, d.Y, -(dw * dw)));
        FloatW b = FloatW.MultiplyAdd(o.X, d.X, FloatW.MultiplyAdd(o.Y, d.Y, -(w * dw)));
        FloatW c = FloatW.MultiplyAdd(o.X, o.X, FloatW.MultiplyAdd(o.Y, o.Y, -(w * w)));
        FloatW alongX = Determinant(o.X, dw, w, d.X);
        FloatW alongY = Determinant(o.Y, dw, w, d.Y);
        FloatW around = Determinant(o.X, d.Y, o.Y, d.X);
        FloatW discriminant = FloatW.MultiplyAdd(alongX, alongX, FloatW.NegatedMultiplyAdd(around, around, alongY * alongY));

        FloatW root = FloatW.Sqrt(FloatW.Max(discriminant, 0f));
        FloatW sum = -(b + FloatW.CopySign(root, b));
        FloatW first = FloatW.Min(sum / a, c / sum);
        FloatW last = FloatW.Max(sum / a, c / sum);

        first = Refine(first, a, o, d, w, dw);
        last = Refine(last, a, o, d, w, dw);

        // A ray steeper than the cone is inside before it passes the apex's level, or after: on the other side lies the mirror image.
        MaskW shallow = a >= 0f;
        MaskW rises = (dw > 0f).Except(shallow);
        near = shallow.Select(first, rises.Select(last, float.NegativeInfinity));
        far = shallow.Select(last, rises.Select(float.PositiveInfinity, first));

        // Along the side of a cylinder there are no roots; and what starts inside is inside, other than in the mirror image.
        MaskW inside = (c < 0f) & (w > 0f);
        MaskW parallel = (sum >= 0f) & (sum <= 0f);
        near = (inside & (parallel | (near >= 0f))).Select(float.NegativeInfinity, near);
        far = (inside & (parallel | (far <= 0f))).Select(float.PositiveInfinity, far);
        MaskW misses = (parallel | (shallow & (discriminant < 0f))).Except(inside);
        near = misses.Select(float.PositiveInfinity, near);
    }

    // A step of Newton's method, from F at the point itself: near an apex, where the radius is small, the sums of roots that start far away are
    // too coarse. Not where the ray all but touches and the step might lead elsewhere, nor to the other side of the start.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Refine(FloatW t, FloatW a, in Vec3W o, in Vec3W d, FloatW w, FloatW dw)
    {
        FloatW x = FloatW.MultiplyAdd(d.X, t, o.X);
        FloatW y = FloatW.MultiplyAdd(d.Y, t, o.Y);
        FloatW radius = FloatW.MultiplyAdd(dw, t, w);
        FloatW value = FloatW.MultiplyAdd(x, x, FloatW.MultiplyAdd(y, y, -(radius * radius)));
        FloatW halfSlope = FloatW.MultiplyAdd(x, d.X, FloatW.MultiplyAdd(y, d.Y, -(radius * dw)));
        FloatW step = value / (2f * halfSlope);
        FloatW refined = t - step;
        return ((FloatW.Abs(a * step) < 0.5f * FloatW.Abs(halfSlope)) & (refined * t > 0f)).Select(refined, t);
    }

    // a·b − c·d, wrong by 1.5 ulp at most (Kahan's algorithm: Jeannerod, Louvet & Muller 2013).
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Determinant(FloatW a, FloatW b, FloatW c, FloatW d)
    {
        FloatW product = c * d;
        FloatW error = FloatW.NegatedMultiplyAdd(c, d, product);
        return FloatW.MultiplyAdd(a, b, -product) + error;
    }
}
