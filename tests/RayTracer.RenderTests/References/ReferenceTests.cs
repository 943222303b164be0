using System.Text.Json;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.References;

/// <summary>
/// Pictures against those of Mitsuba 3, which shares no line with this project.
/// Covers `ReportShader` and `PathShader`.
/// </summary>
[Trait("Category", "Thorough")]
public class ReferenceTests(ITestOutputHelper output)
{
    public static TheoryData<string> Names => new(ReferenceCase.All.Select(c => c.Name));

    [SkippableTheory]
    [Trait("Category", "Slow")]
    [MemberData(nameof(Names))]
    public void Pictures_agree_with_another_renderer(string name)
    {
        string? folder = ProjectFolder.Shared("references");
        Skip.If(folder is null, "the other renderer's images are not here");
        ReferenceCase scene = ReferenceCase.All.Single(c => c.Name == name);
        ReferenceMoments reference = ReferenceComparison.Read(folder, name);
        ReferenceRenders renders = scene.Render(seeds: TestSettings.Scale(32, 64), samplesPerPixel: TestSettings.Scale(8, 32));
        Assert.All(ReferenceComparison.Of(renders, reference), comparison =>
        {
            output.WriteLine(comparison.Describe());
            output.WriteLine(comparison.Test().ToString());
            ImageAssert.SameExpectation(
                comparison.Images, reference.Mean, comparison.Reference, ErrorBudget.References, comparison.Name, ReplayScene.File(scene.File));
        });
    }

    [SkippableFact]
    public void The_page_about_the_tests_says_of_each_scene_whether_it_is_tested()
    {
        string? cases = ProjectFolder.Shared("references", "cases.json");
        Skip.If(cases is null, "the list of the other renderer's images is not here");
        string page = File.ReadAllText(ProjectFolder.PathOf("docs", "testing.md"));
        using JsonDocument list = JsonDocument.Parse(File.ReadAllText(cases));
        Assert.All(list.RootElement.EnumerateArray().Select(c => c.GetProperty("name").GetString()!), name =>
            Assert.Contains(ReferenceCase.All.Any(c => c.Name == name) ? $"\n| {name} | yes" : $"\n| {name} | no: ", page, StringComparison.Ordinal));
    }
}
