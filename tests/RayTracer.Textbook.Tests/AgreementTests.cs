using RayTracer.Description;
using RayTracer.Scenes;
using Xunit.Abstractions;

namespace RayTracer.Textbook.Tests;

/// <summary>Both editions expect the same picture, of every scene within the range of the textbook edition.</summary>
[Trait("Category", "Thorough")]
public class AgreementTests(ITestOutputHelper output)
{
    private static readonly int s_seeds = TestSettings.Scale(16, 64);

    // Of the scenes with one feature each by which the renderer is compared with the oracle, those with cylinders and cones.
    private static readonly string[] s_beyond = ["light-solids", "shapes-glass", "shapes-matt"];

    public static TheoryData<string> OracleScenes =>
        [.. Names("tests", "RayTracer.RenderTests", "Oracle", "scenes").Except(s_beyond)];

    public static TheoryData<string> ReferenceScenes => [.. Names("tests", "RayTracer.RenderTests", "References", "scenes").Except(["directional"])];

    [Theory]
    [MemberData(nameof(OracleScenes))]
    public void Both_editions_expect_the_same_picture(string scene) => Compare(scene, ["tests", "RayTracer.RenderTests", "Oracle", "scenes", $"{scene}.json"], null);

    [SkippableTheory]
    [MemberData(nameof(ReferenceScenes))]
    public void Both_editions_expect_the_same_picture_of_references(string scene)
    {
        string[] path = ["tests", "RayTracer.RenderTests", "References", "scenes", $"{scene}.json"];
        bool needsMore = File.ReadAllText(ProjectFolder.PathOf(path)).Contains("/shared/", StringComparison.Ordinal);
        Skip.If(needsMore && ProjectFolder.Shared("references") is null, "the pictures that the scene shows are not here");
        Compare(scene, path, (32, 24));
    }

    [Theory]
    [InlineData("cornell.json")]
    [InlineData("minimal.json")]
    [InlineData("report/scene1.json")]
    [InlineData("report/scene2.json")]
    [InlineData("report/scene3.json")]
    [InlineData("lights/02-studio.json")]
    [InlineData("materials/12-phong.json")]
    [InlineData("meshes/01-cube.json")]
    [InlineData("meshes/02-smooth.json")]
    [InlineData("meshes/03-mesh-light.json")]
    [InlineData("primer/22-intersection.json")]
    [InlineData("primer/23-transforms.json")]
    [InlineData("primer/26-importance.json")]
    public void Both_editions_expect_the_same_picture_of_shipped_scenes(string scene) => Compare(scene, ["scenes", .. scene.Split((char)47)], (32, 24));

