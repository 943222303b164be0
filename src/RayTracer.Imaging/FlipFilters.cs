using RayTracer.Numerics;

namespace RayTracer.Imaging;

/// <summary>
/// The filters of FLIP for a density of pixels, as one-dimensional halves: the eye's contrast sensitivity to each opponent colour
/// (Andersson et al. 2020, section 4.1.2, Equation 5 and Table 1), and those that find edges and points (section 4.2).
/// </summary>
internal sealed class FlipFilters
{
    // The width of what finds features, in degrees.
    private const double FeatureWidth = 0.082;

    // The widest of the Gaussians.
    private const double LargestB = 0.04;

    public FlipFilters(double pixelsPerDegree)
    {
        int radius = (int)Math.Ceiling(3 * Math.Sqrt(LargestB / (2 * double.Pi * double.Pi)) * pixelsPerDegree);
        Luminance = Sensitivity(pixelsPerDegree, radius, 0.0047);
        RedGreen = Sensitivity(pixelsPerDegree, radius, 0.0053);
        BlueYellow = [Sensitivity(pixelsPerDegree, radius, LargestB), Sensitivity(pixelsPerDegree, radius, 0.025)];

        // The two are added as they are, and their sum is normalized.
        double[] weights = [Weight(34.1, LargestB, pixelsPerDegree, radius), Weight(13.5, 0.025, pixelsPerDegree, radius)];
        BlueYellowShare = weights[0] / (weights[0] + weights[1]);

        double sigma = 0.5 * FeatureWidth * pixelsPerDegree;
        int reach = (int)Math.Ceiling(3 * sigma);
        double[] gaussian = Kernel(reach, x => Gaussian(x * x / (2 * sigma * sigma)));
        Blur = Normalized(gaussian);
        Edge = Balanced([.. gaussian.Select((g, i) => -(i - reach) * g)]);
        Point = Balanced([.. gaussian.Select((g, i) => (((i - reach) * (i - reach) / (sigma * sigma)) - 1) * g)]);
    }

    public float[] Luminance { get; }

    public float[] RedGreen { get; }

    /// <summary>Two Gaussians; the first one's share is <see cref="BlueYellowShare"/>.</summary>
    public float[][] BlueYellow { get; }

    public double BlueYellowShare { get; }

    /// <summary>Across the direction in which features are looked for.</summary>
    public float[] Blur { get; }

    public float[] Edge { get; }

    public float[] Point { get; }

    private static float[] Sensitivity(double pixelsPerDegree, int radius, double b) => Normalized(Spread(pixelsPerDegree, radius, b));

    private static double[] Spread(double pixelsPerDegree, int radius, double b) =>
        Kernel(radius, x => Gaussian(double.Pi * double.Pi * x * x / (pixelsPerDegree * pixelsPerDegree * b)));

    private static double Weight(double a, double b, double pixelsPerDegree, int radius)
    {
        double sum = Spread(pixelsPerDegree, radius, b).Sum();
        return a * Math.Sqrt(double.Pi / b) * sum * sum;
    }

    private static double[] Kernel(int radius, Func<int, double> value) => [.. Enumerable.Range(-radius, (2 * radius) + 1).Select(value)];

    private static double Gaussian(double exponent) => PortableMath.Exp2(Math.Max(-exponent * 1.4426950408889634, -1000));

    private static float[] Normalized(double[] kernel) => [.. kernel.Select(k => (float)(k / kernel.Sum()))];

    // Weights above zero add up to 1, and those below to −1.
    private static float[] Balanced(double[] kernel)
    {
        double above = kernel.Where(k => k > 0).Sum();
        double below = -kernel.Where(k => k < 0).Sum();
        return [.. kernel.Select(k => (float)(k > 0 ? k / above : k < 0 ? k / below : 0))];
    }
}
