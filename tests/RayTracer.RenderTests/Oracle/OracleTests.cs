using System.Globalization;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.Oracle;

/// <summary>
/// The product's pictures against those of the oracle, an independent ray tracer (<see cref="RecursiveTracer"/>). Both render
/// the same number of independent pictures of as many samples, so that where their noise is of one kind, the difference is
/// distributed symmetrically even if the noise is not. The output says how fine the comparison is.
/// Covers `ReportShader`, `DirectLight` and `RayGenerator`.
/// </summary>
[Trait("Category", "Thorough")]
[Trait("Category", "Slow")]
public class OracleTests(ITestOutputHelper output)
{
    private const int Batches = 64;
    private static readonly string s_own = ProjectFolder.PathOf("tests", "RayTracer.RenderTests", "Oracle", "scenes");
    private static readonly string s_report = ProjectFolder.PathOf("scenes", "report");

    /// <summary>Side of the square of samples in each pixel of a batch.</summary>
    private static int SamplesPerSide => TestSettings.Scale(4, 8);

    // Half of them every day, and all in the thorough part.
    public static TheoryData<string> OwnScenes() =>
        [.. Directory.GetFiles(s_own, "*.json").Select(f => Path.GetFileNameWithoutExtension(f)).Order(StringComparer.Ordinal).Where((_, i) => TestSettings.Thorough || (i + TestSettings.Seed) % 2 == 0)];

    [Theory]
    [MemberData(nameof(OwnScenes))]
    public void Product_and_oracle_expect_the_same_picture(string scene) => Compare(scene, Path.Combine(s_own, scene + ".json"), null);

    [Theory]
    [InlineData("scene1")]
    [InlineData("scene2")]
    [InlineData("scene3")]
    public void Product_and_oracle_expect_the_same_picture_of_the_report(string scene) => Compare(scene, Path.Combine(s_report, scene + ".json"), (48, 48));

    private void Compare(string name, string path, (int Width, int Height)? size)
    {
        Scene scene = SceneFile.Read(path, size);
        int side = size is null ? SamplesPerSide : SamplesPerSide / 2;
        ImageSamples oracle = OracleRuns.Oracle(scene, Batches, side, name);
        ImageSamples product = OracleRuns.Product(path, scene, Batches, side);
        output.WriteLine($"{name}: {Difference(product, oracle)}; {BlockTest.Compare(product, oracle)}");
        ReplayScene replay = ReplayScene.File(path, "--width", $"{scene.Width}", "--height", $"{scene.Height}", "--spp", $"{side * side}");
        ImageAssert.SameExpectation(product, oracle, ErrorBudget.Oracle, $"oracle-{name}", replay);
    }

    private static string Difference(ImageSamples product, ImageSamples oracle)
    {
        Block all = new(0, 0, oracle.Width, oracle.Height);
        BlockEstimate a = product.Estimate(all, channel: 1);
        BlockEstimate b = oracle.Estimate(all, channel: 1);
        return string.Create(
            CultureInfo.InvariantCulture,
            $"green mean off by {(a.Mean / b.Mean) - 1:P3} ± {Math.Sqrt(a.Variance + b.Variance) / b.Mean:P3} (oracle alone ± {Math.Sqrt(b.Variance) / b.Mean:P3})");
    }
}