    /// <summary>What no shipped scene within the range has.</summary>
    [Theory]
    [InlineData("orthographic", """
        "camera": { "position": [0, 1, 5], "lookAt": [0, 0.7, 0], "projection": "orthographic", "viewSize": 3 }, "render": { "integrator": "path", RENDER },
        "background": [0.3, 0.4, 0.5], "shapes": [ FLOOR, { "type": "sphere", "center": [0, 0.7, 0], "radius": 0.7, "material": { "type": "roughConductor", "metal": "gold", "alpha": 0.3 } } ]
        """)]
    [InlineData("ggx", """
        CAMERA, "render": { "integrator": "path", RENDER }, "shapes": [ FLOOR, { "type": "point", "position": [2, 3, 2], "intensity": [20, 15, 10] },
        { "type": "sphere", "center": [-0.8, 0.7, 0], "radius": 0.7, "material": { "type": "roughConductor", "metal": "copper", "alpha": 0.1 } },
        { "type": "sphere", "center": [0.8, 0.7, 0], "radius": 0.7, "material": { "type": "roughConductor", "eta": [0.2, 0.9, 1.1], "k": [3.9, 2.4, 2.1], "alpha": 0.6 } } ], LAMP
        """)]
    [InlineData("direct", """CAMERA, "render": { "integrator": "direct", RENDER }, "background": [0.1, 0.2, 0.3], "shapes": [ FLOOR, BALLS ], LAMP""")]
    [InlineData("light", """
        CAMERA, "render": { "integrator": "light", "maxDepth": 3, RENDER }, "shapes": [ FLAT, { "type": "sphere", "center": [0.8, 0.7, 0], "radius": 0.7, "material": { "type": "dielectric" } },
        { "type": "torus", "center": [-0.8, 0.5, 0], "axis": [1, 2, 1], "radius": 0.5, "tubeRadius": 0.2, "material": { "type": "phong", "exponent": 10, "specular": [0.5, 0.5, 0.5], "diffuse": [0.3, 0.2, 0.4] } } ], LAMP
        """)]
    [InlineData("light-lens", """
        "camera": { "position": [0, 1, 5], "lookAt": [0, 0.7, 0], "lens": { "apertureRadius": 0.2, "focusDistance": 4 } }, "render": { "integrator": "light", "maxDepth": 4, RENDER },
        "shapes": [ FLAT, { "type": "disk", "center": [0, 1, 1], "normal": [1, 1, 2], "radius": 0.4 }, { "type": "point", "position": [2, 3, 2], "intensity": [20, 15, 10] } ]
        """)]
    [InlineData("light-depth", """
        CAMERA, "render": { "integrator": "light", "maxDepth": 2, RENDER }, "shapes": [ { "type": "point", "position": [1, 2, 1], "intensity": [3, 3, 3] },
        { "type": "box", "a": [-3, -1, -3], "b": [3, 4, 6], "material": { "type": "diffuse", "color": [0.9, 0.9, 0.9] } } ]
        """)]
    [InlineData("sides", """
        CAMERA, "render": { "integrator": "path", RENDER }, "background": [0.5, 0.5, 0.6], "shapes": [ FLOOR,
        { "type": "disk", "center": [-1, 1, 0], "normal": [1, 0, 1], "radius": 0.7, "material": { "type": "oneSided", "material": { "type": "diffuse", "color": [0.8, 0.3, 0.3] } } },
        { "type": "disk", "center": [-1, 1, 1], "normal": [-1, 0, -1], "radius": 0.4, "material": { "type": "oneSided", "material": { "type": "diffuse", "color": [0.8, 0.3, 0.3] } } },
        { "type": "disk", "center": [1, 1, 0], "normal": [1, 0, -1], "radius": 0.7, "material": { "type": "twoSided", "front": { "type": "diffuse", "color": [0.2, 0.7, 0.3] }, "back": { "type": "phongMetal", "exponent": 30 } } } ], LAMP
        """)]
    [InlineData("placed", """
        CAMERA, "render": { "integrator": "path", RENDER }, "objects": { "thing": { "type": "group", "material": { "type": "diffuse", "color": [0.7, 0.5, 0.2] }, "shapes": [
          { "type": "box", "a": [-0.5, 0, -0.5], "b": [0.5, 0.6, 0.5] }, { "type": "sphere", "center": [0, 1, 0], "radius": 0.4, "material": { "type": "dielectric" } },
          { "type": "mesh", "positions": [[-0.5, 0.6, 0.5], [0.5, 0.6, 0.5], [0, 1.2, 0.5]], "triangles": [[0, 1, 2]], "material": { "type": "luminaire", "multiplier": 2, "color": [1, 0.5, 0.3] } } ] } },
        "shapes": [ FLOOR, { "type": "instance", "of": "thing", "transform": [ { "scale": [1, 0.7, 0.5], "rotate": 30 }, { "translate": [-0.9, 0, 0] } ] },
          { "type": "instance", "of": "thing", "transform": [ { "scale": [-1, 1, 1], "rotate": 20, "axis": [0, 0, 1] }, { "translate": [1, 0, 0] } ] } ], LAMP
        """)]
    [InlineData("textures", """
        CAMERA, "render": { "integrator": "path", RENDER }, "background": [1, 1, 1], "shapes": [ FLOOR,
        { "type": "torus", "center": [-0.9, 0.7, 0], "axis": [1, 1, 1], "radius": 0.5, "tubeRadius": 0.25, "material": { "type": "diffuse", "color": { "type": "checker", "scale": [8, 4] } } },
        { "type": "box", "a": [0.3, 0, -0.5], "b": [1.3, 1, 0.5], "material": { "type": "phong", "specular": { "type": "checker", "even": [0.5, 0.1, 0.1], "odd": [0, 0, 0], "scale": [3, 2] } } } ]
        """)]
    public void Both_editions_expect_the_same_picture_of_what_is_left(string name, string scene) => Compare(name, Editions.LoadText(Whole(scene)));

    [Theory]
    [InlineData("path")]
    [InlineData("photons")]
    public void Paths_from_the_lights_bring_what_paths_from_the_camera_do(string other)
    {
        // Photons blur what they show: only the mean of a picture without edges is compared, within the blur.
        const string Scene = """
            "camera": { "position": [0, 1, 3], "lookAt": [0, 0, 0], "fieldOfView": 20 }, "render": { "integrator": "INTEGRATOR", "maxDepth": 4, "mergeRadius": 0.05, RENDER },
            "background": [0.2, 0.3, 0.4], "shapes": [ SMALL, { "type": "point", "position": [1, 3, 1], "intensity": [20, 15, 10] } ]
            """;
        ImageSamples Images(string integrator) => Editions.Textbook(Editions.LoadText(Whole(Scene.Replace("INTEGRATOR", integrator, StringComparison.Ordinal))), 32);
        (ImageSamples light, ImageSamples images) = (Images("light"), Images(other));
        if (other == "path")
        {
            ImageAssert.SameExpectation(light, images, ErrorBudget.Textbook, "textbook-light-and-path");
        }

        for (int channel = 0; channel < 3; channel++)
        {
            Block all = new(0, 0, light.Width, light.Height);
            (BlockEstimate a, BlockEstimate b) = (images.Estimate(all, channel), light.Estimate(all, channel));
            double deviation = Math.Sqrt(a.Variance + b.Variance);
            Assert.InRange(deviation / b.Mean, 0, 0.02);
            Assert.InRange(a.Mean, b.Mean - (5 * deviation), b.Mean + (5 * deviation));
        }
    }

