using System.Numerics;
using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

/// <summary>Accessors and primitives of glTF files become triangles.</summary>
public class GltfMeshTests
{
    private static readonly Vector3[] s_square = [new(0, 0, 0), new(1, 0, 0), new(0, 1, 0), new(1, 1, 0)];

    [Theory]
    [InlineData(4, "0 1 2")]
    [InlineData(5, "0 1 2 1 3 2")]
    [InlineData(6, "1 2 0 2 3 0")]
    public void Modes_without_indices_make_the_triangles_of_the_specification(int mode, string expected)
    {
        TestGltf file = new();
        int positions = file.Accessor(5126, "VEC3", 4, Square());
        file.Mesh($$"""{ "mode": {{mode}}, "attributes": { "POSITION": {{positions}} } }""");
        Assert.Equal(expected, string.Join(' ', file.ImportData().Indices));
    }

    [Theory]
    [InlineData(5121)]
    [InlineData(5123)]
    [InlineData(5125)]
    public void Indices_of_all_types_are_read(int type)
    {
        byte[] indices = type switch
        {
            5121 => [2, 1, 3, 0, 1, 2],
            5123 => TestGltf.Shorts(2, 1, 3, 0, 1, 2),
            _ => [2, 0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0],
        };
        TestGltf file = new();
        int positions = file.Accessor(5126, "VEC3", 4, Square());
        int list = file.Accessor(type, "SCALAR", 6, indices);
        file.Mesh($$"""{ "attributes": { "POSITION": {{positions}} }, "indices": {{list}} }""");
        Assert.Equal([2, 1, 3, 0, 1, 2], file.ImportData().Indices);
    }

    [Theory]
    [InlineData(0, "points are ignored")]
    [InlineData(1, "lines are ignored")]
    [InlineData(2, "lines are ignored")]
    [InlineData(3, "lines are ignored")]
    public void Points_and_lines_are_left_out_with_a_note(int mode, string note)
    {
        TestGltf file = new();
        int positions = file.Accessor(5126, "VEC3", 4, Square());
        file.Mesh($$"""{ "mode": {{mode}}, "attributes": { "POSITION": {{positions}} } }""");
        ImportedModel model = file.Import();
        Assert.Empty(model.Scene.Shapes);
        Assert.Contains(model.Notes, n => n.StartsWith(note, StringComparison.Ordinal));
    }

    [Theory]
    [InlineData(5120, true, new byte[] { 0, 127, 129, 128 }, new float[] { 0, 1, -1, -1 })]
    [InlineData(5120, false, new byte[] { 0, 127, 129, 128 }, new float[] { 0, 127, -127, -128 })]
    [InlineData(5121, true, new byte[] { 0, 255, 51, 128 }, new float[] { 0, 1, 0.2f, 128 / 255f })]
    [InlineData(5121, false, new byte[] { 0, 255, 51, 128 }, new float[] { 0, 255, 51, 128 })]
    [InlineData(5122, true, new byte[] { 0, 0, 255, 127, 1, 128, 0, 128 }, new float[] { 0, 1, -1, -1 })]
    [InlineData(5122, false, new byte[] { 0, 0, 255, 127, 1, 128, 0, 128 }, new float[] { 0, 32767, -32767, -32768 })]
    [InlineData(5123, true, new byte[] { 0, 0, 255, 255, 51, 51, 0, 128 }, new float[] { 0, 1, 0.2f, 32768 / 65535f })]
    [InlineData(5123, false, new byte[] { 0, 0, 255, 255, 51, 51, 0, 128 }, new float[] { 0, 65535, 13107, 32768 })]
    public void Whole_numbers_are_read_as_they_are_or_normalised(int type, bool isNormalized, byte[] bytes, float[] expected)
    {
        int size = bytes.Length / 4;
        TestGltf file = TestGltf.Triangle();
        byte[] padded = [.. Enumerable.Range(0, 3).SelectMany(_ => new byte[4 * size].Concat(bytes))];

        // Four numbers a vertex, read as tangents, from byte 4·size of each stride of 8·size on.
        int tangents = file.Accessor(type, "VEC4", 3, padded, $", \"normalized\": {(isNormalized ? "true" : "false")}, \"byteOffset\": {4 * size}", $", \"byteStride\": {8 * size}");
        file.Json["meshes"]![0]!["primitives"]![0]!["attributes"]!["TANGENT"] = tangents;
        MeshData data = file.ImportData();
        Assert.All(data.Tangents!, t => Assert.Equal(new Vector4(expected[0], expected[1], expected[2], expected[3]), t));
    }

    [Fact]
    public void Interleaved_vertices_are_taken_apart()
    {
        TestGltf file = new();
        float[] vertices = [0, 0, 0, 0, 0, 1, 0.25f, 0.75f, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 1];
        int view = file.View(TestGltf.Floats(vertices), ", \"byteStride\": 32");
        string Accessor(string type, int offset) => $$"""{ "bufferView": {{view}}, "byteOffset": {{offset}}, "componentType": 5126, "type": "{{type}}", "count": 3 }""";
        file.Add("accessors", Accessor("VEC3", 0));
        file.Add("accessors", Accessor("VEC3", 12));
        file.Add("accessors", Accessor("VEC2", 24));
        file.Mesh("""{ "attributes": { "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2 } }""");
        MeshData data = file.ImportData();
        Assert.Equal([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], data.Positions);
        Assert.Equal([new(0, 0, 1), new(0, 1, 0), new(1, 0, 0)], data.Normals!);

        // v goes upwards here and downwards there.
        Assert.Equal([new(0.25f, 0.25f), new(1, 1), new(0, 0)], data.Uv!);
    }

