using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Scenes.Tests;

public class SceneReaderTests
{
    [Fact]
    public void Values_of_every_kind_are_read()
    {
        SceneDescription scene = Read("""
            {
              "camera": { "position": [1, 2.5, -3e1], "fieldOfView": 33, "fieldOfViewAxis": "larger", "lens": { "shape": "eyeJitter" } },
              "render": { "integrator": "report", "width": 6e1, "samplesPerPixel": 9, "sampler": "regular", "seed": 4294967295 },
              "background": "#fff",
              "ambient": [0.25, 0, 7],
              "textures": { "wood": { "type": "image", "file": "wood.png", "raw": true, "interpolation": "bicubic", "scale": [2, -1] } },
              "shapes": [
                { "type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "size": [2, 3], "name": "wall",
                  "material": { "type": "diffuse", "color": "wood" } },
                { "type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1] },
              ],
            }
            """);

        Assert.Equal(new Vector3(1, 2.5f, -30), scene.Camera.Position);
        Assert.Equal((33f, FieldOfViewAxis.Larger, LensShape.EyeJitter), (scene.Camera.FieldOfView, scene.Camera.FieldOfViewAxis, scene.Camera.Lens.Shape));
        Assert.Equal((60, 600, 9, SamplerKind.Regular, 4294967295), (scene.Render.Width, scene.Render.Height, scene.Render.SamplesPerPixel, scene.Render.Sampler, scene.Render.Seed));
        Assert.Equal((Rgb.White, new Rgb(0.25f, 0, 7)), (scene.Background, scene.Ambient));
        ImageTextureDescription wood = Assert.IsType<ImageTextureDescription>(scene.Textures["wood"]);
        Assert.Equal(new ImageTextureDescription { File = "wood.png", Raw = true, Interpolation = Interpolation.Bicubic, Scale = new(2, -1) }, wood);
        PlaneDescription wall = Assert.IsType<PlaneDescription>(scene.Shapes[0]);
        Assert.Equal((new Vector2(2, 3), "wall"), (wall.Size, wall.Name));
        Assert.Same(wood, Assert.IsType<DiffuseMaterialDescription>(wall.Material).Color);
        Assert.Null(Assert.IsType<PlaneDescription>(scene.Shapes[1]).Size);
    }

    [Fact]
    public void Choices_are_read_whatever_their_case_and_written_as_they_are_called()
    {
        SceneDescription scene = Read("""{ "render": { "integrator": "volpath", "sampler": "JITTERED" }, "camera": { "fieldOfViewAxis": "Larger" } }""");
        Assert.Equal((Integrator.VolPath, SamplerKind.Jittered, FieldOfViewAxis.Larger), (scene.Render.Integrator, scene.Render.Sampler, scene.Camera.FieldOfViewAxis));
        Assert.All(["\"volPath\"", "\"jittered\"", "\"larger\""], word => Assert.Contains(word, SceneWriter.Write(scene), StringComparison.Ordinal));
    }

    [Fact]
    public void Named_things_are_shared_whatever_their_order()
    {
        SceneDescription scene = Read("""
            {
              "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": "alias" }, { "type": "sphere", "center": [0, 0, 0], "material": "coat" }],
              "materials": {
                "alias": "coat",
                "coat": { "type": "diffuseSpecular", "diffuse": "matt" },
                "matt": { "type": "diffuse", "color": "board" },
              },
              "textures": { "board": { "type": "checker", "even": "stone", "odd": "black" }, "stone": "#808080" },
            }
            """);

        DiffuseSpecularMaterialDescription coat = Assert.IsType<DiffuseSpecularMaterialDescription>(scene.Materials["coat"]);
        Assert.Same(coat, scene.Materials["alias"]);
        Assert.All(scene.Shapes, s => Assert.Same(coat, s.Material));
        Assert.Same(scene.Materials["matt"], coat.Diffuse);
        CheckerTextureDescription board = Assert.IsType<CheckerTextureDescription>(scene.Textures["board"]);
        Assert.Same(scene.Textures["stone"], board.Even);
        Assert.Equal(["alias", "coat", "matt"], scene.Materials.Keys);
    }

    [Fact]
    public void What_a_file_leaves_out_has_its_default()
    {
        SceneDescription scene = Read("{}");
        Assert.Equal(new CameraDescription(), scene.Camera);
        Assert.Equal(new RenderDescription(), scene.Render);
        Assert.Empty(scene.Shapes);
    }

