using System.Collections.Concurrent;
using RayTracer.Description;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.Transport.LightPaths;

/// <summary>
/// Integrators that start paths at the lights against path tracing, which does not: scene by scene in blocks, and all scenes together in
/// their means, where little energy shows that is lost or found twice.
/// Covers `CameraSubpaths`, `LightSubpaths`, `Connections`, `SubpathSumsW` and `LightEmission`.
/// </summary>
[Trait("Category", "Thorough")]
public class LightPathTests(ITestOutputHelper output)
{
    // A circle in which next to nothing is merged: what is left of vcm has the expectation of path tracing.
    private const float NoRadius = 1e-4f;
    private static readonly int s_seeds = TestSettings.Scale(16, 32);
    private static readonly string[] s_integrators = ["bidirectional", "vcm", "light"];
    private static readonly ConcurrentDictionary<(string Scene, string Integrator), Lazy<ImageSamples>> s_images = [];

    public static TheoryData<string, string> Cases
    {
        get
        {
            TheoryData<string, string> cases = [];
            foreach (string integrator in s_integrators)
            {
                foreach (LightPathScene scene in ScenesFor(integrator))
                {
                    cases.Add(scene.Name, integrator);
                }
            }

            return cases;
        }
    }

    public static TheoryData<string> Integrators => new(s_integrators);

    [Theory]
    [MemberData(nameof(Cases))]
    public void Paths_from_the_lights_bring_what_those_from_the_camera_find(string name, string integrator)
    {
        LightPathScene scene = LightPathScene.All.Single(s => s.Name == name);
        BlockTest test = BlockTest.Compare(Images(scene, integrator), Images(scene, scene.Reference));
        ErrorBudget.Transport.Check(test.P, $"{name} by {integrator}: {test}", () => scene.Text);
    }

    [Theory]
    [MemberData(nameof(Integrators))]
    public void All_scenes_together_have_all_energy(string integrator)
    {
        // The mean of the pictures' relative errors, by which each is sure of it: one in a hundred would be far out.
        double sum = 0;
        double certainty = 0;
        foreach (LightPathScene scene in ScenesFor(integrator))
        {
            BlockEstimate image = Whole(Images(scene, integrator));
            BlockEstimate path = Whole(Images(scene, scene.Reference));
            double weight = path.Mean * path.Mean / (image.Variance + path.Variance);
            sum += weight * ((image.Mean / path.Mean) - 1);
            certainty += weight;
        }

        double deviation = 1 / Math.Sqrt(certainty);
        string found = FormattableString.Invariant($"{integrator}: off by {sum / certainty:P3} ± {deviation:P3}");
        output.WriteLine(found);
        Assert.InRange(deviation, 0, 0.004);
        ErrorBudget.Transport.Check(PValues.StudentT(sum / certainty / deviation, (s_seeds - 1) * ScenesFor(integrator).Count()), found);
    }

    // Every day, what vcm does as bidirectional path tracing does is seen in some scenes only.
    private static IEnumerable<LightPathScene> ScenesFor(string integrator) =>
        LightPathScene.All.Where((s, i) => integrator == "light" ? s.IsMatt : integrator != "vcm" || TestSettings.Thorough || i % 3 == 0);

    // Light tracing is quick, and noisy.
    private static int SamplesOf(LightPathScene scene, string integrator) => (integrator == "light" ? 3 : 1) * TestSettings.Scale(1, 2) * scene.Samples;

    private static BlockEstimate Whole(ImageSamples images) => images.Estimate(new(0, 0, images.Width, images.Height), 1);

    private static ImageSamples Images(LightPathScene scene, string integrator) => s_images.GetOrAdd(
        (scene.Name, integrator),
        _ => new(() => SceneRuns.RenderText(
            scene.Text,
            s_seeds,
            d => d with { Render = d.Render with { Integrator = Integrator.Known.All.Single(i => i.Name == integrator), SamplesPerPixel = SamplesOf(scene, integrator), MergeRadius = NoRadius } },
            firstSeed: 1 + (1000 * (Array.IndexOf(s_integrators, integrator) + 1))))).Value;
}
