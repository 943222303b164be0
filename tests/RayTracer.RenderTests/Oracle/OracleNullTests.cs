using System.Globalization;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.Oracle;

/// <summary>
/// Whether p-values of product against oracle are what they claim: small ones must not be frequent where nothing is wrong.
/// Covers `ReportShader` and `SobolSampler`.
/// </summary>
[Trait("Category", "Thorough")]
[Trait("Category", "Slow")]
public class OracleNullTests(ITestOutputHelper output)
{
    private const int Batches = 64;
    private static readonly double[] s_levels = [0.3, 0.1, 0.03];

    [Theory]
    [InlineData("coat")]
    [InlineData("glass")]
    public void Small_p_values_are_not_frequent(string name)
    {
        string path = ProjectFolder.PathOf("tests", "RayTracer.RenderTests", "Oracle", "scenes", name + ".json");
        Scene scene = SceneFile.Read(path);
        int runs = TestSettings.Scale(10, 30);
        List<double> ofRuns = [];
        List<double> ofBlocks = [];
        for (int run = 0; run < runs; run++)
        {
            ImageSamples oracle = OracleRuns.Oracle(scene, Batches, 2, string.Create(CultureInfo.InvariantCulture, $"null {run}"));
            ImageSamples product = OracleRuns.Product(path, scene, Batches, 2, firstSeed: 10_000 + (run * Batches));
            ofRuns.Add(BlockTest.Compare(product, oracle).P);
            ofBlocks.AddRange(
                from block in Block.Cut(scene.Width, scene.Height, 4)
                from channel in Enumerable.Range(0, 3)
                select BlockTest.Welch(product.Estimate(block, channel), oracle.Estimate(block, channel)));
        }

        foreach (double level in (double[])[0.1, 0.01, 1e-3, 1e-4])
        {
            output.WriteLine($"{ofBlocks.Count(p => p < level)} of {ofBlocks.Count} blocks have p < {level}");
        }

        foreach (double level in s_levels)
        {
            int below = ofRuns.Count(p => p < level);
            output.WriteLine($"{below} of {runs} runs have p < {level}");
            double p = below <= level * runs ? 1 : PValues.Binomial(below, runs, level);
            ErrorBudget.NullRuns.Check(p, $"{name}: {below} of {runs} p-values are below {level}");
        }
    }
}