    [Fact]
    public void Whitted_sees_what_one_can_compute()
    {
        // A point light beside a floor, seen in a mirror: colour/π · I/d² · cosine; and ambient light on both.
        const string Scene = """
            "camera": { "position": [0, 1, 0], "lookAt": [0, 1, -1], "fieldOfView": 0.001 }, "render": { "width": 1, "height": 1, "samplesPerPixel": 1, "integrator": "report", "sampler": "independent" },
            "ambient": [0.1, 0, 0], "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.5, 0.5, 0.5] } },
            { "type": "point", "position": [0, 2, 0], "intensity": [8, 8, 8] }, { "type": "plane", "point": [0, 1, -1], "normal": [0, -1, 1], "material": { "type": "conductor" } } ]
            """;
        ImageSamples seen = Editions.Textbook(Editions.LoadText(Whole(Scene)), 2, "whitted");
        double expected = 0.5 / Math.PI * 8 * 2 / Math.Pow(5, 1.5);
        Assert.Equal(expected + 0.05 + 0.1, seen.Value(0, 0), 5);
        Assert.Equal(expected, seen.Value(0, 1), 5);
    }

    [Fact]
    public void The_listing_as_printed_shows_no_lamp_on_what_the_camera_sees()
    {
        const string Scene = """CAMERA, "render": { "integrator": "report", "maxDiffuseDepth": 0, "maxSpecularDepth": 0, RENDER }, "shapes": [ FLOOR ], LAMP""";
        SceneLoadResult load = Editions.LoadText(Whole(Scene));
        Block floor = new(0, 12, 24, 4);
        Assert.Equal(0, Editions.Textbook(load, 2, "printed").Estimate(floor, 1).Mean);
        Assert.True(Editions.Textbook(load, 2).Estimate(floor, 1).Mean > 0.01);
    }

    private static string Whole(string scene) => "{ " + scene
        .Replace("CAMERA", "\"camera\": { \"position\": [0, 1.3, 4.4], \"lookAt\": [0, 0.75, 0], \"fieldOfView\": 36 }", StringComparison.Ordinal)
        .Replace("RENDER", "\"width\": 24, \"height\": 16, \"samplesPerPixel\": 64, \"sampler\": \"independent\"", StringComparison.Ordinal)
        .Replace("FLOOR", "{ \"type\": \"plane\", \"point\": [0, 0, 0], \"normal\": [0, 1, 0], \"material\": { \"type\": \"diffuse\", \"color\": [0.6, 0.5, 0.4] } }", StringComparison.Ordinal)
        .Replace("FLAT", "{ \"type\": \"plane\", \"point\": [0, 0, 0], \"normal\": [0, 1, 0], \"size\": [8, 8], \"material\": { \"type\": \"diffuse\", \"color\": [0.6, 0.5, 0.4] } }", StringComparison.Ordinal)
        .Replace("SMALL", "{ \"type\": \"plane\", \"point\": [0, 0, 0], \"normal\": [0, 1, 0], \"size\": [3, 3] }", StringComparison.Ordinal)
        .Replace("BALLS", "{ \"type\": \"sphere\", \"center\": [-0.8, 0.7, 0], \"radius\": 0.7, \"material\": { \"type\": \"phongMetal\", \"exponent\": 40 } }, { \"type\": \"sphere\", \"center\": [0.8, 0.7, 0], \"radius\": 0.7 }", StringComparison.Ordinal)
        .Replace("LAMP", "\"lights\": [ { \"type\": \"sphere\", \"center\": [1.6, 3.4, 2.2], \"radius\": 0.8, \"material\": { \"type\": \"luminaire\", \"multiplier\": 4 } } ]", StringComparison.Ordinal) + " }";

    internal static string[] Names(params string[] folder) =>
        [.. Directory.GetFiles(ProjectFolder.PathOf(folder), "*.json").Select(f => Path.GetFileNameWithoutExtension(f)).Order(StringComparer.Ordinal)];

    private void Compare(string name, string[] path, (int Width, int Height)? size)
    {
        SceneDescription Small(SceneDescription d) => d with
        {
            Render = d.Render with { SamplesPerPixel = 16, Width = size?.Width ?? d.Render.Width, Height = size?.Height ?? d.Render.Height },
        };
        SceneLoadResult load = Editions.Load(ProjectFolder.PathOf(path), Small);
        Compare(name, load);
    }

    private void Compare(string name, SceneLoadResult load)
    {
        ImageSamples textbook = Editions.Textbook(load, s_seeds);
        ImageSamples fast = Editions.Fast(load, s_seeds);
        output.WriteLine($"{name}: {BlockTest.Compare(textbook, fast)}");
        ImageAssert.SameExpectation(textbook, fast, ErrorBudget.Textbook, $"textbook-{name}");
    }
}
