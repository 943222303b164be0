using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.RenderTests.Meshes;

/// <summary>
/// Scenes that are written differently and must look the same: a thing moved, and the thing made of moved numbers.
/// Covers `InstanceTree`, `InstanceMaps` and `InstancedLight`.
/// </summary>
[Trait("Category", "Thorough")]
public class PlacedScenesTests
{
    private const string Cube = """
        "positions": [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]],
        "triangles": [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [3, 7, 6], [3, 6, 2], [0, 4, 7], [0, 7, 3], [1, 2, 6], [1, 6, 5]]
        """;

    private const string Octahedron = """
        "positions": [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]],
        "triangles": [[4, 0, 2], [0, 5, 2], [5, 1, 2], [1, 4, 2], [0, 4, 3], [5, 0, 3], [1, 5, 3], [4, 1, 3]]
        """;

    private const string Normals = """
        "normals": [[0.8, 0, 0.6], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0.6, 0.8], [0, 0, -1]]
        """;

    private static readonly int s_seeds = TestSettings.Scale(24, 128);

    [Theory]
    [InlineData(
        """{ "type": "sphere", "center": [0.5, 0.25, 0], "radius": 0.5, "transform": [{ "scale": [2, 2, 2], "translate": [0, -0.5, 0] }] }""",
        """{ "type": "sphere", "center": [1, 0, 0], "radius": 1 }""")]
    [InlineData(
        """{ "type": "triangle", "a": [-1, 0, 0], "b": [1, 0, 0], "c": [0, 1, 0], "transform": [{ "rotate": 90, "axis": [0, 0, 1] }, { "translate": [0.5, 0, 0] }] }""",
        """{ "type": "triangle", "a": [0.5, -1, 0], "b": [0.5, 1, 0], "c": [-0.5, 0, 0] }""")]
    [InlineData(
        """{ "type": "group", "transform": [{ "translate": [1, 0, 0] }], "shapes": [{ "type": "group", "transform": [{ "scale": [0.5, 0.5, 0.5] }], "shapes": [{ "type": "sphere", "center": [0, 1, 0] }] }] }""",
        """{ "type": "sphere", "center": [1, 0.5, 0], "radius": 0.5 }""")]
    [InlineData(
        """{ "type": "mesh", CUBE, "transform": [{ "matrix": [0, 0, 1, 0.5, 0.5, 0, 0, 0, 0, 1, 0, 0] }] }""",
        """{ "type": "group", "transform": [{ "translate": [0.5, 0, 0] }], "shapes": [{ "type": "mesh", CUBE, "transform": [{ "matrix": [0, 0, 1, 0, 0.5, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1] }] }] }""")]
    [InlineData(
        """{ "type": "sphere", "center": [0, 0, 0], "motion": [{ "time": 5, "transform": [{ "translate": [1, 0, 0] }] }, { "time": 6, "transform": [{ "translate": [1, 0, 0] }] }] }""",
        """{ "type": "sphere", "center": [1, 0, 0] }""")]
    public void Numbers_that_are_moved_exactly_give_the_same_bits(string moved, string made)
    {
        Assert.Equal(Film(Scene(made)).ComputeHash(), Film(Scene(moved)).ComputeHash());
    }

