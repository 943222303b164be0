using RayTracer.Description;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Scenes.Tests;

public sealed class SceneLoaderTests : IDisposable
{
    private const string Textured = """
        { "render": { "integrator": "report", "samplesPerPixel": 16, "sampler": "jittered" },
          "materials": { "m": { "type": "diffuse", "color": { "type": "image", "file": "sub/marble.png", "raw": true } },
                         "n": { "type": "diffuse", "color": { "type": "image", "file": "sub/marble.png", "raw": true } } },
          "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": "m" }, { "type": "sphere", "center": [0, 0, 0], "material": "n" }], "background": 1 }
        """;

    private readonly string _folder = Directory.CreateTempSubdirectory("scenes").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Pictures_are_looked_for_from_the_scene_files_folder_and_read_once()
    {
        List<(string, bool)> reads = [];
        string marble = Touch("sub", "marble.png");
        SceneLoadResult result = SceneLoader.Load(Write(Textured), readPicture: (path, raw) =>
        {
            reads.Add((Path.GetFullPath(path), raw));
            return new Picture(1, 1);
        });

        Assert.Equal("", Diagnostic.Format(result.Diagnostics));
        Assert.NotNull(result.Scene);
        Assert.Equal([(marble, true)], reads);
    }

    [Fact]
    public void A_missing_picture_is_reported_where_it_is_named()
    {
        Touch("sub", "marbel.png");
        string path = Write(Textured);
        SceneLoadResult result = SceneLoader.Load(path);

        Assert.NotNull(result.Scene);
        Assert.Equal(
            $"{path}:2:80: warning: cannot read \"sub/marble.png\": file not found (did you mean \"marbel.png\"?): a half is used", result.Diagnostics[0].ToString());
    }

    [Theory]
    [InlineData(typeof(PictureException))]
    [InlineData(typeof(IOException))]
    [InlineData(typeof(UnauthorizedAccessException))]
    public void A_picture_that_cannot_be_read_is_reported(Type exception)
    {
        Touch("sub", "marble.png");
        SceneLoadResult result = SceneLoader.Load(Write(Textured), readPicture: (_, _) => throw (Exception)Activator.CreateInstance(exception, "it is torn")!);
        Assert.Equal("cannot read \"sub/marble.png\": it is torn", result.Diagnostics[0].Message);
    }

    [Fact]
    public void Overrides_change_the_scene_before_it_is_built()
    {
        string path = ProjectFolder.PathOf("scenes", "minimal.json");
        SceneLoadResult result = SceneLoader.Load(path, s => s with { Render = s.Render with { Width = 7 } });
        Assert.Equal(7, result.Scene!.Render.Width);
        Assert.Equal(7, result.Description!.Render.Width);
    }

    [Fact]
    public void What_an_override_made_wrong_is_reported_without_a_line()
    {
        string path = Write("""{ "render": { "integrator": "report", "sampler": "jittered", "samplesPerPixel": 16 } }""");
        SceneLoadResult result = SceneLoader.Load(path, s => s with { Render = s.Render with { SamplesPerPixel = 15 } });
        Assert.Equal($"{path}: error: the jittered sampler needs a square number of samples, but 15 is not one: use 9 or 16", Assert.Single(result.Diagnostics).ToString());
        Assert.Null(result.Scene);
    }

