using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>
/// The watertight test of rays and triangles (Woop, Benthin &amp; Wald 2013), eight at a time: one ray and eight triangles, or eight rays and one
/// triangle. Corners are moved to the ray's start and sheared, so that the ray runs along an axis; whether it passes an edge on the left is
/// then a sign that the neighbour across the edge computes from the same numbers. Signs are exact, so a ray that meets a closed surface cannot slip through.
/// </summary>
internal static class TriangleTest
{
    /// <summary>Moves corners to where the ray is the axis.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Shear(Vector256<float> minor, Vector256<float> shear, Vector256<float> major) =>
        Lanes8.NegatedMultiplyAdd(shear, major, minor);

    /// <summary>The edge functions of sheared corners: twice the signed areas of the triangles between the ray and each edge.</summary>
    /// <returns>Where none has another sign than another. Products are rounded, so a zero says nothing yet.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Edges(
        Vector256<float> ax, Vector256<float> ay, Vector256<float> bx, Vector256<float> by, Vector256<float> cx, Vector256<float> cy,
        out Vector256<float> u, out Vector256<float> v, out Vector256<float> w)
    {
        // No fused operations: they would round the two products differently, and an edge's two triangles would disagree.
        u = (cx * by) - (cy * bx);
        v = (ax * cy) - (ay * cx);
        w = (bx * ay) - (by * ax);
        return Vector256.GreaterThanOrEqual(Lanes8.Min(Lanes8.Min(u, v), w), Vector256<float>.Zero)
            | Vector256.LessThanOrEqual(Lanes8.Max(Lanes8.Max(u, v), w), Vector256<float>.Zero);
    }

    /// <summary>Settles the lanes in which an edge function is zero, in double precision, where its sign is exact.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Settle(
        Vector256<float> hit,
        Vector256<float> ax, Vector256<float> ay, Vector256<float> bx, Vector256<float> by, Vector256<float> cx, Vector256<float> cy,
        ref Vector256<float> u, ref Vector256<float> v, ref Vector256<float> w)
    {
        Vector256<float> zero = Vector256<float>.Zero;
        Vector256<float> doubtful = hit & (Vector256.Equals(u, zero) | Vector256.Equals(v, zero) | Vector256.Equals(w, zero));
        return doubtful == zero ? hit : SettleExactly(hit, doubtful, ax, ay, bx, by, cx, cy, ref u, ref v, ref w);
    }

    /// <summary>
    /// The distance of a hit: the corners' distances along the axis, weighted. It is held within the limits that the triangle's own box sets, since
    /// the weights of a needle are mostly rounding; so it never lies before the entry into a box around the triangle, and whether
    /// a box is skipped because of a nearer hit cannot change which hit is found.
    /// </summary>
    /// <param name="u">Edge functions, of any sign.</param>
    /// <param name="v">Edge functions, of any sign.</param>
    /// <param name="w">Edge functions, of any sign.</param>
    /// <param name="az">Corners relative to the ray's start, along the major axis.</param>
    /// <param name="bz">Corners relative to the ray's start, along the major axis.</param>
    /// <param name="cz">Corners relative to the ray's start, along the major axis.</param>
    /// <param name="scale">Inverse direction along the major axis.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Distance(
        Vector256<float> u, Vector256<float> v, Vector256<float> w, Vector256<float> az, Vector256<float> bz, Vector256<float> cz, Vector256<float> scale)
    {
        Vector256<float> inverse = Vector256<float>.One / ((u + v) + w);
        Vector256<float> depth = Lanes8.MultiplyAdd(w * inverse, cz, Lanes8.MultiplyAdd(v * inverse, bz, u * inverse * az));
        return depth * scale;
    }

    /// <summary>Holds a distance between a triangle's box's sides of one minor axis.</summary>
    /// <param name="distance">The distance; NaN stays.</param>
    /// <param name="a">Corners relative to the ray's start, not sheared.</param>
    /// <param name="b">Corners relative to the ray's start, not sheared.</param>
    /// <param name="c">Corners relative to the ray's start, not sheared.</param>
    /// <param name="inverse">Inverse direction.</param>
    /// <param name="slack">By how much the box is enlarged.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Clamp(
        Vector256<float> distance, Vector256<float> a, Vector256<float> b, Vector256<float> c, Vector256<float> inverse, Vector256<float> slack)
    {
        Vector256<float> margin = slack * Vector256.Abs(inverse);
        Vector256<float> ta = a * inverse;
        Vector256<float> tb = b * inverse;
        Vector256<float> tc = c * inverse;
        Vector256<float> near = Lanes8.Min(Lanes8.Min(ta, tb), tc) - margin;
        Vector256<float> far = Lanes8.Max(Lanes8.Max(ta, tb), tc) + margin;
        return Lanes8.Max(near, Lanes8.Min(far, distance));
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Vector256<float> SettleExactly(
        Vector256<float> hit, Vector256<float> doubtful,
        Vector256<float> ax, Vector256<float> ay, Vector256<float> bx, Vector256<float> by, Vector256<float> cx, Vector256<float> cy,
        ref Vector256<float> u, ref Vector256<float> v, ref Vector256<float> w)
    {
        var (lowerU, upperU) = ExactEdge(cx, by, cy, bx);
        var (lowerV, upperV) = ExactEdge(ax, cy, ay, cx);
        var (lowerW, upperW) = ExactEdge(bx, ay, by, ax);
        Vector256<float> exact = Vector256.Narrow(SameSign(lowerU, lowerV, lowerW), SameSign(upperU, upperV, upperW)).AsSingle();
        u = Vector256.ConditionalSelect(doubtful, Vector256.Narrow(lowerU, upperU), u);
        v = Vector256.ConditionalSelect(doubtful, Vector256.Narrow(lowerV, upperV), v);
        w = Vector256.ConditionalSelect(doubtful, Vector256.Narrow(lowerW, upperW), w);
        return Vector256.ConditionalSelect(doubtful, exact, hit);
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
