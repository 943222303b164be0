using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>
/// The watertight test of rays and triangles (Woop, Benthin &amp; Wald 2013), eight at a time: one ray and eight triangles, or eight rays and one
/// triangle. Corners are moved to the ray's start and sheared, so that the ray runs along an axis; whether it passes an edge on the left is
/// then a sign that the neighbour across the edge computes from the same numbers. Signs are exact, so a ray that meets a closed surface
/// cannot slip through.
/// </summary>
/// <typeparam name="TLanes">What the lanes stand for.</typeparam>
internal static unsafe class TriangleTest<TLanes>
    where TLanes : ILanes
{
    /// <summary>
    /// Looks where rays run through triangles, forwards or backwards. For any hit, <c>sure</c> receives the lanes that are hits in any case, so that no
    /// distance need be computed.
    /// </summary>
    /// <returns>The lanes that pass. It may be one too many: edge functions that are zero after rounding are settled by
    /// <see cref="Distance"/>.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Candidates<TSearch>(
        Vector256<float> ax, Vector256<float> bx, Vector256<float> cx, Vector256<float> ay, Vector256<float> by, Vector256<float> cy,
        Vector256<float> az, Vector256<float> bz, Vector256<float> cz,
        float* originX, float* originY, float* originZ, RayBlock* rays, int lane, out uint sure)
        where TSearch : ISearch
    {
        Vector256<float> origin = TLanes.OfRay(originZ + lane);
        az -= origin;
        bz -= origin;
        cz -= origin;
        origin = TLanes.OfRay(originX + lane);
        Vector256<float> shear = TLanes.OfRay(rays->ShearX + lane);
        ax = Lanes8.NegatedMultiplyAdd(shear, az, ax - origin);
        bx = Lanes8.NegatedMultiplyAdd(shear, bz, bx - origin);
        cx = Lanes8.NegatedMultiplyAdd(shear, cz, cx - origin);
        origin = TLanes.OfRay(originY + lane);
        shear = TLanes.OfRay(rays->ShearY + lane);
        ay = Lanes8.NegatedMultiplyAdd(shear, az, ay - origin);
        by = Lanes8.NegatedMultiplyAdd(shear, bz, by - origin);
        cy = Lanes8.NegatedMultiplyAdd(shear, cz, cy - origin);
        Vector256<float> u = Edge(cx, by, cy, bx);
        Vector256<float> v = Edge(ax, cy, ay, cx);
        Vector256<float> w = Edge(bx, ay, by, ax);
        Vector256<float> least = Lanes8.Min(Lanes8.Min(u, v), w);
        Vector256<float> most = Lanes8.Max(Lanes8.Max(u, v), w);
        Vector256<float> zero = Vector256<float>.Zero;
        uint candidates = Lanes8.Bits(Vector256.GreaterThanOrEqual(least, zero) | Vector256.LessThanOrEqual(most, zero));
        sure = 0;
        if (TSearch.EndsAtAnyHit && candidates != 0)
        {
            // No edge function is zero, and all of the triangle lies between the ray's start and its limit.
            Vector256<float> scale = TLanes.OfRay(rays->Scale + lane);
            Vector256<float> limit = TLanes.OfRay(rays->Distance + lane) * 0.9999f;
            az *= scale;
            bz *= scale;
            cz *= scale;
            sure = Lanes8.Bits((Vector256.GreaterThan(least, zero) | Vector256.LessThan(most, zero))
                & Vector256.GreaterThan(Lanes8.Min(Lanes8.Min(az, bz), cz), zero)
                & Vector256.LessThan(Lanes8.Max(Lanes8.Max(az, bz), cz), limit));
        }

        return candidates;
    }

    /// <summary>
    /// The distances of hits: the corners' distances along the axis, weighted. They are held within the limits that the triangle's own box sets, since
    /// the weights of a needle are mostly rounding; so a hit never lies before the entry into a box around the triangle, and whether
    /// a box is skipped because of a nearer hit cannot change which hit is found.
    /// </summary>
    /// <returns>Distances; NaN where there is no hit.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Distance(float* rows, int stride, RayBlock* rays, int lane, int major)
    {
        int minorX = TriangleLeaf.MinorX(major);
        int minorY = TriangleLeaf.MinorY(major);
        Vector256<float> origin = TLanes.OfRay(rays->Origin + (RayBlock.Size * major) + lane);
        float* row = rows + ((nint)major * stride);
        Vector256<float> az = TLanes.OfTriangle(row) - origin;
        Vector256<float> bz = TLanes.OfTriangle(row + (3 * (nint)stride)) - origin;
        Vector256<float> cz = TLanes.OfTriangle(row + (6 * (nint)stride)) - origin;
        ShearTo(rows, stride, rays, lane, minorX, rays->ShearX, az, bz, cz, out Vector256<float> ax, out Vector256<float> bx, out Vector256<float> cx);
        ShearTo(rows, stride, rays, lane, minorY, rays->ShearY, az, bz, cz, out Vector256<float> ay, out Vector256<float> by, out Vector256<float> cy);
        Vector256<float> u = Edge(cx, by, cy, bx);
        Vector256<float> v = Edge(ax, cy, ay, cx);
        Vector256<float> w = Edge(bx, ay, by, ax);
        Vector256<float> zero = Vector256<float>.Zero;
        Vector256<float> hit = SameSign(u, v, w);
        Vector256<float> doubtful = hit & (Vector256.Equals(u, zero) | Vector256.Equals(v, zero) | Vector256.Equals(w, zero));
        if (doubtful != zero)
        {
            (u, v, w, hit) = Settle(u, v, w, hit, doubtful, ax, ay, bx, by, cx, cy);
        }

        Vector256<float> inverse = Vector256<float>.One / ((u + v) + w);
        Vector256<float> depth = Lanes8.MultiplyAdd(w * inverse, cz, Lanes8.MultiplyAdd(v * inverse, bz, u * inverse * az));
        Vector256<float> distance = depth * TLanes.OfRay(rays->Scale + lane);
        distance = Clamp(distance, rows, stride, rays, lane, minorX);
        distance = Clamp(distance, rows, stride, rays, lane, minorY);
        return Vector256.ConditionalSelect(hit, distance, Vector256.Create(float.NaN));
    }

    /// <summary>Moves corners to where the ray is the axis.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void ShearTo(
        float* rows, int stride, RayBlock* rays, int lane, int minor, float* shears, Vector256<float> az, Vector256<float> bz, Vector256<float> cz,
        out Vector256<float> a, out Vector256<float> b, out Vector256<float> c)
    {
        float* row = rows + ((nint)minor * stride);
        Vector256<float> origin = TLanes.OfRay(rays->Origin + (RayBlock.Size * minor) + lane);
        Vector256<float> shear = TLanes.OfRay(shears + lane);
        a = Lanes8.NegatedMultiplyAdd(shear, az, TLanes.OfTriangle(row) - origin);
        b = Lanes8.NegatedMultiplyAdd(shear, bz, TLanes.OfTriangle(row + (3 * (nint)stride)) - origin);
        c = Lanes8.NegatedMultiplyAdd(shear, cz, TLanes.OfTriangle(row + (6 * (nint)stride)) - origin);
    }

    /// <summary>
    /// An edge function: twice the signed area between the ray and an edge. No fused operation: it would round one product only, and
    /// an edge's two triangles would disagree.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Edge(Vector256<float> a, Vector256<float> b, Vector256<float> c, Vector256<float> d) => (a * b) - (c * d);

    /// <summary>
    /// Returns the lanes in which no two have opposite signs. Rounding is monotonic, so that a sign that differs from zero is right.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> SameSign(Vector256<float> u, Vector256<float> v, Vector256<float> w) =>
        Vector256.GreaterThanOrEqual(Lanes8.Min(Lanes8.Min(u, v), w), Vector256<float>.Zero)
        | Vector256.LessThanOrEqual(Lanes8.Max(Lanes8.Max(u, v), w), Vector256<float>.Zero);

    /// <summary>Holds a distance between the sides of a triangle's box along one minor axis; NaN stays.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Clamp(Vector256<float> distance, float* rows, int stride, RayBlock* rays, int lane, int minor)
    {
        float* row = rows + ((nint)minor * stride);
        Vector256<float> origin = TLanes.OfRay(rays->Origin + (RayBlock.Size * minor) + lane);
        Vector256<float> inverse = TLanes.OfRay(rays->Inverse + (RayBlock.Size * minor) + lane);
        Vector256<float> margin = TLanes.OfRay(rays->Slack + lane) * Vector256.Abs(inverse);
        Vector256<float> a = (TLanes.OfTriangle(row) - origin) * inverse;
        Vector256<float> b = (TLanes.OfTriangle(row + (3 * (nint)stride)) - origin) * inverse;
        Vector256<float> c = (TLanes.OfTriangle(row + (6 * (nint)stride)) - origin) * inverse;
        Vector256<float> near = Lanes8.Min(Lanes8.Min(a, b), c) - margin;
        Vector256<float> far = Lanes8.Max(Lanes8.Max(a, b), c) + margin;
        return Lanes8.Max(near, Lanes8.Min(far, distance));
    }

    /// <summary>Settles the lanes in which an edge function is zero, in double precision, where its sign is exact.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static (Vector256<float> U, Vector256<float> V, Vector256<float> W, Vector256<float> Hit) Settle(
        Vector256<float> u, Vector256<float> v, Vector256<float> w, Vector256<float> hit, Vector256<float> doubtful,
        Vector256<float> ax, Vector256<float> ay, Vector256<float> bx, Vector256<float> by, Vector256<float> cx, Vector256<float> cy)
    {
        var (lowerU, upperU) = ExactEdge(cx, by, cy, bx);
        var (lowerV, upperV) = ExactEdge(ax, cy, ay, cx);
        var (lowerW, upperW) = ExactEdge(bx, ay, by, ax);
        Vector256<float> exact = Vector256.Narrow(SameSign(lowerU, lowerV, lowerW), SameSign(upperU, upperV, upperW)).AsSingle();
        return (
            Vector256.ConditionalSelect(doubtful, Vector256.Narrow(lowerU, upperU), u),
            Vector256.ConditionalSelect(doubtful, Vector256.Narrow(lowerV, upperV), v),
            Vector256.ConditionalSelect(doubtful, Vector256.Narrow(lowerW, upperW), w),
            Vector256.ConditionalSelect(doubtful, exact, hit));
    }

    private static (Vector256<double> Lower, Vector256<double> Upper) ExactEdge(Vector256<float> a, Vector256<float> b, Vector256<float> c, Vector256<float> d) =>
        ((Vector256.WidenLower(a) * Vector256.WidenLower(b)) - (Vector256.WidenLower(c) * Vector256.WidenLower(d)),
         (Vector256.WidenUpper(a) * Vector256.WidenUpper(b)) - (Vector256.WidenUpper(c) * Vector256.WidenUpper(d)));

    private static Vector256<long> SameSign(Vector256<double> u, Vector256<double> v, Vector256<double> w)
    {
        Vector256<double> zero = Vector256<double>.Zero;
        Vector256<double> left = Vector256.GreaterThanOrEqual(u, zero) & Vector256.GreaterThanOrEqual(v, zero) & Vector256.GreaterThanOrEqual(w, zero);
        Vector256<double> right = Vector256.LessThanOrEqual(u, zero) & Vector256.LessThanOrEqual(v, zero) & Vector256.LessThanOrEqual(w, zero);
        return (left | right).AsInt64();
    }
}
