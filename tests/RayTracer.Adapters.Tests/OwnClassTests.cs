using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Scenes;
using RayTracer.StudentPlugin;
using RayTracer.Textbook;

namespace RayTracer.Adapters.Tests;

/// <summary>
/// Classes of a student, in a plug-in, take part in both editions: the fast edition's own things, a student's in the fast edition and a student's in
/// the textbook edition expect the same picture.
/// </summary>
[Trait("Category", "Thorough")]
public class OwnClassTests
{
    private static readonly int s_seeds = TestSettings.Scale(8, 64);

    // What takes the place of each word, in the program and by the student.
    private static readonly (string Word, string Fast, string Own)[] s_words =
    [
        ("MATT", "\"diffuse\"", "\"ownMatt\""),
        ("GLOSS", "\"roughConductor\", \"metal\": \"none\"", "\"ownGloss\""),
        ("GLASS", "\"dielectric\", \"refractiveIndex\": 1.5", "\"ownGlass\", \"index\": 1.5"),
        ("BALL", "\"sphere\"", "\"ownBall\""),
    ];

    static OwnClassTests() => Plugins.Add(typeof(OwnMatt).Assembly);

    [Theory]
    [InlineData("path", true)]
    [InlineData("report", true)]
    [InlineData("direct", true)]
    [InlineData("light", true)]
    [InlineData("bidirectional", false)]
    [InlineData("vcm", false)]
    public void A_student_s_material_and_shape_look_like_the_program_s_own(string integrator, bool isInTextbook)
    {
        string limits = integrator switch { "report" => ", \"maxDiffuseDepth\": 2, \"maxSpecularDepth\": 4", "direct" => "", _ => ", \"maxDepth\": 5" };
        string scene = $$"""
            { "camera": { "position": [0, 1.3, 4.4], "lookAt": [0, 0.75, 0], "fieldOfView": 36 },
              "render": { "width": 24, "height": 16, "samplesPerPixel": 64, "sampler": "independent", "integrator": "{{integrator}}"{{limits}} },
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "size": [8, 8], "material": { "type": MATT, "color": { "type": "checker", "scale": [8, 8] } } },
                { "type": BALL, "center": [-1.3, 0.5, 0.2], "radius": 0.5, "material": { "type": GLOSS, "alpha": 0.3 } },
                { "type": BALL, "center": [0.2, 0.2, 0], "radius": 0.6, "material": { "type": GLASS } },
                { "type": BALL, "center": [0, 0, 0], "radius": 0.5, "transform": [ { "scale": [1, 1.6, 0.7], "rotate": 30 }, { "translate": [1.4, 0.8, -0.3] } ], "material": { "type": MATT, "color": [0.7, 0.3, 0.2] } } ],
              "lights": [ { "type": BALL, "center": [1.6, 3.4, 2.2], "radius": 0.8, "material": { "type": "luminaire", "multiplier": 4, "material": { "type": MATT } } },
                { "type": "point", "position": [-2, 3, 1], "intensity": [6, 7, 9] } ] }
            """;
        ImageSamples expected = Editions.Fast(Editions.LoadText(Fast(scene)), s_seeds);
        SceneLoadResult own = Editions.LoadText(Own(scene));
        ImageAssert.SameExpectation(Editions.Fast(own, s_seeds), expected, ErrorBudget.Textbook, $"own-{integrator}-fast");
        if (isInTextbook)
        {
            ImageAssert.SameExpectation(Editions.Textbook(own, s_seeds), expected, ErrorBudget.Textbook, $"own-{integrator}-textbook");
        }
    }

