namespace Lab3;

/// <summary>Integrals by random numbers. random.Next() is a number from 0 to 1, independent of all others.</summary>
public static class Estimators
{
    /// <summary>Estimates the integral of f from a to b by n independent points.</summary>
    /// <param name="f">The function.</param>
    /// <param name="a">Where to begin.</param>
    /// <param name="b">Where to end.</param>
    /// <param name="n">The number of points.</param>
    /// <param name="random">The source of random numbers.</param>
    public static double Mean(Func<double, double> f, double a, double b, int n, ISampler random)
    {
        //? Estimators.Mean: the mean of f at n random points, times the length of the interval.
        double sum = 0;
        for (int i = 0; i < n; i++)
        {
            sum += f(a + ((b - a) * random.Next()));
        }

        return (b - a) * sum / n;
        //!
    }

    /// <summary>The same, and how far it may be off: the standard deviation of the estimate, estimated from the points themselves.</summary>
    /// <param name="f">The function.</param>
    /// <param name="a">Where to begin.</param>
    /// <param name="b">Where to end.</param>
    /// <param name="n">The number of points, at least 2.</param>
    /// <param name="random">The source of random numbers.</param>
    public static (double Integral, double Error) WithError(Func<double, double> f, double a, double b, int n, ISampler random)
    {
        //? Estimators.WithError: the variance of the values, from their mean and n − 1; then that of their mean, which is n times smaller.
        double[] values = new double[n];
        for (int i = 0; i < n; i++)
        {
            values[i] = f(a + ((b - a) * random.Next()));
        }

        double mean = values.Average();
        double variance = values.Sum(v => (v - mean) * (v - mean)) / (n - 1);
        return ((b - a) * mean, (b - a) * Math.Sqrt(variance / n));
        //!
    }

    /// <summary>The same integral by strata: one random point in each of n parts of equal length.</summary>
    /// <param name="f">The function.</param>
    /// <param name="a">Where to begin.</param>
    /// <param name="b">Where to end.</param>
    /// <param name="n">The number of points.</param>
    /// <param name="random">The source of random numbers.</param>
    public static double Stratified(Func<double, double> f, double a, double b, int n, ISampler random)
    {
        //? Estimators.Stratified: the i-th point lies at random in the i-th of n parts.
        double sum = 0;
        for (int i = 0; i < n; i++)
        {
            sum += f(a + ((b - a) * (i + random.Next()) / n));
        }

        return (b - a) * sum / n;
        //!
    }

    /// <summary>An integral by points of a density that is high where f is.</summary>
    /// <param name="f">The function.</param>
    /// <param name="warp">Makes a point of a random number from 0 to 1.</param>
    /// <param name="pdf">The density of the points that it makes.</param>
    /// <param name="n">The number of points.</param>
    /// <param name="random">The source of random numbers.</param>
    public static double ByImportance(Func<double, double> f, Func<double, double> warp, Func<double, double> pdf, int n, ISampler random)
    {
        //? Estimators.ByImportance: where points are dense, each of them stands for less.
        double sum = 0;
        for (int i = 0; i < n; i++)
        {
            double x = warp(random.Next());
            sum += f(x) / pdf(x);
        }

        return sum / n;
        //!
    }
}
