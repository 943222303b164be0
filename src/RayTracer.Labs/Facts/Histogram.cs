using System.Xml.Linq;

namespace RayTracer.Labs;

/// <summary>
/// Counts of samples in the cells of an area, and the counts that a density leads to expect there (Pearson 1900). It fails with a probability of about
/// 10⁻⁹ where nothing is wrong, whatever the seed.
/// </summary>
internal sealed class Histogram
{
    /// <summary>Standard deviations beyond which something is wrong: by chance that is one time in 10⁹.</summary>
    public const double MostDeviations = 6;

    // Cells of which fewer are expected are put together (Cochran 1954 has 5; the tail far out needs more).
    private const double LeastExpected = 10;
    private readonly Cells _cells;
    private readonly double[] _observed;
    private readonly double[] _expected;
    private readonly double[] _variances;
    private readonly double _samples;
    private readonly double _unit;

    private Histogram(Cells cells, double samples, double[] observed, double[] expected, double[] variances, double unit = 1)
    {
        (_cells, _samples, _observed, _expected, _variances, _unit) = (cells, samples, observed, expected, variances, unit);
        Deviation = ChiSquaredDeviation();
    }

    /// <summary>The integral of the density.</summary>
    public double Integral { get; private init; }

    /// <summary>The share of the samples that were not lost; the mean of their weights, where they have some.</summary>
    public double Share => _observed.Sum() / _samples;

    /// <summary>What the share may be off by chance.</summary>
    public double ShareTolerance => 2e-3 + (MostDeviations * Math.Sqrt(Math.Max(Share * (1 - Share), 1e-6) / _samples));

    /// <summary>How far the sum of χ² is above its mean, in standard deviations of a normal distribution.</summary>
    public double Deviation { get; }

    /// <summary>True where the samples follow the density.</summary>
    public bool Fits => Deviation < MostDeviations;

    /// <summary>The middle of the cell whose count is farthest from what is expected, and both numbers.</summary>
    public ((double X, double Y) At, double Expected, double Observed) Worst
    {
        get
        {
            int worst = Enumerable.Range(0, _observed.Length).MaxBy(i => Math.Abs(Residual(i)));
            return (_cells.All[worst].Middle, _expected[worst], _observed[worst]);
        }
    }

    /// <summary>Counts samples, and integrates the density that they should have, up to a factor.</summary>
    /// <param name="area">The area.</param>
    /// <param name="sample">Makes a sample; null where it is lost.</param>
    /// <param name="density">The density by area.</param>
    /// <param name="samples">The number of samples.</param>
    public static Histogram Of(Area area, Func<(double X, double Y)?> sample, Func<double, double, double> density, int samples)
    {
        (Cells cells, double[] observed, _) = Count(area, () => sample() is { } at ? (at, 1) : null, samples);
        double[] masses = Masses(cells, density, observed, observed, 1, samples);
        double integral = masses.Sum();
        double[] expected = Array.ConvertAll(masses, m => integral > 0 ? m / integral * observed.Sum() : 0);
        return new(cells, samples, observed, expected, expected) { Integral = integral };
    }

    /// <summary>Sums the weights of samples, each of which should have a density of one over its weight where another density is one.</summary>
    /// <param name="area">The area.</param>
    /// <param name="sample">Makes a sample; null where it is lost.</param>
    /// <param name="isThere">The other density: 1 where samples may be, and 0 elsewhere.</param>
    /// <param name="samples">The number of samples.</param>
    public static Histogram OfWeights(Area area, Func<((double X, double Y) At, double Weight)?> sample, Func<double, double, double> isThere, int samples)
    {
        (Cells cells, double[] observed, double[] squares) = Count(area, sample, samples);
        double unit = squares.Sum() / Math.Max(observed.Sum(), 1e-300);
        double[] expected = Array.ConvertAll(Masses(cells, isThere, observed, squares, unit, samples), m => m * samples);

        // Sums of weights have the variance of their squares' sum. Where samples are few, those of the whole area have a say in how large weights are.
        const double Others = 3;
        double[] scales = [.. observed.Select((o, i) => (squares[i] + (Others * unit * unit)) / (o + (Others * unit)))];
        return new(cells, samples, observed, expected, [.. expected.Select((e, i) => e * scales[i])], unit) { Integral = expected.Sum() / samples };
    }

