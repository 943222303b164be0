using System.Text.RegularExpressions;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Scenes.Tests;

/// <summary>The scenes of the report and of the primer, and the gallery that shows them.</summary>
public partial class ShippedScenesTests
{
    private static readonly string Gallery = ProjectFolder.PathOf("docs", "gallery.md");

    public static TheoryData<string> Files => new(Names("report").Concat(Names("primer")));

    [Theory]
    [MemberData(nameof(Files))]
    public void Shipped_scene_loads_without_diagnostics(string file)
    {
        SceneLoadResult result = SceneLoader.Load(PathOf(file));

        Assert.Empty(result.Diagnostics);
        Assert.NotNull(result.Scene);
        Assert.NotEmpty(result.Scene.Shapes);
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void Shipped_scene_begins_with_a_comment_and_names_its_schema(string file)
    {
        string text = File.ReadAllText(PathOf(file));

        Assert.StartsWith("// ", text, StringComparison.Ordinal);
        Assert.Contains("\"$schema\": \"../raytracer.schema.json\"", text, StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void Gallery_shows_and_names_every_shipped_scene(string file)
    {
        string text = File.ReadAllText(Gallery);

        Assert.Contains($"(../scenes/{file})", text, StringComparison.Ordinal);
        Assert.Contains($"(pictures/{Path.GetFileNameWithoutExtension(file)}.", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Scene_names_are_unique()
    {
        IEnumerable<string> titles = Names("report").Concat(Names("primer")).Select(f => Path.GetFileNameWithoutExtension(f).TrimStart([.. "0123456789-"]));

        Assert.Empty(titles.GroupBy(t => t).Where(g => g.Count() > 1).Select(g => g.Key));
    }

    [Fact]
    public void Gallery_names_every_scene_and_shows_all_but_those_that_it_says_it_does_not()
    {
        string text = File.ReadAllText(Gallery);
        int notShown = text.IndexOf("## Not shown", StringComparison.Ordinal);
        string[] scenes = [.. Directory.GetFiles(PathOf(""), "*.json",
            SearchOption.AllDirectories).Select(f => Path.GetRelativePath(PathOf(""), f).Replace('\\', '/'))
            .Where(f => !f.StartsWith("broken/", StringComparison.Ordinal) && f != "raytracer.schema.json")];

        Assert.True(notShown > 0);
        Assert.DoesNotContain(scenes, s => !text.Contains($"(../scenes/{s})", StringComparison.Ordinal));
        Assert.DoesNotContain(
            scenes, s => text[..notShown].Contains($"(../scenes/{s})", StringComparison.Ordinal) != text.Contains($"render scenes/{s} ", StringComparison.Ordinal));
    }

    [Fact]
    public void Every_picture_is_in_the_gallery_and_small_enough()
    {
        IEnumerable<string> shown = PictureLink().Matches(File.ReadAllText(Gallery)).Select(m => m.Groups["name"].Value).Distinct();
        string folder = ProjectFolder.PathOf("docs", "pictures");
        FileInfo[] lessons = new DirectoryInfo(folder).GetFiles();
        FileInfo[] large = new DirectoryInfo(Path.Combine(folder, "gallery")).GetFiles();

        Assert.Equal(lessons.Select(p => p.Name).Concat(large.Select(p => $"gallery/{p.Name}")).Order(StringComparer.Ordinal),
            shown.Order(StringComparer.Ordinal));
        Assert.All(lessons, p => Assert.InRange(p.Length, 1, 250_000));
        Assert.All(large, p => Assert.InRange(p.Length, 1, 600_000));
        Assert.InRange(lessons.Sum(p => p.Length), 1, 6_000_000);
    }

    // Table 6.1 of the report, and the settings named in its section 6.3.
    [Theory]
    [InlineData("scene1", 2, 600)]
    [InlineData("scene2", 9, 600)]
    [InlineData("scene3", 9, 300)]
    public void Report_scene_has_the_primitives_lights_and_sizes_of_table_6_1(string name, int primitives, int side)
    {
        SceneDescription scene = Load(name);

        Assert.Equal(primitives, scene.Shapes.Count);
        Assert.DoesNotContain(scene.Shapes, s => s.Material is LuminaireMaterialDescription);
        Assert.Equal(4, scene.Lights.Count);
        Assert.All(scene.Lights, l => Assert.IsType<SphereDescription>(l));
        Assert.Equal((side, side), (scene.Render.Width, scene.Render.Height));
        Assert.Equal((4, 4), (scene.Render.MaxDiffuseDepth, scene.Render.MaxSpecularDepth));
        Assert.Equal((16, SamplerKind.Jittered), (scene.Render.SamplesPerPixel, scene.Render.Sampler));
    }

    [Fact]
    public void Scene_1_is_a_bicubic_globe_on_a_diffuse_plane_below_four_spot_lights()
    {
        SceneDescription scene = Load("scene1");

        var globe = Assert.IsType<DiffuseSpecularMaterialDescription>(Assert.Single(scene.Shapes.OfType<SphereDescription>()).Material);
        var image = Assert.IsType<ImageTextureDescription>(Assert.IsType<DiffuseMaterialDescription>(globe.Diffuse).Color);
        Assert.Equal(Interpolation.Bicubic, image.Interpolation);
        Assert.IsType<DiffuseMaterialDescription>(Assert.Single(scene.Shapes.OfType<PlaneDescription>()).Material);
        Assert.All(scene.Lights, light =>
        {
            var lamp = Assert.IsType<LuminaireMaterialDescription>(light.Material);
            Assert.Equal((5f, 1f), (lamp.Multiplier, lamp.Exponent));
            Assert.IsType<PhongMetalMaterialDescription>(lamp.Material);
        });
        Assert.True(scene.Ambient.B > scene.Ambient.R && scene.Ambient.R > scene.Ambient.G && scene.Ambient.G > 0, "The ambient light is to be slate blue.");
    }

    [Fact]
    public void Scene_2_has_glass_metal_and_matt_solids_of_one_colour_under_a_blue_sky()
    {
        SceneDescription scene = Load("scene2");
        MaterialDescription[] materials = [.. scene.Shapes.Select(s => s.Material)];

        Assert.Contains(materials, m => m is DielectricMaterialDescription);
        Assert.Contains(materials, m => m is DiffuseMaterialDescription { Color: SolidTextureDescription });
        Assert.Contains(materials, m => m is DiffuseSpecularMaterialDescription);
        Assert.Contains(materials, m => m is PhongMetalMaterialDescription { Color: SolidTextureDescription });
        Assert.Empty(scene.Textures);
        Assert.True(scene.Ambient is { R: 0, G: 0, B: > 0 }, "The ambient light is to be dark blue.");
        Assert.True(scene.Background.B > scene.Background.G && scene.Background.G > scene.Background.R, "The background is to be sky blue.");
    }

    [Fact]
    public void Scene_3_has_the_reports_jitter_of_the_eye_no_ambient_light_and_a_grey_background()
    {
        SceneDescription scene = Load("scene3");

        Assert.Equal(LensShape.EyeJitter, scene.Camera.Lens.Shape);
        Assert.Equal(new System.Numerics.Vector3(1f / 20), scene.Camera.Lens.Jitter);
        Assert.Equal(Rgb.Black, scene.Ambient);
        Assert.True(scene.Background.R == scene.Background.G && scene.Background.G == scene.Background.B && scene.Background.R is > 0.5f and < 1);
        SphereDescription reflecting = Assert.Single(scene.Shapes.OfType<SphereDescription>(), s => s.Name == "reflecting ball");
        Assert.IsType<PhongMetalMaterialDescription>(reflecting.Material);
        Assert.True(reflecting.Center.X > scene.Camera.LookAt.X && reflecting.Center.Z < scene.Camera.LookAt.Z, "The reflecting ball is to be at the upper right.");
    }

    private static IEnumerable<string> Names(string folder) =>
        Directory.GetFiles(ProjectFolder.PathOf("scenes", folder), "*.json").Select(f => $"{folder}/{Path.GetFileName(f)}").Order(StringComparer.Ordinal);

    private static string PathOf(string file) => ProjectFolder.PathOf("scenes", file);

    private static SceneDescription Load(string name) => SceneLoader.Load(PathOf($"report/{name}.json")).Description!;

    [GeneratedRegex(@"\(pictures/(?<name>[^)]+)\)", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex PictureLink();
}
