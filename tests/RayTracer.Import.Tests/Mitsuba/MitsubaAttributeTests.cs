using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;

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

    [Fact]
    public void A_mesh_shows_one_attribute_only()
    {
        string two = Shape("face_color").Replace("<texture", "<texture type=\"mesh_attribute\" name=\"specular_reflectance\"><string name=\"name\" value=\"vertex_heat\"/></texture><texture", StringComparison.Ordinal)
            .Replace("name=\"reflectance\"", "name=\"diffuse_reflectance\"", StringComparison.Ordinal).Replace("\"diffuse\"", "\"plastic\"", StringComparison.Ordinal);
        Assert.Contains("may show one of its attributes here", TestScene.Complaint(two), StringComparison.Ordinal);
    }

    private static string Shape(string attribute) => $"""
        <shape type="ply"><string name="filename" value="square.ply"/><bsdf type="diffuse"><texture type="mesh_attribute" name="reflectance"><string name="name" value="{attribute}"/></texture></bsdf></shape>
        """;

    private static MeshDescription Read(string attribute, out MeshData data)
    {
        data = PlyReader.Parse(System.Text.Encoding.ASCII.GetBytes(s_file), []);
        return Assert.IsType<MeshDescription>(Assert.Single(TestScene.Of(Shape(attribute)).Shapes));
    }
}
