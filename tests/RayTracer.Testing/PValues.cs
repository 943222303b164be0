using MathNet.Numerics;

namespace RayTracer.Testing;

/// <summary>p-values: the probability, if nothing is wrong, of a deviation at least as large as the one seen.</summary>
public static class PValues
{
    /// <summary>Of a standard normal number, on both sides.</summary>
    public static double Normal(double z) => 2 * MathNet.Numerics.Distributions.Normal.CDF(0, 1, -Math.Abs(z));

    /// <summary>Of Student's t with so many degrees of freedom, on both sides.</summary>
    public static double StudentT(double t, double freedom) =>
        double.IsInfinity(t) ? 0 : 2 * MathNet.Numerics.Distributions.StudentT.CDF(0, 1, freedom, -Math.Abs(t));

    /// <summary>Of a χ² sum above the one seen.</summary>
    public static double ChiSquared(double sum, double freedom) => sum <= 0 ? 1 : SpecialFunctions.GammaUpperRegularized(freedom / 2, sum / 2);

    /// <summary>
    /// Pearson's χ² test of counts. Cells of which fewer than five are expected are put together (Cochran 1954), and what
    /// lies outside all cells is impossible: a count where nothing is expected has p = 0.
    /// </summary>
    /// <param name="observed">Counts.</param>
    /// <param name="expected">Expected counts, of the same sum up to rounding.</param>
    /// <param name="estimated">Parameters that were estimated from the counts.</param>
    public static double ChiSquared(IReadOnlyList<double> observed, IReadOnlyList<double> expected, int estimated = 0)
    {
        double sum = 0;
        double pooledObserved = 0;
        double pooledExpected = 0;
        int cells = 0;
        foreach (int i in Enumerable.Range(0, observed.Count).OrderBy(i => expected[i]))
        {
            if (expected[i] <= 0 && observed[i] > 0)
            {
                return 0;
            }

            pooledObserved += observed[i];
            pooledExpected += expected[i];
            if (pooledExpected >= 5)
            {
                sum += (pooledObserved - pooledExpected) * (pooledObserved - pooledExpected) / pooledExpected;
                cells++;
                pooledObserved = pooledExpected = 0;
            }
        }

        if (pooledExpected > 0)
        {
            sum += (pooledObserved - pooledExpected) * (pooledObserved - pooledExpected) / pooledExpected;
            cells++;
        }

        return cells - 1 - estimated < 1 ? 1 : ChiSquared(sum, cells - 1 - estimated);
    }

    /// <summary>
    /// Of a number of successes, on both sides: twice the smaller tail of the binomial distribution.
    /// </summary>
    /// <param name="successes">How many.</param>
    /// <param name="trials">Of how many.</param>
    /// <param name="probability">Of one.</param>
    public static double Binomial(int successes, int trials, double probability)
    {
        if (probability is <= 0 or >= 1)
        {
            return successes == (probability >= 1 ? trials : 0) ? 1 : 0;
        }

        // The tail beyond is a regularised incomplete beta function: exact where sums of tiny terms would not be.
        double atLeast = successes == 0 ? 1 : SpecialFunctions.BetaRegularized(successes, trials - successes + 1, probability);
        double atMost = successes == trials ? 1 : SpecialFunctions.BetaRegularized(trials - successes, successes + 1, 1 - probability);
        return Math.Min(1, 2 * Math.Min(atLeast, atMost));
    }

    /// <summary>Of the mean of independent numbers whose expectation is known: Student's t.</summary>
    /// <param name="values">At least two numbers.</param>
    /// <param name="expected">Their expectation.</param>
    /// <param name="tolerance">What the mean may be off without being wrong, such as rounding.</param>
    public static double Mean(IReadOnlyCollection<double> values, double expected, double tolerance = 0)
    {
        double mean = values.Average();
        double variance = values.Sum(v => (v - mean) * (v - mean)) / (values.Count - 1.0) / values.Count;
        double off = Math.Max(0, Math.Abs(mean - expected) - tolerance);
        return off == 0 ? 1 : StudentT(off / Math.Sqrt(variance), values.Count - 1);
    }

    /// <summary>Of the smallest of several p-values, however they depend on one another (Bonferroni's inequality).</summary>
    public static double Smallest(IEnumerable<double> pValues)
    {
        double smallest = 1;
        int count = 0;
        foreach (double p in pValues)
        {
            // NaN, too, is carried on.
            smallest = double.IsNaN(smallest) || p >= smallest ? smallest : p;
            count++;
        }

        return double.IsNaN(smallest) ? smallest : Math.Min(1, smallest * count);
    }
}
