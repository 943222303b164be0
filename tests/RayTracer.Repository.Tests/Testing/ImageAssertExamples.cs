using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Repository.Tests.Testing;

/// <summary>The code of docs/image-assert.md, compiled and run.</summary>
public class ImageAssertExamples
{
    private static readonly string s_scene = ProjectFolder.PathOf("scenes", "primer", "01-sphere.json");
    private static readonly TestFamily s_pictures = new("my pictures", 1e-6, 20, "two sets of images have the same expectation");

    // example: one image
    [Fact]
    public void Two_threads_give_the_bits_of_one()
    {
        Film one = new RTracer(SceneRuns.Load(s_scene, Small), new RenderOptions { Threads = 1 }).Render().Film;
        Film two = new RTracer(SceneRuns.Load(s_scene, Small), new RenderOptions { Threads = 2 }).Render().Film;
        ReplayScene scene = ReplayScene.File(s_scene, "--width", "24", "--height", "16", "--spp", "16");

        ImageAssert.Matches(two, one, ImageRule.Exact, "two threads", scene);
        ImageAssert.Matches(two, one, ImageRule.Within(absolute: 0.001, relative: 0.01, outlierShare: 0.02), "two threads, nearly", scene);
        ImageAssert.Matches(two, one, ImageRule.LooksLike(leastSsim: 0.98), "two threads, to the eye", scene);
    }

    // end

    // example: many seeds
    [Fact]
    public void Another_sampler_has_the_same_expectation()
    {
        ImageSamples sobol = SceneRuns.Render(s_scene, seeds: 8, Small);
        ImageSamples independent = SceneRuns.Render(
            s_scene, seeds: 8, d => Small(d) with { Render = Small(d).Render with { Sampler = Description.SamplerKind.Independent } }, firstSeed: 100);

        ImageAssert.SameExpectation(sobol, independent, s_pictures, "independent numbers");
    }

    // end

    [Theory]
    [InlineData("one image")]
    [InlineData("many seeds")]
    public void The_page_shows_the_code_that_is_run(string name)
    {
        string code = File.ReadAllText(ProjectFolder.PathOf("tests", "RayTracer.Repository.Tests", "Testing", "ImageAssertExamples.cs")).ReplaceLineEndings("\n");
        string example = code.Split($"// example: {name}\n", 2)[1].Split("\n    // end", 2)[0].TrimEnd();
        string shown = string.Join('\n', example.Split('\n').Select(line => line.StartsWith("    ", StringComparison.Ordinal) ? line[4..] : line));
        Assert.Contains($"```csharp\n{shown}\n```", File.ReadAllText(ProjectFolder.PathOf("docs", "image-assert.md")).ReplaceLineEndings("\n"), StringComparison.Ordinal);
    }

    private static SceneDescription Small(SceneDescription d) => d with { Render = d.Render with { Width = 24, Height = 16, SamplesPerPixel = 16 } };
}