    [Theory]
    [InlineData(5121)]
    [InlineData(5123)]
    [InlineData(5125)]
    public void Sparse_accessors_replace_elements_of_their_view_or_of_zeros(int indexType)
    {
        TestGltf file = new();
        int size = indexType switch { 5121 => 1, 5123 => 2, _ => 4 };
        byte[] indices = new byte[2 * size];
        (indices[0], indices[size]) = (1, 2);
        int places = file.View(indices);
        int values = file.View(TestGltf.Floats(7, 0, 0, 0, 9, 0));
        string sparse = $$""", "sparse": { "count": 2, "indices": { "bufferView": {{places}}, "componentType": {{indexType}} }, "values": { "bufferView": {{values}} } }""";
        int replaced = file.Accessor(5126, "VEC3", 4, Square(), sparse);
        int zeros = file.Add("accessors", $$"""{ "componentType": 5126, "type": "VEC3", "count": 4{{sparse}} }""");
        file.Mesh($$"""{ "mode": 5, "attributes": { "POSITION": {{replaced}}, "NORMAL": {{zeros}} } }""");
        MeshData data = file.ImportData();
        Assert.Equal([s_square[0], new(7, 0, 0), new(0, 9, 0), s_square[3]], data.Positions);
        Assert.Equal([default, new(7, 0, 0), new(0, 9, 0), default], data.Normals!);
    }

    [Fact]
    public void Colours_of_three_or_four_numbers_are_read_and_their_alpha_is_left_out()
    {
        TestGltf file = TestGltf.Triangle();
        int colors = file.Accessor(5121, "VEC4", 3, [255, 0, 51, 9, 0, 255, 0, 9, 0, 0, 255, 9], ", \"normalized\": true");
        file.Json["meshes"]![0]!["primitives"]![0]!["attributes"]!["COLOR_0"] = colors;
        Assert.Equal([new(1, 0, 0.2f), new(0, 1, 0), new(0, 0, 1)], file.ImportData().Colors!);
    }

    [Fact]
    public void The_set_of_uv_is_the_one_that_the_base_colour_uses()
    {
        TestGltf file = TestGltf.Triangle("""{ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0, "texCoord": 1 } } }""");
        GltfTextureTests.AddPicture(file);
        file.Json["meshes"]![0]!["primitives"]![0]!["attributes"]!["TEXCOORD_1"] = file.Accessor(5126, "VEC2", 3, TestGltf.Floats(0.5f, 1, 0.5f, 1, 0.5f, 1));
        Assert.All(file.ImportData().Uv!, uv => Assert.Equal(new Vector2(0.5f, 0), uv));
    }

    [Fact]
    public void A_few_triangles_of_a_long_list_of_vertices_keep_only_their_own()
    {
        TestGltf file = new();
        float[] many = [.. Enumerable.Range(0, 300).Select(i => (float)i)];
        int positions = file.Accessor(5126, "VEC3", 100, TestGltf.Floats(many));
        int indices = file.Accessor(5123, "SCALAR", 6, TestGltf.Shorts(50, 99, 7, 7, 99, 3));
        file.Mesh($$"""{ "attributes": { "POSITION": {{positions}} }, "indices": {{indices}} }""");
        MeshData data = file.ImportData();
        Assert.Equal(4, data.Positions.Length);
        Assert.Equal([150, 297, 21, 21, 297, 9], TestGltf.Corners(data).Select(p => p.X));
    }

    [Fact]
    public void Primitives_of_the_same_accessors_share_their_triangles()
    {
        TestGltf file = TestGltf.Triangle();
        string primitive = file.Json["meshes"]![0]!["primitives"]![0]!.ToJsonString();
        file.Mesh(primitive);
        file.Mesh(primitive);
        object[] data = [.. file.Import().Scene.Shapes.Cast<MeshDescription>().Select(m => m.Data!).Distinct()];
        Assert.Single(data);
    }

    [Fact]
    public void A_mesh_of_several_primitives_is_a_group()
    {
        TestGltf file = TestGltf.Triangle("""{ "pbrMetallicRoughness": { "baseColorFactor": [1, 0, 0, 1] } }""");
        ((System.Text.Json.Nodes.JsonArray)file.Json["meshes"]![0]!["primitives"]!).Add(System.Text.Json.Nodes.JsonNode.Parse("""{ "attributes": { "POSITION": 0 } }"""));
        GroupDescription group = Assert.IsType<GroupDescription>(Assert.Single(file.Import().Scene.Shapes));
        Assert.Equal(2, group.Shapes.Count);
        Assert.NotSame(group.Shapes[0].Material, group.Shapes[1].Material);
    }

    [Fact]
    public void A_glb_gives_the_same_as_a_gltf()
    {
        TestGltf file = TestGltf.Triangle("""{ "emissiveFactor": [1, 1, 0] }""");
        MeshDescription text = file.ImportMesh();
        MeshDescription binary = Assert.IsType<MeshDescription>(Assert.Single(GltfReader.Read(file.ToGlb(), "").Scene.Shapes));
        Assert.Equal(text.Data!.Positions, binary.Data!.Positions);
        Assert.Equal(text.Data.Indices, binary.Data.Indices);
        Assert.Equal(text.Material, binary.Material);
    }

    [Fact]
    public void Names_follow_to_the_scene()
    {
        TestGltf file = TestGltf.Triangle();
        file.Json["meshes"]![0]!["name"] = "leaf";
        Assert.Equal("leaf", file.ImportMesh().Name);
        file.Json["nodes"]![0]!["name"] = "first leaf";
        Assert.Equal("first leaf", file.ImportMesh().Name);
    }

    private static byte[] Square() => TestGltf.Floats([.. s_square.SelectMany(p => new[] { p.X, p.Y, p.Z })]);
}
