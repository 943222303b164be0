using System.Text.Json;
using RayTracer.Description;
using RayTracer.Scenes;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.References;

/// <summary>
/// All scenes of the references, read from the files that the other renderer reads and rendered by path tracing, against its pictures. Beside
/// chance, only what <see cref="SilhouetteMask"/> tells is allowed for.
/// </summary>
public class MitsubaReferenceTests(ITestOutputHelper output)
{
    private const string Missing = "the other renderer's images are not here";

    // Whose normals are interpolated.
    private static readonly string[] s_smooth = ["mesh_smooth"];

    public static TheoryData<string> Names
    {
        get
        {
            if (ProjectFolder.Shared("references", "cases.json") is not { } cases)
            {
                return new(Missing);
            }

            using JsonDocument list = JsonDocument.Parse(File.ReadAllText(cases));
            return new(list.RootElement.EnumerateArray().Select(c => c.GetProperty("name").GetString()!));
        }
    }

    [SkippableTheory]
    [Trait("Category", "Slow")]
    [MemberData(nameof(Names))]
    public void Files_of_another_renderer_give_its_pictures(string name)
    {
        string? folder = ProjectFolder.Shared("references");
        Skip.If(folder is null || name == Missing, Missing);
        string file = Path.Combine(folder, "scenes", $"{name}.xml");
        ReferenceMoments reference = ReferenceComparison.Read(folder, name);
        int samples = TestSettings.Scale(8, 64);
        ImageSamples images = SceneRuns.Render(file, TestSettings.Scale(12, 64), d => d with { Render = d.Render with { SamplesPerPixel = samples } });
        if (s_smooth.Contains(name))
        {
            SilhouetteMask mask = SilhouetteMask.Of(file);
            Assert.InRange(mask.Share, 0, 0.12);
            images = mask.Apply(images, reference.Mean);
        }

        ReferenceComparison comparison = new($"{name}.xml", images, reference.Estimate);
        output.WriteLine(comparison.Describe());
        output.WriteLine(comparison.Test().ToString());
        ImageAssert.SameExpectation(images, reference.Mean, reference.Estimate, ErrorBudget.References, comparison.Name, ReplayScene.File(file));
    }

    [SkippableTheory]
    [MemberData(nameof(Names))]
    public void Files_of_another_renderer_are_read_without_a_complaint(string name)
    {
        string? folder = ProjectFolder.Shared("references");
        Skip.If(folder is null || name == Missing, Missing);
        SceneLoadResult result = SceneLoader.Load(Path.Combine(folder, "scenes", $"{name}.xml"));
        Assert.Equal("", Diagnostic.Format(result.Diagnostics));
        Assert.Contains(result.Scene!.Render.Integrator, new[] { Integrator.Path, Integrator.VolPath });
    }
}
