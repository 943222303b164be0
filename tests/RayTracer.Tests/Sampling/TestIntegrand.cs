namespace RayTracer.Tests.Sampling;

/// <summary>A function on the unit square of which everything is known that convergence is measured by.</summary>
/// <param name="Name">A name for messages.</param>
/// <param name="Value">The function.</param>
/// <param name="Integral">Its mean over the square.</param>
/// <param name="Variance">Its variance over the square.</param>
/// <param name="JitteredSlope">Exponent of N in the variance of N jittered samples.</param>
/// <param name="SobolSlope">Largest exponent of N for scrambled nets.</param>
/// <param name="CellVariance">Variance within the square cell at a corner (first two arguments) of a side (third).</param>
internal sealed record TestIntegrand(
    string Name,
    Func<double, double, double> Value,
    double Integral,
    double Variance,
    double JitteredSlope,
    double SobolSlope,
    Func<double, double, double, double> CellVariance)
{
    /// <summary>A plane, a curved surface, and the inside of a circle.</summary>
    public static readonly TestIntegrand[] All =
    [
        new("plane", (u, v) => (0.8 * u) + (0.6 * v), 0.7, 1 / 12.0, -2, -2.5, (_, _, h) => h * h / 12),
        new("product", (u, v) => 4 * u * v, 1, 7 / 9.0, -2, -2.5, ProductVariance),
        new("quarter of a disk", (u, v) => (u * u) + (v * v) < 1 ? 1 : 0, Math.PI / 4, Math.PI / 4 * (1 - (Math.PI / 4)), -1.5, -1.4, DiskVariance),
    ];

    /// <summary>Variance of the mean of n jittered samples: the sum of the variances within the cells over n².</summary>
    public double JitteredVariance(int n)
    {
        int side = (int)Math.Sqrt(n);
        double sum = 0;
        for (int i = 0; i < n; i++)
        {
            sum += CellVariance((double)(i % side) / side, (double)(i / side) / side, 1.0 / side);
        }

        return sum / ((double)n * n);
    }

    /// <summary>The function's mean over points.</summary>
    public double Mean(DrawnNumbers points)
    {
        double sum = 0;
        for (int i = 0; i < points.U.Length; i++)
        {
            sum += Value(points.U[i], points.V[i]);
        }

        return sum / points.U.Length;
    }

    // Variance of 4uv, a product of independent numbers, by the moments of each.
    private static double ProductVariance(double x, double y, double h)
    {
        double mean = (x + (h / 2)) * (y + (h / 2));
        double squares = Square(x, h) * Square(y, h);
        return 16 * (squares - (mean * mean));
    }

    private static double Square(double x, double h) => (x * x) + (x * h) + (h * h / 3);

    // p(1 − p) of the share p of the cell within the disk, integrated by the midpoint rule along u.
    private static double DiskVariance(double x, double y, double h)
    {
        const int steps = 200;
        double p = 0;
        for (int i = 0; i < steps; i++)
        {
            double u = x + (h * (i + 0.5) / steps);
            p += Math.Clamp((Math.Sqrt(1 - (u * u)) - y) / h, 0, 1) / steps;
        }

        return p * (1 - p);
    }
}
