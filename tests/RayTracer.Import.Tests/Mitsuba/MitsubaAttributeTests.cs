using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

/// <summary>Colours of faces and vertices in PLY files, by the names of Mitsuba.</summary>
public class MitsubaAttributeTests
{
    private const string Square = "-1 -1 0 0.1 0.2 0.3 5\n1 -1 0 0.1 0.2 0.3 5\n1 1 0 0.1 0.2 0.3 5\n-1 1 0 0.1 0.2 0.3 5\n";

    // A square of two faces, the one a triangle: with a colour of faces, and for corners a colour, three numbers and one.
    private static readonly string s_file = $"""
        ply
        format ascii 1.0
        element vertex 4
        property float x
        property float y
        property float z
        property float heat_0
        property float heat_1
        property float heat_2
        property float one_0
        element face 2
        property float r
        property float g
        property float b
        property list uchar int vertex_indices
        property float late_r
        property float late_g
        property float late_b
        end_header
        {Square}0.5 0.25 0.125 3 0 1 2 1 0 0
        0.75 0.5 0.25 4 0 2 3 3 0 1 0

        """;

    [Theory]
    [InlineData("face_color", 0.5, 0.25, 0.125)]
    [InlineData("face_late_color", 1, 0, 0)]
    [InlineData("vertex_heat", 0.1, 0.2, 0.3)]
    [InlineData("vertex_one", 5, 5, 5)]
    public void A_mesh_shows_the_attribute_that_its_material_names(string name, double r, double g, double b)
    {
        MeshDescription mesh = Read(name, out MeshData data);
        Assert.Equal((name, false), (mesh.ColorAttribute, mesh.IgnoreColors));
        MeshAttribute attribute = data.Attributes.Single(a => a.Name == name);
        Assert.Equal(new Rgb((float)r, (float)g, (float)b), attribute.Values[0]);
        Assert.Equal(name.StartsWith("face", StringComparison.Ordinal) ? data.TriangleCount : data.Positions.Length, attribute.Values.Length);
    }

    [Fact]
    public void Both_triangles_of_a_face_have_its_colour_and_share_no_corner_with_others()
    {
        MeshDescription mesh = Read("face_color", out MeshData data);
        MeshData shown = MeshVariant.Of(data, mesh);
        Assert.Equal(9, shown.Positions.Length);
        Assert.All(Enumerable.Range(0, 9), corner => Assert.Equal(corner < 3 ? new(0.5f, 0.25f, 0.125f) : new Rgb(0.75f, 0.5f, 0.25f), shown.Colors![corner]));
        Assert.Equal(data.Indices.Select(i => data.Positions[i]), shown.Indices.Select(i => shown.Positions[i]));
    }

    [Fact]
    public void Smooth_meshes_stay_smooth_where_faces_have_colours()
    {
        MeshDescription mesh = Read("face_color", out MeshData data);
        MeshData shown = MeshVariant.Of(data, mesh with { Shading = MeshShading.Smooth });
        Assert.Equal(9, shown.Normals!.Length);
    }

