namespace RayTracer.Testing;

/// <summary>
/// Tests whether points are uniform in the unit square. Any distribution is tested so once its own map back to the square is
/// known (Rosenblatt 1952): no density has to be integrated.
/// </summary>
public sealed class UnitSquareCounts
{
    /// <summary>Cells along each side.</summary>
    public const int Side = 24;

    // What rounding may carry over the border.
    private const double Border = 1e-4;
    private readonly double[] _counts = new double[Side * Side];
    private int _outside;

    /// <summary>Counts a point.</summary>
    public void Add(double s, double t)
    {
        if (s is >= -Border and <= 1 + Border && t is >= -Border and <= 1 + Border)
        {
            _counts[(Cell(t) * Side) + Cell(s)]++;
        }
        else
        {
            _outside++;
        }
    }

    /// <summary>Probability of deviations as large as those seen; 0 if any point lay outside.</summary>
    public double P()
    {
        double expected = _counts.Sum() / (Side * Side);
        return _outside > 0 ? 0 : PValues.ChiSquared(_counts, [.. Enumerable.Repeat(expected, Side * Side)]);
    }

    private static int Cell(double x) => Math.Clamp((int)(x * Side), 0, Side - 1);
}