    [Theory]
    [InlineData("""{ "type": "sphere", "center": [0, 0, 0], MATERIAL }""")]
    [InlineData("""{ "type": "mesh", CUBE, MATERIAL }""")]
    [InlineData("""{ "type": "group", MATERIAL, "shapes": [{ "type": "sphere", "center": [0, 0.5, 0] }, { "type": "mesh", OCTAHEDRON, MATERIAL }] }""")]
    [InlineData("""{ "type": "group", "shapes": [{ "type": "instance", "of": { "type": "sphere", "center": [0, 1, 0], MATERIAL } }, { "type": "mesh", CUBE, MATERIAL }] }""")]
    public void An_instance_with_a_material_shows_its_object_in_it_and_others_keep_theirs(string of)
    {
        const string Green = """ "material": { "type": "diffuse", "color": "green" } """;
        const string Shining = """ "material": { "type": "luminaire", "color": [1, 2, 3] } """;
        string Instance(string of, double x, string material = "") =>
            $$"""{ "type": "instance", "of": {{of}}, "transform": [{ "scale": [0.3, 0.3, 0.3], "translate": [{{x}}, 0, 0] }]{{material}} }""";
        string Three(params string[] instances) => $$"""{ "type": "group", "shapes": [{{string.Join(", ", instances)}}] }""";
        string green = of.Replace("MATERIAL", Green, StringComparison.Ordinal);
        string shining = of.Replace("MATERIAL", Shining, StringComparison.Ordinal);
        string given = Three(Instance(green, -0.8), Instance(green, 0, $", {Shining}"), Instance(green, 0.8, $", {Green}"));
        string built = Three(Instance(green, -0.8), Instance(shining, 0), Instance(green, 0.8));
        Assert.Equal(Film(Scene(built)).ComputeHash(), Film(Scene(given)).ComputeHash());
        Assert.NotEqual(Film(Scene(Three(Instance(green, -0.8), Instance(green, 0), Instance(green, 0.8)))).ComputeHash(), Film(Scene(given)).ComputeHash());
    }

