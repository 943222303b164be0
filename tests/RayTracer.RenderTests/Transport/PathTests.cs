using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.RenderTests.Transport;

/// <summary>The path integrator against the report's, which shares no decision about lights with it, and against what must not matter.</summary>
[Trait("Category", "Thorough")]
public class PathTests
{
    private const string Sphere = """{ "type": "sphere", "center": [-0.6, -0.4, 0], "radius": 0.6, "material": GLOSS }""";
    private const string Floor = """{ "type": "plane", "point": [0, -1, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.6, 0.7, 0.8] } }""";
    private const string Matt = """{ "type": "diffuse", "color": [0.9, 0.5, 0.3] }""";
    private const string Lamp = """ "material": { "type": "luminaire", "multiplier": 8 } """;
    private static readonly int s_seeds = TestSettings.Scale(16, 96);

    public static TheoryData<string, string> Lights => new()
    {
        { "a sphere", $$"""{ "type": "sphere", "center": [0.8, 0.4, 0.3], "radius": 0.4, {{Lamp}} }""" },
        { "a sphere that the floor cuts", $$"""{ "type": "sphere", "center": [0.8, -1, 0.3], "radius": 0.5, {{Lamp}} }""" },
        { "a rectangle", $$"""{ "type": "rectangle", "corner": [-1, 1.3, -1], "edgeU": [2, 0, 0], "edgeV": [0, 0, 1.5], {{Lamp}} }""" },
        { "a disk and a triangle", $$"""{ "type": "disk", "center": [1, 0.5, 0], "normal": [-1, -0.3, 0.2], "radius": 0.4, {{Lamp}} }, { "type": "triangle", "a": [-1, 1, 0], "b": [1, 1.2, 0], "c": [0, 1, -1], {{Lamp}} }""" },
        { "a box", $$"""{ "type": "box", "a": [0.4, -0.6, -0.2], "b": [0.9, -0.1, 0.5], {{Lamp}} }""" },
        { "a cone", $$"""{ "type": "cone", "bottom": [0.7, -0.9, 0.3], "top": [0.8, 0.3, 0.2], "radius": 0.4, {{Lamp}} }""" },
        { "a torus", $$"""{ "type": "torus", "center": [0.7, -0.3, 0.3], "axis": [0.3, 1, 0.2], "radius": 0.4, "tubeRadius": 0.15, {{Lamp}} }""" },
        { "a mesh", $$"""{ "type": "mesh", "positions": [[0.3, 0, 0], [1, 0, 0.3], [0.6, 0.8, 0], [0.6, 0.3, 0.6]], "triangles": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], {{Lamp}} }""" },
        {
            "a stretched instance",
            $$"""{ "type": "instance", "transform": [{ "scale": [1.4, -0.5, 0.8], "rotate": 30, "axis": [0, 0, 1], "translate": [0.8, 0, 0] }], "of": { "type": "group", "shapes": [{ "type": "sphere", "center": [0, 0.3, 0], "radius": 0.3, {{Lamp}} }, { "type": "mesh", "positions": [[-0.5, 0.6, 0], [0.5, 0.6, 0], [0, 0.7, 0.6]], "triangles": [[0, 1, 2]], {{Lamp}} }] } }"""
        },
    };

    [Theory]
    [MemberData(nameof(Lights))]
    public void Matt_surfaces_look_as_in_the_report(string what, string lights)
    {
        // A report's path of depth 2 has three surfaces at the most, and so four edges from the camera to a lamp; to the background, three.
        string scene = Scene(Sphere.Replace("GLOSS", Matt, StringComparison.Ordinal) + ", " + lights).Replace("[0.05, 0.1, 0.2]", "[0, 0, 0]", StringComparison.Ordinal);
        Compare(what, scene, Path(maxDepth: 4), scene, r => r with { MaxDiffuseDepth = 2 });
    }