    [Fact]
    public void What_the_file_made_wrong_keeps_its_line_when_something_else_is_overridden()
    {
        string path = Write("""{ "render": { "integrator": "report", "sampler": "jittered", "samplesPerPixel": 15 } }""");
        SceneLoadResult result = SceneLoader.Load(path, s => s with { Render = s.Render with { Width = 7 } });
        Assert.StartsWith($"{path}:1:81: error: the jittered", Assert.Single(result.Diagnostics).ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Overrides_are_held_to_the_ranges_of_parameters()
    {
        string path = Write("{}");
        SceneLoadResult result = SceneLoader.Load(path, s => s with { Render = s.Render with { Width = 0 } });
        Assert.Equal($"{path}: error: \"width\" must be from 1 to 65536, but is 0", Assert.Single(result.Diagnostics).ToString());
        Assert.Null(result.Scene);
    }

    [Fact]
    public void A_warning_does_not_keep_a_scene_from_being_rendered()
    {
        SceneLoadResult result = SceneLoader.Load(Write("""{ "camera": { "lens": { "focusDistance": 3 } }, "background": "white" }"""));
        Assert.Equal(Severity.Warning, Assert.Single(result.Diagnostics).Severity);
        Assert.NotNull(result.Scene);
    }

    [Theory]
    [InlineData("path", "\"render\": { \"integrator\": \"INTEGRATOR\", \"weakenedShadows\": true }", "\"weakenedShadows\" has no effect with the integrator path: leave it out, or write \"integrator\": \"report\" under \"render\"")]
    [InlineData("path", "\"ambient\": 0.1, \"render\": { \"integrator\": \"INTEGRATOR\", \"weakenedShadows\": true, \"maxDiffuseDepth\": 2 }", "\"ambient\", \"weakenedShadows\" and \"maxDiffuseDepth\" have no effect with the integrator path: leave them out, or write \"integrator\": \"report\" under \"render\"")]
    [InlineData("report", "\"render\": { \"integrator\": \"INTEGRATOR\", \"maxDepth\": 2 }", "\"maxDepth\" has no effect with the integrator report: leave it out, or write \"integrator\": \"path\" under \"render\"")]
    [InlineData("report", "\"render\": { \"integrator\": \"INTEGRATOR\", \"hideLights\": true }", "\"hideLights\" has no effect with the integrator report: leave it out, or write \"integrator\": \"path\" under \"render\"")]
    [InlineData("path", "\"render\": { \"integrator\": \"INTEGRATOR\", \"straightThrough\": true }", "\"straightThrough\" has no effect with the integrator path: leave it out, or write \"integrator\": \"volPath\" under \"render\"")]
    [InlineData("path", "\"render\": { \"integrator\": \"INTEGRATOR\", \"occlusionDistance\": 2 }", "\"occlusionDistance\" has no effect with the integrator path: leave it out, or write \"integrator\": \"ao\" under \"render\"")]
    [InlineData("report", "\"render\": { \"integrator\": \"INTEGRATOR\" }, \"shapes\": [{ \"type\": \"sphere\", \"center\": [0, 0, 0], \"material\": { \"type\": \"dielectric\", \"priority\": 1 } }]", "there are dielectrics with priorities, which only the path, direct, volPath, light, bidirectional, photons and vcm integrators support")]
    [InlineData("direct", "\"render\": { \"integrator\": \"INTEGRATOR\" }, \"shapes\": [{ \"type\": \"sphere\", \"center\": [0, 0, 0], \"material\": { \"type\": \"mask\", \"material\": { \"type\": \"diffuse\" }, \"interior\": { \"extinction\": [1, 1, 1] } } }]", "there are media inside shapes, which only the path, volPath, light, bidirectional, photons and vcm integrators show")]
    public void What_an_integrator_does_not_know_is_warned_of(string integrator, string scene, string warning)
    {
        SceneLoadResult result = SceneLoader.Load(Write($"{{ \"background\": \"white\", {scene.Replace("INTEGRATOR", integrator, StringComparison.Ordinal)} }}"));
        Assert.Equal(warning, Assert.Single(result.Diagnostics).Message);
        Assert.NotNull(result.Scene);
    }

    [Theory]
    [InlineData("principled", "point", "lights without extent do not light this material")]
    [InlineData("plastic", "point", "lights without extent do not light this material")]
    [InlineData("roughConductor", "sphere", "small lamps light this material by rare chance only")]
    [InlineData("diffuse", "point", null)]
    [InlineData("roughConductor", "large", null)]
    public void Materials_for_which_the_report_samples_no_lights_are_warned_of_once(string material, string light, string? unlit)
    {
        string lamp = light == "point" ? "{ \"type\": \"point\", \"position\": [0, 5, 3] }"
            : $"{{ \"type\": \"sphere\", \"center\": [0, 5, 3], \"radius\": {(light == "large" ? 1 : 0.01)}, \"material\": {{ \"type\": \"luminaire\" }} }}";
        string path = Write($$"""
            {
              "materials": { "m": { "type": "{{material}}" } },
              "render": { "integrator": "report" }, "lights": [{{lamp}}],
              "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": "m" }, { "type": "sphere", "center": [2, 0, 0], "material": "m" }]
            }
            """);
        string expected = unlit is null ? "" : $"{path}:2:23: warning: with the integrator report, {unlit}: write \"integrator\": \"path\" under \"render\"";
        Assert.Equal(expected, Diagnostic.Format(SceneLoader.Load(path).Diagnostics).Trim());
        Assert.Empty(SceneLoader.Load(path, s => s with { Render = s.Render with { Integrator = Integrator.Path } }).Diagnostics);
    }

    [Theory]
    [InlineData("{}", 1, "nothing shines, so the picture is black: add a light, a luminaire, a \"background\" or an \"environment\"")]
    [InlineData("{ \"ambient\": 1, \"render\": { \"integrator\": \"report\" } }", 0, null)]
    [InlineData("{ \"render\": { \"integrator\": \"normals\" } }", 0, null)]
    [InlineData("BALL }", 27, "the camera is inside of an opaque thing without a light, so the picture is black")]
    [InlineData("BALL, \"lights\": [{ \"type\": \"point\", \"position\": [0, 0.5, 0] }] }", 0, null)]
    [InlineData("BALL, \"lights\": [{ \"type\": \"point\", \"position\": [0, 5, 0] }] }", 27, "the camera is inside of an opaque thing without a light, so the picture is black")]
    [InlineData("GLASS }", 0, null)]
    [InlineData("{ \"shapes\": [{ \"type\": \"sphere\", \"center\": [0, 0, 0], \"material\": { \"type\": \"invisible\", \"interior\": { \"emission\": 1 } } }] }", 0, null)]
    public void Pictures_that_are_black_are_warned_of(string scene, int column, string? warning)
    {
        const string ball = "{ \"camera\": { \"position\": [0, 0, 0.5] }, \"background\": \"white\", \"shapes\": [{ \"type\": \"sphere\", \"center\": [0, 0, 0]";
        string path = Write(scene.Replace("BALL", ball + " }]", StringComparison.Ordinal)
            .Replace("GLASS", ball + ", \"material\": { \"type\": \"dielectric\" } }]", StringComparison.Ordinal));
        string expected = warning is null ? "" : $"{path}:1:{column}: warning: {warning}";
        Assert.Equal(expected, Diagnostic.Format(SceneLoader.Load(path).Diagnostics).Trim());
    }

    [Fact]
    public void Consequences_of_an_error_are_not_reported()
    {
        SceneLoadResult result = SceneLoader.Load(Write("""{ "camera": { "position": [0, 0, 0], "lookAt": [0, 0] } }"""));
        Assert.Equal("expected 3 numbers for \"lookAt\", but found 2", Assert.Single(result.Diagnostics).Message);
    }

    [Fact]
    public void Every_shipped_scene_loads()
    {
        IEnumerable<string> scenes = Directory.EnumerateFiles(ProjectFolder.PathOf("scenes"), "*.json", SearchOption.AllDirectories)
            .Where(f => Path.GetFileName(Path.GetDirectoryName(f)) != "broken" && !f.EndsWith(".schema.json", StringComparison.Ordinal));
        Assert.NotEmpty(scenes);
        Assert.All(scenes, f => Assert.Equal("", Diagnostic.Format(SceneLoader.Load(f).Diagnostics)));
    }

    [Fact]
    public void The_reference_pages_example_loads() =>
        Assert.Equal("", Diagnostic.Format(SceneLoader.Load(Write(SceneReference.Example)).Diagnostics));

    private string Touch(params string[] parts)
    {
        string path = Path.Combine([_folder, .. parts]);
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllText(path, "not empty");
        return path;
    }

    private string Write(string text)
    {
        string path = Path.Combine(_folder, "scene.json");
        File.WriteAllText(path, text);
        return path;
    }
}