    [Theory]
    [InlineData(
        "an instance of a sphere",
        """{ "type": "instance", "of": { "type": "sphere", "center": [0, 0, 0], "radius": 0.5 }, "transform": [{ "scale": [2, 2, 2], "translate": [0.5, 0, 0] }] }""",
        """{ "type": "sphere", "center": [0.5, 0, 0] }""")]
    [InlineData(
        "an instance of a cube",
        """{ "type": "instance", "of": { "type": "mesh", CUBE }, "transform": [{ "scale": [0.5, -1, 0.7], "rotate": 33, "axis": [1, 2, 3], "translate": [0.3, 0.2, 0] }] }""",
        """{ "type": "mesh", CUBE, "transform": [{ "scale": [0.5, -1, 0.7], "rotate": 33, "axis": [1, 2, 3], "translate": [0.3, 0.2, 0] }] }""")]
    [InlineData(
        "an instance of a slanted thing, stretched",
        """{ "type": "instance", "of": { "type": "mesh", OCTAHEDRON }, "transform": [{ "scale": [1.3, 0.4, 0.8], "rotate": 33, "axis": [1, 2, 3], "translate": [0.3, 0.2, 0] }] }""",
        """{ "type": "mesh", OCTAHEDRON, "transform": [{ "scale": [1.3, 0.4, 0.8], "rotate": 33, "axis": [1, 2, 3], "translate": [0.3, 0.2, 0] }] }""")]
    [InlineData(
        "an instance of a smooth thing, stretched",
        """{ "type": "instance", "of": { "type": "mesh", OCTAHEDRON, NORMALS }, "transform": [{ "scale": [1.3, 0.4, -0.8], "rotate": 33, "axis": [1, 2, 3], "translate": [0.3, 0.2, 0] }] }""",
        """{ "type": "mesh", OCTAHEDRON, NORMALS, "transform": [{ "scale": [1.3, 0.4, -0.8], "rotate": 33, "axis": [1, 2, 3], "translate": [0.3, 0.2, 0] }] }""")]
    [InlineData(
        "an instance of instances",
        """{ "type": "instance", "transform": [{ "translate": [0.25, 0, 0] }], "of": { "type": "group", "shapes": [{ "type": "instance", "of": { "type": "sphere", "center": [0, 0, 0] }, "transform": [{ "scale": [0.5, 0.5, 0.5] }] }, { "type": "sphere", "center": [1, 0, 0], "radius": 0.25 }] } }""",
        """{ "type": "group", "shapes": [{ "type": "sphere", "center": [0.25, 0, 0], "radius": 0.5 }, { "type": "sphere", "center": [1.25, 0, 0], "radius": 0.25 }] }""")]
    [InlineData(
        "a rectangle turned aside",
        """{ "type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "size": [2, 1], "transform": [{ "rotate": 30, "axis": [0, 0, 1] }] }""",
        """{ "type": "mesh", "positions": [[-1, -0.5, 0], [1, -0.5, 0], [1, 0.5, 0], [-1, 0.5, 0]], "triangles": [[0, 1, 2], [0, 2, 3]], "transform": [{ "rotate": 30, "axis": [0, 0, 1] }] }""")]
    [InlineData(
        "a thing that moves outside of the shutter",
        """{ "type": "sphere", "center": [0, 0, 0], "motion": [{ "time": -2, "transform": [{ "translate": [0.4, 0, 0] }] }, { "time": 0 }, { "time": 1, "transform": [{ "rotate": 90, "axis": [0, 1, 0] }] }] }""",
        """{ "type": "sphere", "center": [0, 0, 0] }""")]
    [InlineData(
        "a shining sphere in an instance",
        """{ "type": "instance", "transform": [{ "scale": [0.5, 0.5, 0.5], "rotate": 40, "translate": [1, 0, 0.5] }], "of": { "type": "sphere", "center": [0, 0, 0], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 4, "exponent": 1 } } }""",
        """{ "type": "sphere", "center": [1, 0, 0.5], "radius": 0.25, "material": { "type": "luminaire", "multiplier": 4, "exponent": 1 } }""")]
    [InlineData(
        "a shining rectangle and a mesh",
        """{ "type": "mesh", "positions": [[-1, 0.8, -0.5], [1, 0.8, -0.5], [1, 0.8, 0.5], [-1, 0.8, 0.5]], "triangles": [[0, 1, 2], [0, 2, 3]], "material": { "type": "luminaire", "multiplier": 2, "exponent": 1 } }""",
        """{ "type": "plane", "point": [0, 0.8, 0], "normal": [0, -1, 0], "size": [2, 1], "material": { "type": "luminaire", "multiplier": 2, "exponent": 1 } }""")]
    [InlineData(
        "a shining mesh stretched in an instance",
        """{ "type": "instance", "transform": [{ "scale": [2, -1, 0.5], "rotate": 20, "axis": [0, 0, 1] }], "of": { "type": "mesh", "positions": [[-0.5, 0.8, -1], [0.5, 0.8, -1], [0.5, 0.8, 1], [-0.5, 0.8, 1]], "triangles": [[0, 1, 2], [0, 2, 3]], "material": { "type": "luminaire", "multiplier": 2 } } }""",
        """{ "type": "mesh", "transform": [{ "rotate": 20, "axis": [0, 0, 1] }], "positions": [[-1, -0.8, -0.5], [1, -0.8, -0.5], [1, -0.8, 0.5], [-1, -0.8, 0.5]], "triangles": [[0, 2, 1], [0, 3, 2]], "material": { "type": "luminaire", "multiplier": 2 } }""")]
    [InlineData(
        "a shining rectangle sheared to a parallelogram",
        """{ "type": "plane", "point": [0, 0.8, 0], "normal": [0, -1, 0], "size": [1, 1], "transform": [{ "rotate": 30 }, { "scale": [2, 1, 0.5] }], "material": { "type": "luminaire", "multiplier": 2, "exponent": 1 } }""",
        """{ "type": "mesh", "positions": [[-0.5, 0.8, -0.5], [0.5, 0.8, -0.5], [0.5, 0.8, 0.5], [-0.5, 0.8, 0.5]], "triangles": [[0, 1, 2], [0, 2, 3]], "transform": [{ "rotate": 30 }, { "scale": [2, 1, 0.5] }], "material": { "type": "luminaire", "multiplier": 2, "exponent": 1 } }""")]
    public void Things_look_the_same_however_they_are_placed(string what, string moved, string made)
    {
        BlockTest test = BlockTest.Compare(
            SceneRuns.RenderText(Scene(moved), s_seeds, firstSeed: 1), SceneRuns.RenderText(Scene(made), s_seeds, firstSeed: 1001));
        ErrorBudget.Geometry.Check(test.P, $"{what}: {test}");
    }