    /// <summary>Two counts of the same cells, which should differ by chance alone.</summary>
    /// <param name="area">The area.</param>
    /// <param name="samples">Samples.</param>
    /// <param name="others">Samples that are known to be right, at least as many.</param>
    public static Histogram OfTwo(Area area, IReadOnlyList<(double X, double Y)> samples, IReadOnlyList<(double X, double Y)> others)
    {
        Cells cells = new(area, [.. others.Where((_, i) => i % 4 == 0)]);
        others = [.. others.Where((_, i) => i % 4 != 0)];
        double[] observed = Counts(samples);
        double[] right = Counts(others);

        // Expected by both together, of which the samples are a part.
        double all = observed.Sum() + right.Sum();
        double[] expected = [.. observed.Zip(right, (a, b) => (a + b) / all * observed.Sum())];
        return new(cells, samples.Count, observed, expected, Array.ConvertAll(expected, e => e * right.Sum() / all)) { Integral = 1 };

        double[] Counts(IReadOnlyList<(double X, double Y)> points)
        {
            double[] counts = new double[cells.All.Count];
            Array.ForEach([.. points.Select(cells.CellOf).Where(c => c >= 0)], c => counts[c]++);
            return counts;
        }
    }

    /// <summary>Draws what was counted, what was expected, and the difference.</summary>
    /// <param name="title">The title.</param>
    /// <param name="x">The name of the first coordinate.</param>
    /// <param name="y">The name of the second coordinate.</param>
    public XDocument Draw(string title, string x, string y) => CellChart.Draw(title, x, y, _cells.All, _observed, _expected, Residual);

    private static (Cells Cells, double[] Observed, double[] Squares) Count(Area area, Func<((double X, double Y) At, double Weight)?> sample, int samples)
    {
        Cells cells = new(area, [.. Enumerable.Range(0, samples / 4).Select(_ => sample()?.At).OfType<(double, double)>()]);
        double[] observed = new double[cells.All.Count];
        double[] squares = new double[cells.All.Count];
        for (int i = 0; i < samples; i++)
        {
            if (sample() is { } s && cells.CellOf(s.At) is >= 0 and int cell)
            {
                observed[cell] += s.Weight;
                squares[cell] += s.Weight * s.Weight;
            }
        }

        return (cells, observed, squares);
    }

    // To a tenth of what sums deviate by chance. Where that is not what was found, an edge may have slipped between the points of the quadrature, and
    // more of them tell.
    private static double[] Masses(Cells cells, Func<double, double, double> density, double[] observed, double[] squares, double unit, int samples) =>
        [.. cells.All.Select((cell, i) =>
        {
            double chance = Math.Sqrt(Math.Max(LeastExpected * unit * unit, squares[i])) / samples;
            double mass = Cells.Integrate(cell, density, 0.1 * chance);
            return Math.Abs(mass - (observed[i] / samples)) < 1.5 * chance ? mass : Cells.Integrate(cell, density, 0.1 * chance, finest: true);
        })];

    private double Residual(int cell) => (_observed[cell] - _expected[cell]) / Math.Sqrt(Math.Max(_variances[cell], _unit * _unit));

    // The cube root of a χ² sum is nearly normal (Wilson & Hilferty, The distribution of chi-square, 1931).
    private double ChiSquaredDeviation()
    {
        double sum = 0;
        int count = 0;
        (double observed, double expected, double variance) = (0, 0, 0);
        foreach (int i in Enumerable.Range(0, _observed.Length).OrderBy(i => _expected[i]))
        {
            (observed, expected, variance) = (observed + _observed[i], expected + _expected[i], variance + _variances[i]);

            // As many counts as a Poisson distribution has with this mean and variance.
            if (variance > 0 && expected * expected / variance >= LeastExpected)
            {
                sum += (observed - expected) * (observed - expected) / variance;
                count++;
                (observed, expected, variance) = (0, 0, 0);
            }
        }

        double freedom = count - 1;
        double spread = 2 / (9 * freedom);
        return freedom < 1 ? Enumerable.Range(0, _observed.Length).Max(i => Math.Abs(Residual(i))) : (Math.Cbrt(sum / freedom) - (1 - spread)) / Math.Sqrt(spread);
    }
}
