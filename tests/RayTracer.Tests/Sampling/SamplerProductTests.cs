using RayTracer.Description;
using RayTracer.Sampling;

namespace RayTracer.Tests.Sampling;

/// <summary>
/// Integrands over two decisions at once, as paths have them. Were the strata of the two visited in one order, the variance
/// of a pixel's mean would not fall with the number of samples.
/// Covers `VertexSamples` and `Dimensions`.
/// </summary>
[Trait("Category", "Thorough")]
public class SamplerProductTests
{
    private const int Batches = 32;
    private static readonly int s_pixels = TestSettings.Scale(128, 512);

    // What each of two decisions contributes, with mean and variance.
    private static readonly Factor[] s_ofPairs =
    [
        new("smooth", (u, v) => 4 * u * v, 1, 7 / 9.0),
        new("edge", (u, v) => u + v < 1 ? 2 : 0, 1, 1),
        new("sign", (u, _) => u < 0.5f ? 1 : -1, 0, 1),
    ];

    // The same for decisions that take one number.
    private static readonly Factor[] s_ofNumbers =
    [
        new("smooth", (u, _) => 2 * u, 1, 1 / 3.0),
        new("edge", (u, _) => u < 0.5f ? 2 : 0, 1, 1),
        new("sign", (u, _) => u < 0.5f ? 1 : -1, 0, 1),
    ];

    public static TheoryData<SamplerKind, string, string> Products()
    {
        TheoryData<SamplerKind, string, string> cases = [];
        foreach (SamplerKind kind in new[] { SamplerKind.Sobol, SamplerKind.Jittered, SamplerKind.Independent })
        {
            cases.Add(kind, "pixel", "lens");
            cases.Add(kind, "pixel", "direction of vertex 0");
            cases.Add(kind, "lens", "light 0 of vertex 0");
            cases.Add(kind, "direction of vertex 0", "choice of vertex 0");
            cases.Add(kind, "direction of vertex 0", "direction of vertex 1");
            cases.Add(kind, "direction of vertex 0", "light 0 of vertex 1");
            cases.Add(kind, "direction of vertex 1", "direction of vertex 2");
            cases.Add(kind, "choice of vertex 0", "choice of vertex 1");
        }

        return cases;
    }

    public static TheoryData<SamplerKind, string, string> Sums()
    {
        TheoryData<SamplerKind, string, string> cases = [];
        foreach (SamplerKind kind in new[] { SamplerKind.Sobol, SamplerKind.Jittered, SamplerKind.Independent })
        {
            cases.Add(kind, "light 0 of vertex 0", "light 1 of vertex 0");
            cases.Add(kind, "light 0 of vertex 0", "light 8 of vertex 0");
            cases.Add(kind, "light 0 of vertex 0", "direction of vertex 0");
        }

        return cases;
    }

    /// <summary>What is multiplied: the variance is not above that of independent samples.</summary>
    /// <remarks>
    /// Products of two factors of mean 0 may have more. Two nets whose points are matched by nested shuffles (Burley 2020) have
    /// twice that variance for the signs of the first digits, since neighbours in the order differ in both signs at once: 1 + 2⁻ʲ for digit j. The net
    /// of pixel and lens may have 2³, for its quality parameter is t = 3 (Owen 1998). A random matching of the jittered sampler's cells
    /// would have N/(N − 1); its hashed permutations have up to 1.3, and cells visited in one order would have N.
    /// </remarks>
    [Theory]
    [MemberData(nameof(Products))]
    public void Products_over_two_decisions_have_no_more_variance_than_with_independent_samples(SamplerKind kind, string first, string second) =>
        Check(kind, first, second, "times", (f, g) => f * g, (f, g, count) =>
        {
            double independent = ((f.SecondMoment * g.SecondMoment) - (f.Mean * f.Mean * g.Mean * g.Mean)) / count;
            return f.Mean == 0 ? Gain(kind, first, second) * independent : independent;
        });

    /// <summary>What is added may come from one group: its strata may be visited in one order.</summary>
    [Theory]
    [MemberData(nameof(Sums))]
    public void Sums_over_two_decisions_have_no_more_variance_than_with_independent_samples(SamplerKind kind, string first, string second) =>
        Check(kind, first, second, "plus", (f, g) => f + g, (f, g, count) => (f.Variance + g.Variance) / count);

    private static double Gain(SamplerKind kind, string first, string second) => kind.Name switch
    {
        "sobol" => first == "pixel" && second == "lens" ? 8 : 2,
        "jittered" => 1.5,
        _ => 1,
    };

    private static void Check(
        SamplerKind kind, string first, string second, string sign, Func<double, double, double> combine, Func<Factor, Factor, int, double> bound)
    {
        (PathDimension a, PathDimension b) = (PathDimension.Named(first), PathDimension.Named(second));
        Factor[] f = a.IsPair ? s_ofPairs : s_ofNumbers;
        Factor[] g = b.IsPair ? s_ofPairs : s_ofNumbers;
        foreach (int count in new[] { 16, 64 })
        {
            Sampler sampler = DrawnNumbers.Sampler(kind, count);
            double[,] measured = new double[f.Length, Batches];
            for (int i = 0; i < Batches * s_pixels; i++)
            {
                uint key = Hash.PixelKey(((uint)TestSettings.Seed * 7919u) + (uint)count, (uint)i);
                DrawnNumbers x = DrawnNumbers.OfPixel(sampler, a, key);
                DrawnNumbers y = DrawnNumbers.OfPixel(sampler, b, key);
                for (int k = 0; k < f.Length; k++)
                {
                    double mean = Enumerable.Range(0, count).Sum(n => combine(f[k].Value(x.U[n], x.V[n]), g[k].Value(y.U[n], y.V[n]))) / count;
                    double error = mean - combine(f[k].Mean, g[k].Mean);
                    measured[k, i / s_pixels] += error * error / s_pixels;
                }
            }

            for (int k = 0; k < f.Length; k++)
            {
                double[] ratios = [.. Enumerable.Range(0, Batches).Select(batch => measured[k, batch] / bound(f[k], g[k], count))];
                double p = ratios.Average() <= 1 ? 1 : PValues.Mean(ratios, 1);
                ErrorBudget.Samplers.Check(p, $"{kind} of {count}, {f[k].Name}: {first} {sign} {second}, {ratios.Average():G4} times the variance allowed");
            }
        }
    }

    private sealed record Factor(string Name, Func<float, float, double> Value, double Mean, double Variance)
    {
        public double SecondMoment => Variance + (Mean * Mean);
    }
}