    [Fact]
    public void A_smooth_thing_that_a_stretch_turns_inside_out_has_the_same_normals_as_one_made_so()
    {
        // Steep normals at the corners: before the stretch they are on the surface's side, after it on the other.
        const string stretch = """ "transform": [{ "scale": [2, 0.3, -0.8], "rotate": 33, "axis": [1, 2, 3], "translate": [0.3, 0.2, 0] }] }""";
        double[] moved = NormalsSeen(Scene("""{ "type": "instance", "of": { "type": "mesh", OCTAHEDRON, NORMALS },""" + stretch));
        double[] made = NormalsSeen(Scene("""{ "type": "mesh", OCTAHEDRON, NORMALS,""" + stretch));
        for (int i = 0; i < made.Length; i++)
        {
            Assert.True(Math.Abs(made[i] - moved[i]) < 1e-3, $"pixel {i / 3 % 128}, {i / 3 / 128}: {moved[i]}, {made[i]}");
        }
    }

    [Fact]
    public void An_object_is_not_seen_by_itself() => Assert.Equal(
        Film(Scene("""{ "type": "sphere", "center": [0, 0, 0] }""")).ComputeHash(),
        Film(Scene("""{ "type": "sphere", "center": [0, 0, 0] }""").Replace("\"shapes\":", "\"objects\": { \"ball\": { \"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 2 } }, \"shapes\":", StringComparison.Ordinal)).ComputeHash());

    [Fact]
    public void A_camera_that_is_moved_with_its_scene_sees_the_same()
    {
        string still = Scene("""{ "type": "sphere", "center": [0.5, 0, 0] }""");
        string moved = still.Replace("\"fieldOfView\"", "\"transform\": [{ \"translate\": [4, 0, 0] }, { \"rotate\": 90 }], \"fieldOfView\"", StringComparison.Ordinal)
            .Replace("\"shapes\": [", "\"shapes\": [ { \"type\": \"group\", \"transform\": [{ \"translate\": [4, 0, 0] }, { \"rotate\": 90 }], \"shapes\": [", StringComparison.Ordinal)
            .Replace("] /* end */", "] } ] /* end */", StringComparison.Ordinal);
        BlockTest test = BlockTest.Compare(SceneRuns.RenderText(moved, s_seeds, firstSeed: 1), SceneRuns.RenderText(still, s_seeds, firstSeed: 1001));
        ErrorBudget.Geometry.Check(test.P, $"camera and scene moved: {test}");
    }

    private static double[] NormalsSeen(string json)
    {
        AovFilm film = new(new(128, 96), [new NormalImage()]);
        new FirstHitPass(Load(json.Replace("\"width\": 32, \"height\": 24, \"samplesPerPixel\": 16", "\"width\": 128, \"height\": 96, \"samplesPerPixel\": 1", StringComparison.Ordinal))).Render(film);
        double[] normals = new double[128 * 96 * 3];
        for (int y = 0; y < 96; y++)
        {
            film.ReadRow(new NormalImage(), y, normals.AsSpan(y * 128 * 3, 128 * 3));
        }

        return normals;
    }

    private static string Scene(string shape) => """
        {
          "camera": { "position": [0.5, 0.5, 4], "lookAt": [0, 0, 0], "fieldOfView": 45 },
          "render": { "integrator": "report", "width": 32, "height": 24, "samplesPerPixel": 16, "maxDiffuseDepth": 2, "shutter": [0, 0] },
          "background": [0.2, 0.3, 0.4],
          "shapes": [
            SHAPE,
            { "type": "plane", "point": [0, -1.25, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.6, 0.7, 0.8] } },
            { "type": "sphere", "center": [1.5, 2, 1], "radius": 0.25, "material": { "type": "luminaire", "multiplier": 20 } }
          ] /* end */
        }
        """.Replace("SHAPE", shape, StringComparison.Ordinal).Replace("CUBE", Cube, StringComparison.Ordinal)
        .Replace("OCTAHEDRON", Octahedron, StringComparison.Ordinal).Replace("NORMALS", Normals, StringComparison.Ordinal);

    private static Film Film(string json) => new RTracer(Load(json)).Render().Film;

    private static Scene Load(string json)
    {
        SceneLoadResult result = SceneLoader.Build(SceneReader.ReadText(json, "test.json"), ".");
        Assert.Equal("", Diagnostic.Format(result.Diagnostics));
        return result.Scene!;
    }
}
