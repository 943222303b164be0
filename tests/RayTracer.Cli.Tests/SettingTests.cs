using System.Text.Json;
using RayTracer.Description;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Cli.Tests;

/// <summary><c>--set PATH=VALUE</c>.</summary>
public sealed class SettingTests : IDisposable
{
    private const string Scene = """
        {
          "camera": { "position": [0, 1, 5], "lookAt": [0, 0.5, 0] },
          "render": { "integrator": "report", "width": 24, "height": 16, "samplesPerPixel": 4 },
          "background": "skyblue",
          "textures": { "tiles": { "type": "checker" } },
          "materials": { "glass": { "type": "dielectric" }, "floor": { "type": "diffuse", "color": "tiles" }, "a.b": { "type": "diffuse" } },
          "shapes": [
            { "type": "sphere", "name": "globe", "center": [0, 0.5, 0], "radius": 0.5, "material": "glass" },
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor" },
            { "type": "sphere", "center": [2, 4, 1], "radius": 0.3, "material": { "type": "luminaire", "multiplier": 30 } }
          ]
        }
        """;

    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public SettingTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("\"position\": [0, 1, 5]", "\"position\": [0, 1, 7]", "camera.position[2]=7")]
    [InlineData("\"lookAt\": [0, 0.5, 0]", "\"lookAt\": [0, 0.5, 0], \"fieldOfView\": 35", "camera.fieldOfView=35")]
    [InlineData("\"lookAt\": [0, 0.5, 0]", "\"lookAt\": [0, 0.5, 0], \"lens\": { \"apertureRadius\": 0.1 }", "camera.lens.apertureRadius=1e-1")]
    [InlineData("\"radius\": 0.5", "\"radius\": 0.7", "shapes.globe.radius=0.7")]
    [InlineData("\"radius\": 0.3", "\"radius\": 1", "shapes[2].radius=1")]
    [InlineData("\"material\": \"floor\"", "\"material\": \"a.b\"", "shapes[1].material=a.b")]
    [InlineData("\"a.b\": { \"type\": \"diffuse\" }", "\"a.b\": { \"type\": \"diffuse\", \"color\": [1, 0, 0] }", "materials[\"a.b\"].color=[1, 0, 0]")]
    [InlineData("\"type\": \"dielectric\"", "\"type\": \"diffuse\", \"color\": \"#ff8800\"", "materials.glass={\"type\": \"diffuse\", \"color\": \"#ff8800\"}")]
    [InlineData("\"background\": \"skyblue\",", "\"background\": \"skyblue\", \"objects\": { \"ball\": { \"type\": \"sphere\", \"center\": [0, 0, 0] } },", "objects.ball={\"type\": \"sphere\", \"center\": [0, 0, 0]}")]
    [InlineData("\"multiplier\": 30", "\"multiplier\": 3", "shapes[2].material.multiplier=3")]
    public void A_setting_is_what_the_file_would_say(string from, string to, string setting)
    {
        Assert.Contains(from, Scene, StringComparison.Ordinal);
        SceneDescription set = Read(Scene, setting);
        Assert.Equal(SceneWriter.Write(Read(Scene.Replace(from, to, StringComparison.Ordinal))), SceneWriter.Write(set));
        Assert.NotEqual(SceneWriter.Write(Read(Scene)), SceneWriter.Write(set));
    }

    [Theory]
    [InlineData("camera.fieldOfVew=35", 8, "unknown key \"fieldOfVew\" in \"camera\" (did you mean \"fieldOfView\"?)")]
    [InlineData("camera.fieldOfView=wide", 20, "expected a number for \"fieldOfView\", but found a string")]
    [InlineData("camera.fieldOfView=300", 20, "\"fieldOfView\" must be from 0.001 to 179, but is 300")]
    [InlineData("camera.fieldOfView=", 19, "expected a value after \"=\"")]
    [InlineData("camera.fieldOfView=  ", 19, "expected a value after \"=\"")]
    [InlineData("materials.glas.refractiveIndex=1", 11, "\"materials\" has no \"glas\" (did you mean \"glass\"?)")]
    [InlineData("materials.glass.ior=1.7", 17, "unknown key \"ior\" in a dielectric (did you mean \"refractiveIndex\"?)")]
    [InlineData("materials.new={\"type\":\"difuse\"}", 23, "unknown material type \"difuse\" (did you mean \"diffuse\"?)")]
    [InlineData("shapes[7].radius=1", 7, "\"shapes\" has 3 elements, [0] to [2]: there is no [7]")]
    [InlineData("shapes.glob.radius=2", 8, "nothing in \"shapes\" has the name \"glob\" (did you mean \"globe\"?)")]
    [InlineData("shapes.globe.material=gloss", 23, "unknown material \"gloss\" (did you mean \"glass\"?)")]
    [InlineData("shapes[0].material.color=red", 20, "\"shapes[0].material\" is the name \"glass\": use \"materials.glass.color\"")]
    [InlineData("background.even=red", 12, "\"background\" is the text \"skyblue\", which has no parts")]
    [InlineData("environment.rotation=3", 1, "the scene does not set \"environment\": nothing in it can change unless all of it is set")]
    [InlineData("materials[1].color=red", 10, "\"materials\" has no elements with numbers, but glass, floor, a.b")]
    [InlineData("camera.position=[1, 2", 22, "expected \",\" or \"]\" after a value, but found the end of the value")]
    [InlineData("here.and.there=1", 1, "unknown key \"here\" in the scene: it may have camera, render,")]
    public void A_wrong_setting_is_refused_as_the_file_is(string setting, int column, string message)
    {
        CliRun run = CliRun.Of("check", _scene, "--set", setting);
        Assert.Equal(3, run.Status);
        Assert.StartsWith($"the option --set {setting}, column {column}: error: {message}", run.Output, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("camera", "expected \"=\" and a value at column 7, but found the end")]
    [InlineData("=3", "expected a key at column 1, but found \"=\"")]
    [InlineData("camera..up=3", "expected a key at column 8, but found \".\"")]
    [InlineData("shapes[-1].radius=3", "expected the number of an element from 0, or a name in double quotes, at column 8, but found \"-\"")]
    [InlineData("materials[\"]=3", "expected \"]\" at column 15, but found the end")]
    [InlineData("camera]=3", "expected \".\" or \"[\" at column 7, but found \"]\"")]
    [InlineData("shapes[1=3", "expected \"]\" at column 11, but found the end")]
    public void What_is_no_setting_is_wrong_usage(string word, string message)
    {
        CliRun run = CliRun.Of("info", _scene, "--set", word);
        Assert.Equal(2, run.Status);
        Assert.StartsWith($"raytracer: error: --set {word}: {message}: settings are written PATH=VALUE, as in camera.fieldOfView=35", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Of_two_things_of_one_name_none_is_set()
    {
        const string globe = "{ \"type\": \"sphere\", \"name\": \"globe\"";
        File.WriteAllText(_scene, Scene.Replace(globe, $"{globe}, \"center\": [3, 0, 0] }}, {globe}", StringComparison.Ordinal));
        CliRun run = CliRun.Of("check", _scene, "--set", "shapes.globe.radius=2");
        Assert.StartsWith("the option --set shapes.globe.radius=2, column 8: error: 2 elements of \"shapes\" are called \"globe\": use a number, as in [0]", run.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void A_setting_may_stand_before_that_of_the_type_that_has_its_key()
    {
        SceneDescription set = Read(Scene, "materials.glass.color=red", "materials.glass.type=diffuse");
        Assert.Equal(SceneWriter.Write(Read(Scene, "materials.glass={\"type\": \"diffuse\", \"color\": \"red\"}")), SceneWriter.Write(set));
    }

    [Fact]
    public void A_film_keeps_its_settings()
    {
        string[] set = ["--set", "materials.glass.refractiveIndex=1.7", "--set", "shapes[\"globe\"].center=[0.5, 0.5, 0]"];
        string film = _folder["a.rtfilm"];
        Fine(["render", _scene, "-o", film, "-o", _folder["a.png"], "--quiet", .. set]);
        Fine("verify", film);
        Fine("verify", _folder["a.png"]);
        Fine("resume", film, "--spp", "8", "--quiet");
        Fine("verify", film);
        Assert.Equal(Hash(["render", _scene, "--spp", "8", .. set]), Hash(["merge", film]));
        Assert.NotEqual(Hash(["render", _scene, "--spp", "8"]), Hash(["merge", film]));
        CliRun bad = CliRun.Of(["render", _scene, "--pixel", "3,3", .. set, "--quiet"]);
        Assert.Equal(0, bad.Status);
    }

    [Fact]
    public void Parts_with_other_settings_do_not_merge()
    {
        Fine("render", _scene, "--part", "1/2", "-o", _folder["a.rtfilm"], "--quiet", "--set", "camera.fieldOfView=35");
        Fine("render", _scene, "--part", "2/2", "-o", _folder["b.rtfilm"], "--quiet", "--set", "camera.fieldOfView=36");
        CliRun run = CliRun.Of("merge", _folder["a.rtfilm"], _folder["b.rtfilm"], "-o", _folder["c.png"]);
        Assert.Equal(4, run.Status);
        Assert.Contains("is not of the same picture", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void The_last_of_two_settings_counts_and_options_of_their_own_go_before()
    {
        string[] render = ["render", _scene, "--set", "render.width=12", "--set", "render.width=20"];
        Assert.Equal(20, Json(render).GetProperty("width").GetInt32());
        Assert.Equal(8, Json([.. render, "--width", "8"]).GetProperty("width").GetInt32());
    }

    [Fact]
    public void Models_and_foreign_scenes_are_set_as_what_they_are_in_the_native_format()
    {
        string model = _folder["a.obj"];
        File.WriteAllText(model, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Assert.Equal(30, Json(["render", model, "--spp", "1", "--set", "render.width=30", "--set", "render.height=20"]).GetProperty("width").GetInt32());
        CliRun wrong = CliRun.Of("render", model, "--json", "--set", "camera.fov=30");
        Assert.Equal((3, ""), (wrong.Status, wrong.Output));
        Assert.Contains("the option --set camera.fov=30, column 8: error: unknown key \"fov\" in \"camera\" (did you mean \"fieldOfView\"?)", wrong.Error, StringComparison.Ordinal);
    }

    private static SceneDescription Read(string scene, params string[] settings)
    {
        SceneReadResult read = SceneReader.ReadText(scene, "scene.json", [.. settings.Select(SceneSetting.Parse)]);
        Assert.Empty(read.Diagnostics);
        return read.Description!;
    }

    private static void Fine(params string[] args) => Assert.Equal((0, ""), (CliRun.Of(args) is var run ? run.Status : 0, run.Error));

    private static JsonElement Json(string[] args)
    {
        CliRun run = CliRun.Of([.. args, "--json"]);
        Assert.True(run.Status == 0, run.Error);
        using JsonDocument document = JsonDocument.Parse(run.Output);
        return document.RootElement.Clone();
    }

    private static string Hash(string[] args) => Json(args).GetProperty("filmHash").GetString()!;
}