    [Fact]
    public void Source_map_finds_records_and_their_values()
    {
        const string Text = """{ "camera": { "up": [0, 1, 0] }, "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": { "type": "diffuse", "color": "red" } }] }""";
        SceneReadResult result = SceneReader.ReadText(Text, "test.json");
        SceneDescription scene = result.Description!;

        Assert.Equal("[0, 1, 0]", Source(result, scene.Camera, nameof(CameraDescription.Up)));
        Assert.Equal("""{ "up": [0, 1, 0] }""", Source(result, scene.Camera, nameof(CameraDescription.LookAt)));
        Assert.Equal("[0, 0, 0]", Source(result, scene.Shapes[0], nameof(SphereDescription.Center)));
        Assert.Equal("\"red\"", Source(result, ((DiffuseMaterialDescription)scene.Shapes[0].Material).Color, null));
        Assert.Equal(Text, Source(result, scene, null));
        Assert.Null(result.SourceMap.Find(scene.Render));
        Assert.Null(result.SourceMap.Find(scene.Camera with { }));
    }

    [Fact]
    public void All_errors_are_reported_at_once_by_position_and_at_most_20_are_shown()
    {
        string shapes = string.Join(",\n", Enumerable.Repeat("""{ "type": "sphere", "centre": [0, 0, 0] }""", 15));
        SceneReadResult result = SceneReader.ReadText($"{{ \"shapes\": [\n{shapes}\n] }}", "many.json");

        Assert.Null(result.Description);
        Assert.Equal(30, result.Diagnostics.Count);
        Assert.Equal(result.Diagnostics.OrderBy(d => d.Line).ThenBy(d => d.Column), result.Diagnostics);
        string[] shown = Diagnostic.Format(result.Diagnostics).Split('\n');
        Assert.Equal(21, shown.Length);
        Assert.Equal("many.json:2:1: error: a sphere needs \"center\"", shown[0]);
        Assert.Equal("many.json:2:21: error: unknown key \"centre\" in a sphere (did you mean \"center\"?)", shown[1]);
        Assert.Equal("and 10 more", shown[20]);
    }

    [Fact]
    public void A_missing_file_is_reported_with_the_nearest_name()
    {
        string folder = ProjectFolder.PathOf("scenes");
        Assert.Equal("error: file not found (did you mean \"minimal.json\"?)", Complaint(Path.Combine(folder, "minimum.json")));
        Assert.Equal("error: file not found", Complaint(Path.Combine(folder, "nothing-of-the-kind")));
        Assert.Equal("error: file not found: its folder does not exist", Complaint(Path.Combine(folder, "none", "x.json")));
        Assert.Equal("error: it is a folder, not a file", Complaint(folder));
        Assert.Equal("error: file not found", Complaint(""));
        Assert.Equal("error: file not found", Complaint("a\0b"));
    }

    [Fact]
    public void A_long_chain_of_names_ends_at_the_limit_of_nesting()
    {
        string chain = string.Join(", ", Enumerable.Range(0, 20_000).Select(i => $"\"m{i}\": \"m{i + 1}\""));
        SceneReadResult result = SceneReader.ReadText($"{{ \"materials\": {{ {chain}, \"m20000\": {{ \"type\": \"diffuse\" }} }} }}", "chain.json");
        Assert.Contains(result.Diagnostics, d => d.Message == "materials are nested more than 16 deep");
    }

    private static string Complaint(string path)
    {
        Diagnostic only = Assert.Single(SceneReader.Read(path).Diagnostics);
        Assert.Equal((path, 0, 0), (only.File, only.Line, only.Column));
        return only.ToString()[(path.Length + 2)..];
    }

    private static string Source(SceneReadResult result, object record, string? property)
    {
        JsonNode node = result.SourceMap.Find(record, property)!;
        return result.Source!.Text[node.Start..node.End];
    }

    private static SceneDescription Read(string text)
    {
        SceneReadResult result = SceneReader.ReadText(text, "test.json");
        Assert.Equal("", Diagnostic.Format(result.Diagnostics));
        return result.Description!;
    }

    [Theory]
    [InlineData("\"background\": 0.5", "\"background\": [0.5, 0.5, 0.5]")]
    [InlineData("\"shapes\": [{ \"type\": \"sphere\", \"center\": [0, 0, 0], \"material\": { \"type\": \"diffuse\", \"color\": 0.25 } }]", "\"shapes\": [{ \"type\": \"sphere\", \"center\": [0, 0, 0], \"material\": { \"type\": \"diffuse\", \"color\": [0.25, 0.25, 0.25] } }]")]
    [InlineData("\"lights\": [{ \"type\": \"point\", \"position\": [0, 1, 0], \"intensity\": 5 }]", "\"lights\": [{ \"type\": \"point\", \"position\": [0, 1, 0], \"intensity\": [5, 5, 5] }]")]
    [InlineData("\"camera\": { \"transform\": { \"scale\": 4, \"rotate\": 30 } }", "\"camera\": { \"transform\": [{ \"scale\": [4, 4, 4], \"rotate\": 30 }] }")]
    public void Short_forms_mean_the_long_ones(string shortForm, string longForm) =>
        Assert.Equal(SceneWriter.Write(Scene($"{{ {longForm} }}")), SceneWriter.Write(Scene($"{{ {shortForm} }}")));

    private static SceneDescription Scene(string text) => SceneReader.ReadText(text, "a.json").Description!;
}
