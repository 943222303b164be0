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
    private readonly int _samples;

    private Histogram(Cells cells, double[] observed, double[] masses, int samples, double kept)
    {
        (_cells, _observed, _samples, Integral, Share) = (cells, observed, samples, masses.Sum(), kept / samples);
        _expected = Array.ConvertAll(masses, m => Integral > 0 ? m / Integral * kept : 0);
        Deviation = ChiSquaredDeviation();
    }

    /// <summary>The integral of the density.</summary>
    public double Integral { get; }

    /// <summary>The share of the samples that were not lost.</summary>
    public double Share { get; }

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

    /// <summary>Counts samples, and integrates the density that they should have.</summary>
    /// <param name="area">The area.</param>
    /// <param name="sample">Makes a sample; null where it is lost.</param>
    /// <param name="density">The density by area.</param>
    /// <param name="samples">The number of samples.</param>
    public static Histogram Of(Area area, Func<(double X, double Y)?> sample, Func<double, double, double> density, int samples)
    {
        Cells cells = new(area, [.. Enumerable.Range(0, samples / 4).Select(_ => sample()).OfType<(double, double)>()]);
        double[] observed = new double[cells.All.Count];
        int kept = 0;
        for (int i = 0; i < samples; i++)
        {
            if (sample() is { } at && cells.CellOf(at) is >= 0 and int cell)
            {
                observed[cell]++;
                kept++;
            }
        }

        // A tenth of what counts deviate by chance.
        double Tolerance(int cell) => 0.1 * Math.Sqrt(Math.Max(LeastExpected, observed[cell])) / samples;
        double[] masses = [.. cells.All.Select((c, i) => Cells.Integrate(c, density, Tolerance(i)))];
        return new(cells, observed, masses, samples, kept);
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
        double[] together = [.. Counts(others).Zip(observed, (a, b) => a + b)];

        // Expected by both together, of which a part deviates as the samples do: scaled so that the variance is that of counts again.
        double factor = 1 + ((double)samples.Count / others.Count);
        double all = together.Sum();
        return new(cells, Array.ConvertAll(observed, o => o * factor), Array.ConvertAll(together, t => t / all), samples.Count, observed.Sum() * factor);

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

    private double Residual(int cell) => (_observed[cell] - _expected[cell]) / Math.Sqrt(Math.Max(_expected[cell], 1));

    // The cube root of a χ² sum is nearly normal (Wilson & Hilferty, The distribution of chi-square, 1931).
    private double ChiSquaredDeviation()
    {
        double sum = 0;
        int count = 0;
        (double observed, double expected) = (0, 0);
        foreach (int i in Enumerable.Range(0, _observed.Length).OrderBy(i => _expected[i]))
        {
            (observed, expected) = (observed + _observed[i], expected + _expected[i]);
            if (expected >= LeastExpected)
            {
                sum += (observed - expected) * (observed - expected) / expected;
                count++;
                (observed, expected) = (0, 0);
            }
        }

        double freedom = count - 1;
        double spread = 2 / (9 * freedom);
        return freedom < 1 ? Enumerable.Range(0, _observed.Length).Max(i => Math.Abs(Residual(i))) : (Math.Cbrt(sum / freedom) - (1 - spread)) / Math.Sqrt(spread);
    }
}