    [Theory]
    [InlineData("")]
    [InlineData(""", { "type": "mesh", "positions": [[-2, -0.9, -1], [2, -0.9, -1], [0, 2, -1.5]], "triangles": [[0, 1, 2]] }""")]
    public void One_light_of_many_brings_what_all_of_them_bring(string more)
    {
        // More than are all asked: some of them behind, some in an instance, and one from afar.
        string many = string.Concat(Enumerable.Range(0, 9).Select(i => $$""", { "type": "sphere", "center": [{{-1.2 + (0.3 * i)}}, {{(i % 3) - 0.2}}, {{0.6 - (0.2 * (i % 4))}}], "radius": {{0.05 + (0.02 * (i % 3))}}, {{Lamp.Replace("8", $"{8 + (6 * i)}", StringComparison.Ordinal)}} }"""));
        string scene = Scene(Sphere.Replace("GLOSS", Matt, StringComparison.Ordinal) + many + more
            + $$""", { "type": "instance", "transform": [{ "scale": [1.4, -0.5, 0.8], "translate": [0.8, 0.5, 0] }], "of": { "type": "sphere", "center": [0, 0.3, 0], "radius": 0.3, {{Lamp}} } }"""
            + """, { "type": "directional", "direction": [0.3, -1, -0.2], "irradiance": [0.5, 0.4, 0.3] }, { "type": "point", "position": [-0.5, 0.6, 0.8], "intensity": [0.5, 0.6, 0.9] }""")
            .Replace("[0.05, 0.1, 0.2]", "[0, 0, 0]", StringComparison.Ordinal);
        Compare("many lights", scene, Path(maxDepth: 4), scene, r => r with { MaxDiffuseDepth = 2 });
    }

    [Theory]
    [InlineData("rough metal", """{ "type": "phongMetal", "color": [0.9, 0.8, 0.5], "exponent": 8 }""")]
    [InlineData("polished metal", """{ "type": "phongMetal", "color": [0.9, 0.8, 0.5], "exponent": 400 }""")]
    [InlineData("a coat", """{ "type": "diffuseSpecular", "diffuse": { "type": "diffuse", "color": [0.2, 0.5, 0.9] }, "specular": { "type": "phongMetal", "color": [1, 1, 1], "exponent": 20 }, "r0": 0.3 }""")]
    [InlineData("glass", """{ "type": "dielectric", "refractiveIndex": 1.5 }""")]
    [InlineData("shining metal", """{ "type": "luminaire", "multiplier": 0.5, "material": { "type": "phongMetal", "color": [0.9, 0.8, 0.5], "exponent": 20 } }""")]
    public void Gloss_looks_as_in_the_report_which_does_not_sample_lights_for_it(string what, string material)
    {
        // The floor is black but for the mirror image, so that depths mean the same; a big lamp, so that chance finds it.
        string scene = Scene(Sphere.Replace("GLOSS", material, StringComparison.Ordinal)
            + """, { "type": "rectangle", "corner": [-2, 1.6, -2], "edgeU": [4, 0, 0], "edgeV": [0, 0, 4], "material": { "type": "luminaire", "multiplier": 2 } }""")
            .Replace("[0.6, 0.7, 0.8]", "[0, 0, 0]", StringComparison.Ordinal);
        Compare(what, scene, Path(maxDepth: 9), scene, r => r with { MaxDiffuseDepth = 8, MaxSpecularDepth = 8 });
    }

