using RayTracer.Description;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.References;

/// <summary>
/// Caustics of another renderer: what a ball of glass throws on a floor, the floor of a pool, and a lamp behind glass. They are read from
/// its files and rendered by integrators whose paths start at the lights, too.
/// Covers `Connections`, `LightSubpaths` and `PhotonMerge`.
/// </summary>
[Trait("Category", "Thorough")]
public class LightPathReferenceTests(ITestOutputHelper output)
{
    // Half as wide as a pixel or less: what is off by it is below the noise.
    private const float Radius = 0.03f;

    // Of each pixel of that picture, as its list of cases says.
    private const int ReferenceSamples = 74816;
    private static readonly int s_seeds = TestSettings.Scale(16, 48);

    [SkippableTheory]
    [Trait("Category", "Slow")]
    [InlineData("caustic_sphere", "bidirectional")]
    [InlineData("caustic_sphere", "vcm")]
    [InlineData("pool", "bidirectional")]
    [InlineData("pool", "vcm")]
    [InlineData("glass_lamp", "bidirectional")]
    [InlineData("glass_lamp", "vcm")]
    public void Caustics_agree_with_another_renderer(string name, string integrator)
    {
        string? folder = ProjectFolder.Shared("references-more");
        Skip.If(folder is null, "the other renderer's images of caustics are not here");
        string file = Path.Combine(folder, "scenes", $"{name}.xml");
        ReferenceMoments reference = ReferenceComparison.Read(folder, name);

        // The ball shows its lamp faintly in places: few samples may miss that, and then tell too small a variance. Both renderers' samples of it
        // vary about as much.
        int samples = TestSettings.Scale(2, 16);
        double missed = name == "caustic_sphere" ? 0.25 * ReferenceSamples / ((double)samples * s_seeds) : 0;
        BlockEstimate Reference(Block block, int channel)
        {
            BlockEstimate own = reference.Estimate(block, channel);
            return own with { Variance = own.Variance * (1 + missed) };
        }

        ImageSamples images = SceneRuns.Render(file, s_seeds, d => d with
        {
            Render = d.Render with
            {
                Integrator = Integrator.Known.All.Single(i => i.Name == integrator),
                SamplesPerPixel = samples,
                MergeRadius = Radius,
            },
        });
        ReferenceComparison comparison = new($"{name}.xml by {integrator}", images, Reference);
        output.WriteLine(comparison.Describe());
        output.WriteLine(comparison.Test().ToString());
        ImageAssert.SameExpectation(images, reference.Mean, Reference, ErrorBudget.References, comparison.Name, ReplayScene.File(file));
    }
}
