namespace RayTracer.Study;

/// <summary>
/// A curve a + b·f(n) that comes closest to points by the least sum of squared relative deviations: on logarithmic axes, where such
/// points are looked at, small values count as much as large ones.
/// </summary>
/// <param name="Constant">a.</param>
/// <param name="Factor">b.</param>
/// <param name="Growth">f.</param>
internal sealed record GrowthFit(double Constant, double Factor, Func<double, double> Growth)
{
    /// <summary>Fits.</summary>
    /// <param name="growth">f, not the same for all points.</param>
    /// <param name="points">At least two points; y is above 0.</param>
    public static GrowthFit Of(Func<double, double> growth, IReadOnlyList<(double X, double Y)> points)
    {
        // Minimum of Σ (1 − a·p − b·q)² with p = 1/y and q = f/y: two linear equations.
        double pp = 0, pq = 0, qq = 0, p1 = 0, q1 = 0;
        foreach ((double x, double y) in points)
        {
            double p = 1 / y;
            double q = growth(x) / y;
            pp += p * p;
            pq += p * q;
            qq += q * q;
            p1 += p;
            q1 += q;
        }

        double determinant = (pp * qq) - (pq * pq);
        return new(((p1 * qq) - (q1 * pq)) / determinant, ((q1 * pp) - (p1 * pq)) / determinant, growth);
    }

    /// <summary>The curve's value.</summary>
    public double At(double x) => Constant + (Factor * Growth(x));

    /// <summary>The largest deviation of a point from the curve, as a part of the curve's value.</summary>
    public double LargestDeviation(IReadOnlyList<(double X, double Y)> points) => points.Max(p => Math.Abs((p.Y / At(p.X)) - 1));
}
