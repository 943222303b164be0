using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Repository.Tests.Testing;

/// <summary>
/// The primer's scenes against pictures of earlier renders. All but the first test outlive a change of samplers or of the order of
/// random numbers, for they compare what is seen, or expectations. <c>RAYTRACER_UPDATE=1</c> writes the pictures again.
/// </summary>
[Trait("Category", "Thorough")]
[Trait("Category", "Pinned")]
public class RegressionTests
{
    private const int Width = 32;
    private const int Height = 24;
    private static readonly bool s_updates = Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1";

    public static TheoryData<string> Primer => new(Directory.GetFiles(ProjectFolder.PathOf("scenes", "primer"), "*.json")
        .Select(f => Path.GetFileNameWithoutExtension(f)).Order(StringComparer.Ordinal));

    // With 256 samples the similarity to the references, of 4096, is 0.97 at least and varies by 0.003 between seeds.
    [Theory]
    [MemberData(nameof(Primer))]
    public void Primer_scene_looks_as_it_did(string name)
    {
        (Film film, ReplayScene scene) = Render(name, s_updates ? 4096 : 256);
        ImageAssert.MatchesFile(film, Reference($"{name}.png"), ImageRule.LooksLike(0.95), scene);
    }

    [Fact]
    public void Soft_shadows_have_the_same_bits()
    {
        (Film film, ReplayScene scene) = Render("03-soft-shadows", 4, seed: 1);
        ImageAssert.MatchesFile(film, Reference("soft-shadows-bits.pfm"), ImageRule.Exact, scene);
    }

    // Ambient light alone has no noise but on edges.
    [Fact]
    public void Ambient_light_is_the_same_within_one_per_cent_but_on_edges()
    {
        (Film film, ReplayScene scene) = Render("16-ambient", s_updates ? 4096 : 256);
        ImageAssert.MatchesFile(film, Reference("ambient.pfm"), ImageRule.Within(0.002, 0.01, 0.05), scene);
    }

    [Fact]
    public void Colour_bleeding_has_the_same_expectation()
    {
        const int References = 32;
        string path = PathOf("04-colour-bleeding");
        ImageSamples images = SceneRuns.Render(path, TestSettings.Scale(8, 32), d => Small(d, 64), firstSeed: 1000);
        if (s_updates)
        {
            ImageSamples samples = SceneRuns.Render(path, References, d => Small(d, 256));
            ImageFile.Write(Reference("colour-bleeding.mean.pfm"), samples.Mean());
            ImageFile.Write(Reference("colour-bleeding.variance.pfm"), Variance(samples));
        }

        ReferenceMoments reference = new(ImageFile.Read(Reference("colour-bleeding.mean.pfm")), ImageFile.Read(Reference("colour-bleeding.variance.pfm")), References - 1);
        ImageAssert.SameExpectation(images, reference, ErrorBudget.Images, "colour bleeding", ReplayScene.File(path, Options(64, 1000)));
    }

    private static (Film Film, ReplayScene Scene) Render(string name, int samples, int? seed = null)
    {
        int chosen = seed ?? (TestSettings.Seed + 1);
        Film film = new RTracer(SceneRuns.Load(PathOf(name), d => Small(d, samples, chosen))).Render().Film;
        return (film, ReplayScene.File(PathOf(name), Options(samples, chosen)));
    }

    private static SceneDescription Small(SceneDescription d, int samples, int seed = 1) =>
        d with { Render = d.Render with { Width = Width, Height = Height, SamplesPerPixel = samples, Seed = seed } };

    private static string[] Options(int samples, int seed) => ["--width", $"{Width}", "--height", $"{Height}", "--spp", $"{samples}", "--seed", $"{seed}"];

    private static Picture Variance(ImageSamples samples) => new(
        Width, Height, [.. Enumerable.Range(0, 3 * Width * Height).Select(i => (float)samples.Estimate(new(i / 3 % Width, i / 3 / Width, 1, 1), i % 3).Variance)]);

    private static string PathOf(string name) => ProjectFolder.PathOf("scenes", "primer", $"{name}.json");

    private static string Reference(string file) => ProjectFolder.PathOf("tests", "RayTracer.Repository.Tests", "Testing", "References", file);
}
