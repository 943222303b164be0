using System.Text.Json;
using RayTracer.Description;
using RayTracer.Scenes;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.References;

/// <summary>
/// All scenes of the references, read from the files that the other renderer reads and rendered by path tracing, against its
/// pictures. Nothing but chance is allowed for.
/// Covers `MitsubaReader` and `PathShader`.
/// </summary>
[Trait("Category", "Thorough")]
public class MitsubaReferenceTests(ITestOutputHelper output)
{
    private const string Missing = "the other renderer's images are not here";

    private static readonly string[] s_folders = ["references", "references-more"];

    // Few samples find much of the light: fewer would not tell how much the picture varies.
    private static readonly string[] s_caustics = ["glass", "caustic_sphere", "glass_lamp"];

    public static TheoryData<string> Names
    {
        get
        {
            string[] names = [.. s_folders.Select(f => ProjectFolder.Shared(f, "cases.json")).OfType<string>().SelectMany(NamesIn)];
            return names.Length > 0 ? new(names) : new(Missing);
        }
    }

    [SkippableTheory]
    [Trait("Category", "Slow")]
    [MemberData(nameof(Names))]
    public void Files_of_another_renderer_give_its_pictures(string name)
    {
        string? folder = FolderOf(name);
        Skip.If(folder is null || name == Missing, Missing);
        string file = Path.Combine(folder, "scenes", $"{name}.xml");
        ReferenceMoments reference = ReferenceComparison.Read(folder, name);
        int samples = s_caustics.Contains(name) ? TestSettings.Scale(16, 36) : TestSettings.Scale(4, 36);
        int seeds = s_caustics.Contains(name) ? 64 : TestSettings.Scale(16, 32);
        ImageSamples images = SceneRuns.Render(file, seeds, d => d with { Render = d.Render with { SamplesPerPixel = samples } });
        // Few samples may miss what is rare, and then tell too small a variance; both renderers' samples vary about as much.
        double missed = 0.25 * SamplesOf(folder, name) / ((double)samples * seeds);
        BlockEstimate Reference(Block block, int channel)
        {
            BlockEstimate own = reference.Estimate(block, channel);
            return own with { Variance = own.Variance * (1 + missed) };
        }

        ReferenceComparison comparison = new($"{name}.xml", images, Reference);
        output.WriteLine(comparison.Describe());
        output.WriteLine(comparison.Test().ToString());
        ImageAssert.SameExpectation(images, reference.Mean, Reference, ErrorBudget.References, comparison.Name, ReplayScene.File(file));
    }

    private static int SamplesOf(string folder, string name)
    {
        using JsonDocument list = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "cases.json")));
        return list.RootElement.EnumerateArray().Single(c => c.GetProperty("name").GetString() == name).GetProperty("samplesPerPixel").GetInt32();
    }

    [SkippableTheory]
    [MemberData(nameof(Names))]
    public void Files_of_another_renderer_are_read_without_a_complaint(string name)
    {
        string? folder = FolderOf(name);
        Skip.If(folder is null || name == Missing, Missing);
        SceneLoadResult result = SceneLoader.Load(Path.Combine(folder, "scenes", $"{name}.xml"));

        // Media around things are found, whatever the file says of them.
        Assert.Equal("", Diagnostic.Format([.. result.Diagnostics.Where(d => !d.Message.StartsWith("the medium ", StringComparison.Ordinal))]));
        Assert.Contains(result.Scene!.Render.Integrator, new[] { Integrator.Path, Integrator.VolPath });
    }

    private static string? FolderOf(string name) =>
        s_folders.Where(f => ProjectFolder.Shared(f, "cases.json") is { } cases && NamesIn(cases).Contains(name)).Select(f => ProjectFolder.Shared(f)).FirstOrDefault();

    private static string[] NamesIn(string cases)
    {
        using JsonDocument list = JsonDocument.Parse(File.ReadAllText(cases));
        return [.. list.RootElement.EnumerateArray().Select(c => c.GetProperty("name").GetString()!)];
    }
}
