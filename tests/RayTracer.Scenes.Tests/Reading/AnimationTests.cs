using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Scenes.Tests;

/// <summary>Scenes as they are at a frame of an animation.</summary>
public class AnimationTests
{
    private const string Start = """{ "render": { "integrator": "report", "framesPerSecond": 10 }, "materials": { "paint": { "type": "diffuse", "color": "red" } }, "shapes": [{ "type": "sphere", "name": "my ball", "center": [1, 2, 3], "radius": 1, "material": "paint" }], "animation": [""";

    [Theory]
    [InlineData("linear", 0, 2)]
    [InlineData("linear", 10, 2)]
    [InlineData("linear", 15, 3)]
    [InlineData("linear", 20, 4)]
    [InlineData("linear", 99, 4)]
    [InlineData("smooth", 10, 2)]
    [InlineData("smooth", 12, 2.208)]
    [InlineData("smooth", 15, 3)]
    [InlineData("step", 19, 2)]
    [InlineData("step", 20, 4)]
    public void Number_goes_from_key_to_key(string ease, int frame, double expected)
    {
        SceneDescription scene = At($$"""{ "property": "shapes[0].radius", "keys": [{ "time": 1, "value": 2, "ease": "{{ease}}" }, { "time": 2, "value": 4 }] }""", frame);

        Assert.Equal((float)expected, ((SphereDescription)scene.Shapes[0]).Radius);
    }

    [Fact]
    public void Properties_are_found_by_names_numbers_and_elements()
    {
        SceneDescription scene = At("""
            { "property": "shapes[\"my ball\"].center[1]", "keys": [{ "time": 0, "value": 5 }] },
            { "property": "camera.position", "keys": [{ "time": 0, "value": [0, 0, 8] }, { "time": 1, "value": [0, 0, 4] }] },
            { "property": "camera.lens.apertureRadius", "keys": [{ "time": 0, "value": 0.25 }] },
            { "property": "materials.paint.color", "keys": [{ "time": 0, "value": "#000" }, { "time": 1, "value": [1, 0.5, 0] }] },
            { "property": "background", "keys": [{ "time": 0, "value": "white" }] },
            { "property": "render.seed", "keys": [{ "time": 0, "value": 0 }, { "time": 1, "value": 9 }] }
            """, 5);

        Assert.Equal(new Vector3(1, 5, 3), ((SphereDescription)scene.Shapes[0]).Center);
        Assert.Equal(new Vector3(0, 0, 6), scene.Camera.Position);
        Assert.Equal(0.25f, scene.Camera.Lens.ApertureRadius);
        Assert.Equal(new Rgb(0.5f, 0.25f, 0), Assert.IsType<SolidTextureDescription>(Assert.IsType<DiffuseMaterialDescription>(scene.Shapes[0].Material).Color).Color);
        Assert.Equal(new Rgb(1, 1, 1), scene.Background);
        Assert.Equal(4, scene.Render.Seed);
    }

    [Fact]
    public void Without_a_frame_the_scene_is_as_it_is_written()
    {
        SceneReadResult read = SceneReader.ReadText(Start + """{ "property": "shapes[0].radius", "keys": [{ "time": 0, "value": 2 }] }] }""", "scene.json");

        Assert.Empty(read.Diagnostics);
        Assert.Equal(1, ((SphereDescription)read.Description!.Shapes[0]).Radius);
    }

    [Fact]
    public void Error_that_arises_between_keys_is_found_at_the_frame()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["scene.json"], """
            { "camera": { "position": [0, 0, 5] }, "background": "white",
              "animation": [
                { "property": "camera.position",
                  "keys": [{ "time": 0, "value": [0, 0, 5] }, { "time": 1, "value": [0, 0, -5] }] }
              ] }
            """);

        Assert.Empty(SceneLoader.Load(folder["scene.json"]).Diagnostics);
        Assert.Contains("camera", Assert.Single(SceneLoader.Load(folder["scene.json"], frame: 12).Diagnostics).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Scene_with_tracks_is_written_as_it_was_read()
    {
        SceneReadResult read = SceneReader.ReadText(Start + """{ "property": "camera.up", "keys": [{ "time": 0, "value": [0, 1, 0], "ease": "step" }] }, { "property": "shapes[0].radius", "keys": [{ "time": 0.5, "value": 2 }] }] }""", "scene.json");
        string text = SceneWriter.Write(read.Description!);

        SceneReadResult again = SceneReader.ReadText(text, "again.json");
        Assert.Empty(again.Diagnostics);
        Assert.Equal(text, SceneWriter.Write(again.Description!));
        Assert.Equal(2, ((SphereDescription)SceneReader.ReadText(text, "again.json", frame: 3).Description!.Shapes[0]).Radius);
    }

    private static SceneDescription At(string tracks, int frame)
    {
        SceneReadResult read = SceneReader.ReadText($"{Start}{tracks}] }}", "scene.json", frame: frame);
        Assert.Empty(read.Diagnostics);
        return read.Description!;
    }
}