    [Theory]
    [InlineData(0)]
    [InlineData(12)]
    public void A_matt_ball_under_an_even_sky_is_as_bright_as_its_colour(int lamps)
    {
        // However the sky is found, alone or as one of many lights; the others are shut into a small black ball far away.
        string hidden = string.Concat(Enumerable.Repeat(""", { "type": "point", "position": [0, 0, 50], "intensity": [500, 500, 500] }""", lamps))
            + """, { "type": "sphere", "center": [0, 0, 50], "radius": 0.05, "material": { "type": "diffuse", "color": [0, 0, 0] } }""";
        string scene = $$"""
            { "camera": { "position": [0, 0, 4], "lookAt": [0, 0, 0], "fieldOfView": 20 },
              "render": { "width": 8, "height": 8, "samplesPerPixel": 64, "integrator": "path" },
              "environment": { "type": "constant", "radiance": [1, 2, 3] },
              "shapes": [ { "type": "sphere", "center": [0, 0, 0], "material": { "type": "diffuse", "color": [0.6, 0.6, 0.2] } }{{hidden}} ] }
            """;
        ImageSamples images = SceneRuns.RenderText(scene, s_seeds);
        double[] expected = [0.6, 1.2, 0.6];
        for (int channel = 0; channel < 3; channel++)
        {
            BlockEstimate all = images.Estimate(new(0, 0, 8, 8), channel);
            ErrorBudget.Analytic.Check(BlockTest.Welch(all, new(expected[channel], 0, 1)), FormattableString.Invariant($"{lamps} lamps, channel {channel}: {all.Mean} ± {Math.Sqrt(all.Variance)}"));
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void Ending_paths_at_random_changes_no_mean(int rouletteDepth)
    {
        string scene = Scene(Sphere.Replace("GLOSS", Matt, StringComparison.Ordinal) + $$""", { "type": "sphere", "center": [0.8, 0.4, 0.3], "radius": 0.4, {{Lamp}} }""");
        Compare("roulette", scene, Path(-1, rouletteDepth), scene, Path(60, rouletteDepth: 60));
    }

    [Fact]
    public void Direct_light_is_that_of_paths_with_two_edges()
    {
        string scene = Scene(Sphere.Replace("GLOSS", Matt, StringComparison.Ordinal) + $$""", { "type": "sphere", "center": [0.8, 0.4, 0.3], "radius": 0.4, {{Lamp}} }""");
        ImageSamples direct = SceneRuns.RenderText(scene, 1, d => d with { Render = d.Render with { Integrator = Integrator.Direct } });
        ImageSamples path = SceneRuns.RenderText(scene, 1, d => d with { Render = Path(2)(d.Render) });
        Assert.Equal(path.Estimate(new(0, 0, path.Width, path.Height), 0).Mean, direct.Estimate(new(0, 0, path.Width, path.Height), 0).Mean);
    }

    [Fact]
    public void A_floor_at_a_wall_sees_half_of_the_sky()
    {
        // Of directions weighted by the cosine, those to one side of a plane through the normal are half: at every point, however far the wall.
        const string scene = """
            { "camera": { "position": [0, 2, 0], "lookAt": [0, 0, -1], "fieldOfView": 20 },
              "render": { "width": 16, "height": 16, "samplesPerPixel": 64, "integrator": "ao" },
              "shapes": [{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] }, { "type": "plane", "point": [0, 0, -3], "normal": [0, 0, 1] }] }
            """;
        ImageSamples images = SceneRuns.RenderText(scene, s_seeds);
        BlockEstimate all = images.Estimate(new(0, 0, 16, 16), 0);
        ErrorBudget.Analytic.Check(BlockTest.Welch(all, new(0.5, 0, 1)), $"{all.Mean} ± {Math.Sqrt(all.Variance)}");
        ImageSamples near = SceneRuns.RenderText(scene, 1, d => d with { Render = d.Render with { OcclusionDistance = 0.5f } });
        Assert.Equal(1, near.Estimate(new(0, 0, 16, 16), 0).Mean);
    }

    [Fact]
    public void Views_of_surfaces_are_what_they_say()
    {
        const string scene = """
            { "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "fieldOfView": 10 }, "background": [9, 9, 9],
              "render": { "integrator": "report", "width": 4, "height": 4, "samplesPerPixel": 1, "sampler": "regular" },
              "shapes": [{ "type": "rectangle", "corner": [-1, -1, 0], "edgeU": [1, 0, 0], "edgeV": [0, 4, 0], "material": { "type": "diffuse", "color": [0.1, 0.2, 0.3] } }] }
            """;
        Rgb At(Integrator integrator, int x) => SceneRuns.RenderText(scene, 1, d => d with { Render = d.Render with { Integrator = integrator } }) is var i
            ? new((float)i.Estimate(new(x, 1, 1, 1), 0).Mean, (float)i.Estimate(new(x, 1, 1, 1), 1).Mean, (float)i.Estimate(new(x, 1, 1, 1), 2).Mean) : default;
        Assert.Equal(new Rgb(0.5f, 0.5f, 1), At(Integrator.Normals, 0));
        Assert.Equal(new Rgb(0.1f, 0.2f, 0.3f), At(Integrator.Albedo, 0));
        Assert.InRange(At(Integrator.Uv, 0).R, 0.6f, 0.7f);
        Assert.Equal(Rgb.Black, At(Integrator.Albedo, 3));
    }

    private static Func<RenderDescription, RenderDescription> Path(int maxDepth, int rouletteDepth = 3) =>
        r => r with { Integrator = Integrator.Path, MaxDepth = maxDepth, RouletteDepth = rouletteDepth };

    private static void Compare(string what, string a, Func<RenderDescription, RenderDescription> changeA, string b, Func<RenderDescription, RenderDescription> changeB)
    {
        BlockTest test = BlockTest.Compare(
            SceneRuns.RenderText(a, s_seeds, d => d with { Render = changeA(d.Render) }, firstSeed: 1),
            SceneRuns.RenderText(b, s_seeds, d => d with { Render = changeB(d.Render) }, firstSeed: 1001));
        ErrorBudget.Transport.Check(test.P, $"{what}: {test}");
    }

    private static string Scene(string shapes) => $$"""
        {
          "camera": { "position": [0, 0.2, 4], "lookAt": [0, -0.2, 0], "fieldOfView": 38 },
          "render": { "integrator": "report", "width": 32, "height": 24, "samplesPerPixel": 36, "sampler": "jittered" },
          "background": [0.05, 0.1, 0.2],
          "shapes": [ {{Floor}}, {{shapes}} ]
        }
        """;
}
