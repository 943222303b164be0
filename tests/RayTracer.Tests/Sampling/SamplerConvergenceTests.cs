using RayTracer.Description;
using RayTracer.Sampling;

namespace RayTracer.Tests.Sampling;

/// <summary>
/// How fast the error of a pixel's mean falls with its number of samples N, against theory: variance σ²/N for independent
/// samples; for jittered ones the sum of the variances within the cells, which is about N⁻² for smooth integrands and N^(−3/2)
/// across edges (Mitchell 1996); for scrambled nets about N⁻³ for smooth ones (Owen 1997).
/// Covers `SobolSampler` and `JitteredSampler`.
/// </summary>
[Trait("Category", "Thorough")]
public class SamplerConvergenceTests
{
    private const int Batches = 16;
    private static readonly int[] s_counts = [4, 16, 64, 256, 1024, 4096];
    private static readonly int s_pixels = TestSettings.Scale(64, 256);

    public static TheoryData<SamplerKind, string> Cases()
    {
        TheoryData<SamplerKind, string> cases = [];
        foreach (SamplerKind kind in new[] { SamplerKind.Sobol, SamplerKind.Jittered, SamplerKind.Independent })
        {
            foreach (string decision in new[] { "pixel", "light 1 of vertex 0" })
            {
                cases.Add(kind, decision);
            }
        }

        return cases;
    }

    [Theory]
    [MemberData(nameof(Cases))]
    [Trait("Category", "Slow")]
    public void The_variance_of_a_mean_falls_with_the_number_of_samples_as_theory_says(SamplerKind kind, string decision)
    {
        // For each batch of pixels, integrand and number of samples: the mean squared error over its expectation.
        double[,,] measured = Measure(kind, PathDimension.Named(decision));
        for (int f = 0; f < TestIntegrand.All.Length; f++)
        {
            TestIntegrand integrand = TestIntegrand.All[f];
            string what = $"{kind}, {decision}, {integrand.Name}";
            double[] jittered = [.. s_counts.Select(integrand.JitteredVariance)];
            double[] expected = kind == SamplerKind.Independent ? [.. s_counts.Select(n => integrand.Variance / n)] : jittered;
            Assert.InRange(Slope(jittered), integrand.JitteredSlope - 0.1, integrand.JitteredSlope + 0.1);
            double[] slopes = [.. Enumerable.Range(0, Batches).Select(b => Slope([.. Enumerable.Range(0, s_counts.Length).Select(n => measured[f, n, b])]))];
            for (int n = 0; n < s_counts.Length; n++)
            {
                double[] ratios = [.. Enumerable.Range(0, Batches).Select(b => measured[f, n, b] / expected[n])];
                double p = kind == SamplerKind.Sobol ? AtMost(ratios, 1) : PValues.Mean(ratios, 1);
                ErrorBudget.Samplers.Check(p, $"{what}: variance of {s_counts[n]} samples is {ratios.Average():G4} times what is expected");
            }

            // The logarithm of a batch's mean is below that of the expectation by about 1/pixels at every N: all but equally.
            double slope = kind == SamplerKind.Sobol ? AtMost(slopes, integrand.SobolSlope) : PValues.Mean(slopes, Slope(expected), 0.01);
            ErrorBudget.Samplers.Check(slope, $"{what}: slope {slopes.Average():F3}");
        }
    }

    private static double[,,] Measure(SamplerKind kind, PathDimension decision)
    {
        double[,,] measured = new double[TestIntegrand.All.Length, s_counts.Length, Batches];
        for (int n = 0; n < s_counts.Length; n++)
        {
            Sampler sampler = DrawnNumbers.Sampler(kind, s_counts[n]);
            for (int i = 0; i < Batches * s_pixels; i++)
            {
                uint seed = ((uint)TestSettings.Seed * 7919u) + (uint)n;
                DrawnNumbers points = DrawnNumbers.OfPixel(sampler, decision, Hash.PixelKey(seed, (uint)i));
                for (int f = 0; f < TestIntegrand.All.Length; f++)
                {
                    double error = TestIntegrand.All[f].Mean(points) - TestIntegrand.All[f].Integral;
                    measured[f, n, i / s_pixels] += error * error / s_pixels;
                }
            }
        }

        return measured;
    }

    // Least squares over the logarithms.
    private static double Slope(double[] variances)
    {
        double[] x = [.. s_counts.Select(n => Math.Log((double)n))];
        double[] y = [.. variances.Select(v => Math.Log(v))];
        double center = x.Average();
        return x.Zip(y, (a, b) => (a - center) * b).Sum() / x.Sum(a => (a - center) * (a - center));
    }

    // Fails only above the bound.
    private static double AtMost(double[] values, double bound) => values.Average() <= bound ? 1 : PValues.Mean(values, bound);
}