    [Fact]
    public void A_student_s_integrator_renders_by_the_textbook_edition_without_being_asked_for()
    {
        using TemporaryFolder folder = new();
        const string Scene = """
            { "camera": { "position": [0, 1.3, 4.4], "lookAt": [0, 0.75, 0] }, "background": [0.4, 0.5, 0.6],
              "render": { "width": 16, "height": 12, "samplesPerPixel": 32, "sampler": "independent", "integrator": "INTEGRATOR", "maxDepth": 4 },
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] }, { "type": "sphere", "center": [0, 1, 0], "material": { "type": "diffuse", "color": [0.8, 0.4, 0.2] } } ] }
            """;
        SceneLoadResult own = Editions.LoadText(Scene.Replace("INTEGRATOR", "ownPath", StringComparison.Ordinal));
        ImageSamples expected = Editions.Fast(Editions.LoadText(Scene.Replace("INTEGRATOR", "path", StringComparison.Ordinal)), s_seeds);
        ImageAssert.SameExpectation(Editions.Textbook(own, s_seeds), expected, ErrorBudget.Textbook, "own-integrator");

        string file = folder["scene.json"];
        File.WriteAllText(file, Scene.Replace("INTEGRATOR", "ownPath", StringComparison.Ordinal));
        FilmHeader header = HeaderOf(new RenderJob { Scene = file, Threads = 1, Samples = new(0, 1), Outputs = [folder["a.rtfilm"]] });
        Assert.StartsWith("textbook-", header.Content, StringComparison.Ordinal);
        Assert.Contains("depend on the system", header.Software, StringComparison.Ordinal);
        JobException refusal = Assert.Throws<JobException>(() => new JobRun(new RenderJob { Scene = file, Denoise = true, Outputs = [folder["a.png"]] }, new Watch()).Run(default));
        Assert.Contains("the textbook edition makes pictures and films only", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Films_with_a_student_s_classes_say_that_their_bits_depend_on_the_system_and_so_do_merged_ones()
    {
        using TemporaryFolder folder = new();
        string file = folder["scene.json"];
        File.WriteAllText(file, Own("""{ "render": { "width": 4, "height": 4, "samplesPerPixel": 4, "sampler": "independent" }, "background": [1, 1, 1], "shapes": [ { "type": BALL, "center": [0, 0, 0] } ] }"""));
        string[] films = [folder["1.rtfilm"], folder["2.rtfilm"]];
        RenderJob job = new() { Scene = file, Threads = 1 };
        Assert.Contains("with classes of the textbook edition, whose bits depend on the system", HeaderOf(job with { Outputs = [films[0]], Samples = new(0, 1) }).Software, StringComparison.Ordinal);
        HeaderOf(job with { Outputs = [films[1]], Samples = new(1, 4) });
        Assert.EndsWith("depend on the system", FilmMerge.Of(films).Header.Software, StringComparison.Ordinal);

        File.WriteAllText(file, Fast(File.ReadAllText(file).Replace("\"ownBall\"", "BALL", StringComparison.Ordinal)));
        Assert.DoesNotContain("system", HeaderOf(job with { Outputs = [folder["3.rtfilm"]], Samples = new(0, 1) }).Software, StringComparison.Ordinal);
    }

    [Fact]
    public void What_a_student_s_class_cannot_do_is_said_at_its_place()
    {
        string Complaint(string scene) => Diagnostic.Format(SceneLoader.LoadText(scene, "scene.json", ".").Diagnostics);
        Assert.Contains(
            "sees its textures by u and v", Complaint("""{ "shapes": [ { "type": "sphere", "material": { "type": "ownMatt", "color": { "type": "noise" } } } ] }"""), StringComparison.Ordinal);
    }

    [Fact]
    public void A_material_that_goes_through_both_adapters_is_itself()
    {
        Hit hit = new() { Normal = new(0, 0, 1), Shading = new(0, 0, 1), Distance = 1 };
        hit.Face(new(0, 0, -1));
        Vector from = new Vector(0.3, -0.4, 0.8).Unit;
        IndependentSampler sampler = new(TestSettings.Seed);
        IMaterial own = new OwnGloss(0.3);
        LaneMaterial gloss = new(new TextbookMaterial(own, null));
        LaneMaterial glass = new(new TextbookMaterial(new OwnGlass(1.5), null));
        int refracted = 0;
        for (int i = 0; i < 200; i++)
        {
            Vector to = Warp.CosineHemisphere(sampler.Next2());
            Assert.Equal(1, gloss.Evaluate(hit, from, to).G / own.Evaluate(hit, from, to).G, 1e-3);
            Assert.Equal(1, gloss.Pdf(hit, from, to) / own.Pdf(hit, from, to), 1e-3);

            // Particles of light do not grow fewer where radiance does.
            Scattering s = glass.Sample(hit, from, sampler)!.Value;
            refracted += s.Direction.Z < 0 ? 1 : 0;
            Assert.Equal(s.Direction.Z < 0 ? 1 / (1.5 * 1.5) : 1, s.Weight.G / s.ParticleWeight.G, 1e-5);
        }

        Assert.InRange(refracted, 50, 150);
    }

    private static FilmHeader HeaderOf(RenderJob job)
    {
        new JobRun(job, new Watch()).Run(default);
        return HeldFilm.Read(job.Outputs[0]).Header;
    }

    private static string Fast(string scene) => s_words.Aggregate(scene, (text, word) => text.Replace(word.Word, word.Fast, StringComparison.Ordinal));

    private static string Own(string scene) => s_words.Aggregate(scene, (text, word) => text.Replace(word.Word, word.Own, StringComparison.Ordinal));

    private sealed class Watch : IJobWatch
    {
        public void Warn(string message) => Assert.Fail(message);

        public void Fail(string message) => Assert.Fail(message);

        public void Read(IReadOnlyList<Diagnostic> diagnostics) => Assert.Empty(diagnostics);
    }
}
