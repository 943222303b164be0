using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Scenes.Tests;

/// <summary>Paths of properties, which mean the same to <c>--set</c> and to the tracks of an animation.</summary>
public class PropertyPathTests
{
    private const string Scene = """
        {
          "camera": { "position": [0, 2, 5] },
          "background": "skyblue",
          "textures": { "tiles": { "type": "checker", "even": [0, 0, 0] } },
          "materials": {
            "glass": { "type": "dielectric" }, "floor": { "type": "diffuse", "color": "tiles" }, "a.b": { "type": "diffuse", "color": [0, 0, 0] },
            "c=d": { "type": "diffuse", "color": [0, 0, 0] }, "7": { "type": "diffuse", "color": "red" }, "board": { "type": "diffuse", "color": { "type": "checker", "scale": [2, 2] } }
          },
          "objects": { "tree": { "type": "sphere", "center": [0, 0, 0], "transform": [{ "translate": [0, 3, 0] }] } },
          "shapes": [
            { "type": "sphere", "name": "globe", "center": [0, 0.5, 0], "radius": 0.5, "material": "glass" },
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "a.b" },
            { "type": "sphere", "name": "twin", "center": [2, 4, 1], "material": { "type": "luminaire", "multiplier": 30 } },
            { "type": "sphere", "name": "twin", "center": [3, 4, 1], "radius": 0.3 },
            { "type": "sphere", "name": "1", "center": [4, 4, 1], "radius": 0.3 },
            { "type": "instance", "of": "tree" }
          ],
          "lights": [],
          "animation": [/**/]
        }
        """;

    [Theory]
    [InlineData("render.seed")]
    [InlineData("camera.fieldOfView")]
    [InlineData("camera.position[1]")]
    [InlineData("camera.lens.apertureRadius")]
    [InlineData("[\"camera\"].[\"position\"][2]")]
    [InlineData("shapes.globe.radius")]
    [InlineData("shapes[\"globe\"].center[0]")]
    [InlineData("shapes[3].radius")]
    [InlineData("shapes.3.radius")]
    [InlineData("shapes.1.radius")]
    [InlineData("shapes[\"1\"].radius")]
    [InlineData("shapes[2].material.multiplier")]
    [InlineData("materials.glass.refractiveIndex")]
    [InlineData("materials[\"a.b\"].color[0]")]
    [InlineData("materials[\"c=d\"].color[1]")]
    [InlineData("textures.tiles.even[2]")]
    [InlineData("materials.board.color.scale[1]")]
    [InlineData("objects.tree.transform[0].translate[1]")]
    public void Path_leads_a_track_and_a_setting_to_the_same_place(string path)
    {
        SceneReadResult track = Track(path, 0);
        SceneReadResult setting = Setting(path);
        Assert.Empty(track.Diagnostics);
        Assert.Empty(setting.Diagnostics);
        Assert.Equal(SceneWriter.Write(setting.Description!), SceneWriter.Write(track.Description! with { Animation = [] }));
        Assert.NotEqual(SceneWriter.Write(SceneReader.ReadText(Scene, "scene.json").Description!), SceneWriter.Write(setting.Description!));
    }

    [Theory]
    [InlineData("shape.globe.radius", 1, "unknown key \"shape\" in the scene (did you mean \"shapes\"?)")]
    [InlineData("xyzzy.globe", 1, "unknown key \"xyzzy\" in the scene: it may have camera, render, background, environment, ambient, textures, materials, objects, shapes, lights, animation")]
    [InlineData("camera.fov", 8, "unknown key \"fov\" in \"camera\" (did you mean \"fieldOfView\"?)")]
    [InlineData("shapes[0].raduis", 11, "unknown key \"raduis\" in a sphere (did you mean \"radius\"?)")]
    [InlineData("materials.glass.type.x", 22, "\"materials.glass.type\" is the text \"dielectric\", which has no parts")]
    [InlineData("materials.glas.color", 11, "\"materials\" has no \"glas\" (did you mean \"glass\"?)")]
    [InlineData("materials[1].color", 10, "\"materials\" has no elements with numbers, but glass, floor, a.b, c=d, 7, board")]
    [InlineData("shapes[6].radius", 7, "\"shapes\" has 6 elements, [0] to [5]: there is no [6]")]
    [InlineData("shapes[99999999999].radius", 7, "\"shapes\" has 6 elements, [0] to [5]: there is no [99999999999]")]
    [InlineData("lights[0].radius", 7, "\"lights\" has no elements: there is no [0]")]
    [InlineData("objects.tree.transform[1].translate", 23, "\"objects.tree.transform\" has one element, [0]: there is no [1]")]
    [InlineData("shapes.glob.radius", 8, "nothing in \"shapes\" has the name \"glob\" (did you mean \"globe\"?)")]
    [InlineData("shapes.twin.radius", 8, "2 elements of \"shapes\" are called \"twin\": use a number, as in [2]")]
    [InlineData("camera.position.x", 17, "\"camera.position\" has 3 elements, [0] to [2], and none has the name \"x\"")]
    [InlineData("camera.position[3]", 16, "\"camera.position\" has 3 elements, [0] to [2]: there is no [3]")]
    [InlineData("camera.position[1].x", 20, "\"camera.position[1]\" is 2, which has no parts")]
    [InlineData("camera.up[1]", 8, "the scene does not set \"camera.up\": nothing in it can change unless all of it is set")]
    [InlineData("environment.rotation", 1, "the scene does not set \"environment\": nothing in it can change unless all of it is set")]
    [InlineData("background[0]", 11, "\"background\" is the text \"skyblue\", which has no parts")]
    [InlineData("shapes[0].material.refractiveIndex", 20, "\"shapes[0].material\" is the name \"glass\": use \"materials.glass.refractiveIndex\"")]
    [InlineData("shapes[1].material.color[0]", 20, "\"shapes[1].material\" is the name \"a.b\": use \"materials[\"a.b\"].color[0]\"")]
    [InlineData("materials.floor.color.even[0]", 23, "\"materials.floor.color\" is the name \"tiles\": use \"textures.tiles.even[0]\"")]
    [InlineData("shapes[5].of.radius", 14, "\"shapes[5].of\" is the name \"tree\": use \"objects.tree.radius\"")]
    public void Wrong_path_is_refused_with_the_same_words_in_a_track_and_a_setting(string path, int column, string message)
    {
        Diagnostic track = Assert.Single(Track(path, null).Diagnostics);
        Assert.Equal(message, track.Message);
        Assert.Equal("  \"animation\": [{ \"property\": ".Length + 1, track.Column);
        Assert.Equal(track with { File = $"the option --set {path}=1", Line = 0, Column = column }, Assert.Single(Setting(path).Diagnostics));
    }