    [Fact]
    public void An_attribute_that_a_file_lacks_is_an_error_that_names_those_it_has()
    {
        using TestScene scene = new();
        File.WriteAllText(scene["square.ply"], s_file);
        string complaint = Assert.Single(SceneLoader.Load(scene.Write("scene.xml", Shape("face_heat"))).Diagnostics, d => d.Severity == Severity.Error).Message;
        Assert.EndsWith("has no colours \"face_heat\": there are vertex_heat, vertex_one, face_color, face_late_color", complaint, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("face_color", "vertex_heat", 9)]
    [InlineData("face_color", "face_late_color", 9)]
    [InlineData("vertex_one", "vertex_heat", 4)]
    [InlineData("vertex_one", "face_color", 9)]
    public void A_mesh_shows_two_attributes(string first, string second, int corners)
    {
        string things = Shapes(("base_color", first), ("sheen_tint", second));
        MeshDescription mesh = Assert.IsType<MeshDescription>(Assert.Single(TestScene.Of(things).Shapes));
        Assert.Equal((first, second), (mesh.ColorAttribute, mesh.SecondColorAttribute));
        PrincipledMaterialDescription material = Assert.IsType<PrincipledMaterialDescription>(Assert.IsType<OneSidedMaterialDescription>(mesh.Material).Material);
        Assert.Equal((new VertexColorTextureDescription(), new VertexColorTextureDescription { Second = true }), (material.BaseColor, material.SheenTint));
        MeshData data = PlyReader.Parse(System.Text.Encoding.ASCII.GetBytes(s_file), []);
        MeshData shown = MeshVariant.Of(data, mesh);
        Assert.Equal(corners, shown.Positions.Length);
        Assert.Equal(data.Attributes.Single(a => a.Name == first).Values[0], shown.Colors![0]);
        Assert.Equal(data.Attributes.Single(a => a.Name == second).Values[0], shown.SecondColors![0]);
        Assert.Equal(data.Attributes.Single(a => a.Name == second).Values[^1], shown.SecondColors[^1]);
    }

    // From above: on the left the square with its faces' colours and its corners' numbers, on the right another mesh of the same table, without any.
    [Theory]
    [InlineData("", 0.5, 0.25, 0.125)]
    [InlineData(", \"second\": true", 0.1, 0.2, 0.3)]
    public void Second_colours_are_shown_where_a_texture_asks_for_them(string second, double r, double g, double b)
    {
        using TestScene scene = new();
        File.WriteAllText(scene["square.ply"], s_file);
        File.WriteAllText(scene["scene.json"], $$"""
            { "camera": { "projection": "orthographic", "position": [2, 0, 5], "lookAt": [2, 0, 0], "viewSize": 6 },
              "render": { "width": 6, "height": 6, "samplesPerPixel": 1, "sampler": "regular", "integrator": "albedo" },
              "materials": { "shown": { "type": "diffuse", "color": { "type": "vertexColor"{{second}} } } },
              "shapes": [
                { "type": "mesh", "file": "square.ply", "colorAttribute": "face_color", "secondColorAttribute": "vertex_heat", "material": "shown" },
                { "type": "mesh", "positions": [[2, -3, 0], [6, -3, 0], [4, 3, 0]], "triangles": [[0, 1, 2]], "material": "shown" } ] }
            """);
        SceneLoadResult result = SceneLoader.Load(scene["scene.json"]);
        Film film = new RTracer(Assert.IsType<Scene>(result.Scene)).Render().Film;
        Assert.Equal((r, g, b), (Math.Round(film.Mean(1, 3).R, 6), Math.Round(film.Mean(1, 3).G, 6), Math.Round(film.Mean(1, 3).B, 6)));
        Assert.Equal(Rgb.White, film.Mean(4, 3));
    }

    [Fact]
    public void Second_colours_and_refinement_do_not_go_together()
    {
        using TestScene scene = new();
        File.WriteAllText(scene["square.ply"], s_file);
        File.WriteAllText(scene["scene.json"], """{ "shapes": [{ "type": "mesh", "file": "square.ply", "secondColorAttribute": "vertex_heat", "refinement": { "subdivide": 1 } }] }""");
        Assert.Contains(SceneLoader.Load(scene["scene.json"]).Diagnostics, d => d.Message.EndsWith("is refined, and shows one set of colours only", StringComparison.Ordinal));
    }

    [Fact]
    public void A_mesh_shows_no_more_than_two_attributes() =>
        Assert.Contains("may show two of its attributes here", TestScene.Complaint(Shapes(("base_color", "face_color"), ("sheen", "vertex_heat"), ("sheen_tint", "vertex_one"))), StringComparison.Ordinal);

    private static string Shapes(params (string Property, string Attribute)[] shown) =>
        $"""<shape type="ply"><string name="filename" value="square.ply"/><bsdf type="principled">{string.Concat(shown.Select(s => $"""<texture type="mesh_attribute" name="{s.Property}"><string name="name" value="{s.Attribute}"/></texture>"""))}</bsdf></shape>""";

    private static string Shape(string attribute) => $"""
        <shape type="ply"><string name="filename" value="square.ply"/><bsdf type="diffuse"><texture type="mesh_attribute" name="reflectance"><string name="name" value="{attribute}"/></texture></bsdf></shape>
        """;

    private static MeshDescription Read(string attribute, out MeshData data)
    {
        data = PlyReader.Parse(System.Text.Encoding.ASCII.GetBytes(s_file), []);
        return Assert.IsType<MeshDescription>(Assert.Single(TestScene.Of(Shape(attribute)).Shapes));
    }
}