    [Theory]
    [InlineData("", "expected a key at column 1, but found the end")]
    [InlineData(".camera", "expected a key at column 1, but found \".\"")]
    [InlineData("camera..up", "expected a key at column 8, but found \".\"")]
    [InlineData("camera.", "expected a key at column 8, but found the end")]
    [InlineData("camera]", "expected \".\" or \"[\" at column 7, but found \"]\"")]
    [InlineData("a\"b", "expected \".\" or \"[\" at column 2, but found \"\"\"")]
    [InlineData("shapes[0]radius", "expected \".\" or \"[\" at column 10, but found \"r\"")]
    [InlineData("shapes[-1].radius", "expected the number of an element from 0, or a name in double quotes, at column 8, but found \"-\"")]
    [InlineData("shapes[globe].radius", "expected the number of an element from 0, or a name in double quotes, at column 8, but found \"g\"")]
    [InlineData("shapes[1", "expected \"]\" at column 9, but found the end")]
    [InlineData("materials[\"]", "expected \"]\" at column 13, but found the end")]
    public void What_is_no_path_is_refused_with_the_same_words_in_a_track_and_a_setting(string text, string message)
    {
        Assert.Equal($"{Quotation.Of(text)} is not a property path: {message}", Assert.Single(Track(text, null).Diagnostics).Message);
        Assert.StartsWith($"{message}: settings are written", Assert.Throws<FormatException>(() => SceneSetting.Parse(text)).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("camera", "is not a single value: name one of its numbers, vectors or colours")]
    [InlineData("render", "is not a single value: name one of its numbers, vectors or colours")]
    [InlineData("shapes.globe", "is not a single value: name one of its numbers, vectors or colours")]
    [InlineData("materials.board.color", "is not a single value: name one of its numbers, vectors or colours")]
    [InlineData("materials.floor.color", "cannot be animated: only numbers, vectors and colours can")]
    [InlineData("materials.glass.type", "cannot be animated: only numbers, vectors and colours can")]
    [InlineData("shapes.globe.name", "cannot be animated: only numbers, vectors and colours can")]
    public void Only_numbers_vectors_and_colours_can_be_animated(string path, string message) =>
        Assert.Equal($"\"{path}\" {message}", Assert.Single(Track(path, null).Diagnostics).Message);

    [Fact]
    public void Thing_of_unknown_type_can_be_set_but_not_animated()
    {
        const string track = """{ "property": "materials.glass.color", "keys": [{ "time": 0, "value": 1 }] }""";
        string scene = Scene.Replace("dielectric", "dielectrik", StringComparison.Ordinal);
        const string unknown = "unknown material type \"dielectrik\" (did you mean \"dielectric\"?)";
        Assert.Equal([unknown, "\"materials.glass\" has no known type"],
            SceneReader.ReadText(scene.Replace("/**/", track, StringComparison.Ordinal), "scene.json").Diagnostics.Select(d => d.Message));
        Assert.Equal([unknown], SceneReader.ReadText(scene, "scene.json", [SceneSetting.Parse("materials.glass.color=1")]).Diagnostics.Select(d => d.Message));
        Assert.Empty(SceneReader.ReadText(scene, "scene.json", [SceneSetting.Parse("materials.glass.type=dielectric")]).Diagnostics);
    }

    [Fact]
    public void A_sign_of_equality_ends_the_path_of_a_setting_alone()
    {
        Assert.Equal("materials.c", SceneSetting.Parse("materials.c=d.color=1").Path);
        Assert.EndsWith("expected \".\" or \"[\" at column 12, but found \"=\"", Assert.Single(Track("materials.c=d.color", null).Diagnostics).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("a.b")]
    [InlineData("c=d")]
    [InlineData("7")]
    [InlineData("board")]
    public void Address_of_a_named_thing_is_written_so_that_it_leads_there_again(string name)
    {
        JsonNode root = SceneReader.ReadText(Scene, "scene.json").Root!;
        PropertyAddress address = new(["materials", name, "color"], [false, false, false]);
        Assert.Equal(address.Steps, PropertyAddress.Find(root, address.Path(root))!.Steps);
    }

    private static SceneReadResult Track(string path, int? frame) => SceneReader.ReadText(
        Scene.Replace("/**/", $$"""{ "property": "{{path.Replace("\"", "\\\"", StringComparison.Ordinal)}}", "keys": [{ "time": 0, "value": 1 }] }""", StringComparison.Ordinal),
        "scene.json", frame: frame);

    private static SceneReadResult Setting(string path) => SceneReader.ReadText(Scene, "scene.json", [SceneSetting.Parse($"{path}=1")]);
}
