using System.Text;
using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Scenes;
using JsonNode = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Import.Tests;

/// <summary>What is wrong with a glTF file is said with its place, and nothing in it is trusted.</summary>
public class GltfErrorTests
{
    [Theory]
    [InlineData("""{ }""", "line 1, column 1: \"asset\" is missing")]
    [InlineData("""{ "asset": { "version": "1.0" } }""", "line 1, column 25: asset.version: the file is of version \"1.0\": only glTF 2.0 is read")]
    [InlineData("""{ "asset": { "version": "2.0" }, }x""", "line 1, column 35: expected the end of the file, but found \"x\"")]
    [InlineData("""[]""", "line 1, column 1: a glTF file must be an object { … }")]
    [InlineData("", "line 1, column 1: the file is empty")]
    [InlineData("""{ "asset": { "version": "2.0" }, "extensionsRequired": ["KHR_texture_transform", "KHR_draco_mesh_compression"] }""", "line 1, column 56: extensionsRequired: the file cannot be shown without \"KHR_draco_mesh_compression\", which is not understood here")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": 7 }""", "line 1, column 43: nodes: expected an array")]
    [InlineData("""{ "asset": { "version": "2.0" }, "scenes": [{ "nodes": [3] }], "nodes": [{}] }""", "line 1, column 56: scenes[0].nodes: there is no nodes[3]: the last is [0]")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "mesh": 0 }] }""", "line 1, column 54: nodes[0].mesh: there is no meshes[0]: the file has none")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "children": [1] }, { "children": [0] }] }""", "line 1, column 43: nodes: every node is below another one: there is a cycle")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "children": [0] }], "scenes": [{ "nodes": [0] }] }""", "line 1, column 44: nodes[0]: the node is reached twice: it is below itself, or has two parents")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "scale": [1, 2] }] }""", "line 1, column 55: nodes[0].scale: expected 3 numbers, but found 2")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "scale": [1, 2, "3"] }] }""", "line 1, column 62: nodes[0].scale[2]: expected a number")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "rotation": [0, 0, 0, 0] }] }""", "line 1, column 58: nodes[0].rotation: a quaternion of zeros is no rotation")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "mesh": 0.5 }] }""", "line 1, column 54: nodes[0].mesh: expected a whole number")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "mesh": -1 }] }""", "line 1, column 54: nodes[0].mesh: -1 is less than 0")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2] }] }""", "line 1, column 56: nodes[0].matrix: its last row (elements 4, 8, 12 and 16) must be 0, 0, 0, 1")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "camera": 0 }], "cameras": [{ "type": "wide" }] }""", "line 1, column 84: cameras[0].type: expected \"perspective\" or \"orthographic\"")]
    [InlineData("""{ "asset": { "version": "2.0" }, "nodes": [{ "extensions": { "KHR_lights_punctual": { "light": 2 } } }] }""", "line 1, column 44: nodes[0]: there is no light 2: the file has 0")]
    public void Faults_of_the_text_are_said_with_line_and_column(string json, string expected) =>
        Assert.Equal(expected, Assert.Throws<ModelException>(() => GltfReader.Read(Encoding.UTF8.GetBytes(json), "")).Message);

    [Theory]
    [InlineData("accessors/0/count", "4", "accessors[0]: its 4 elements end at byte 48 of bufferViews[0], which has 36 bytes")]
    [InlineData("accessors/0/count", "2000000000", "accessors[0]: its 2000000000 elements end at byte 24000000000 of bufferViews[0], which has 36 bytes")]
    [InlineData("accessors/0/byteOffset", "2147483647", "accessors[0]: its 3 elements end at byte 2147483683 of bufferViews[0], which has 36 bytes")]
    [InlineData("accessors/0/count", "0", "accessors[0].count: 0 is less than 1")]
    [InlineData("accessors/0/count", "1e300", "accessors[0].count: 1e300 is more than 2147483647")]
    [InlineData("accessors/0/componentType", "5124", "accessors[0].componentType: 5124 is not one of")]
    [InlineData("accessors/0/type", "\"VEC5\"", "accessors[0].type: \"VEC5\" is not one of")]
    [InlineData("accessors/0/type", "\"VEC2\"", "meshes[0].primitives[0].attributes.POSITION: its accessor has 2 numbers an element: 3 are needed")]
    [InlineData("accessors/1/count", "2", "meshes[0].primitives[0].attributes.TEXCOORD_0: it has 2 elements, but there are 3 positions")]
    [InlineData("accessors/0/bufferView", "9", "accessors[0].bufferView: there is no bufferViews[9]: the last is [1]")]
    [InlineData("bufferViews/0/byteLength", "1000000", "bufferViews[0]: bytes 0 to 999999 are beyond the end of buffers[0], which has 60 bytes")]
    [InlineData("bufferViews/0/byteOffset", "2147483647", "bufferViews[0]: bytes 2147483647 to 2147483682 are beyond the end of buffers[0], which has 60 bytes")]
    [InlineData("bufferViews/0/byteStride", "2000000000", "accessors[0]: its 3 elements end at byte 4000000012 of bufferViews[0], which has 36 bytes")]
    [InlineData("bufferViews/0/byteStride", "0", "bufferViews[0].byteStride: 0 is less than 1")]
    [InlineData("bufferViews/0/buffer", "1", "bufferViews[0].buffer: there is no buffers[1]: the last is [0]")]
    [InlineData("buffers/0/byteLength", "61", "buffers[0].byteLength: the buffer claims 61 bytes, but there are only 60")]
    [InlineData("buffers/0/uri", "\"data:;base64,????\"", "buffers[0].uri: the embedded data is not base64, or is damaged")]
    [InlineData("buffers/0", "{ \"byteLength\": 60 }", "buffers[0]: it has no \"uri\", and the file has no binary chunk for it")]
    [InlineData("buffers/0/uri", "\"http://example.org/a.bin\"", "buffers[0].uri: \"http://example.org/a.bin\" is not beside the file: only relative paths and embedded data are read")]
    [InlineData("meshes/0/primitives/0/attributes/POSITION", "5", "meshes[0].primitives[0].attributes.POSITION: there is no accessors[5]: the last is [1]")]
    [InlineData("meshes/0/primitives/0/mode", "7", "meshes[0].primitives[0].mode: 7 is more than 6")]
    [InlineData("meshes/0/primitives/0/material", "0", "meshes[0].primitives[0].material: there is no materials[0]: the file has none")]
    [InlineData("meshes/0/primitives/0/indices", "0", "meshes[0].primitives[0].indices: accessors[0] must be a SCALAR of unsigned whole numbers")]
    public void Counts_offsets_and_indices_are_not_trusted(string path, string value, string expected)
    {
        TestGltf file = TestGltf.Triangle();
        JsonNode json = JsonNode.Parse(file.ToGltf())!;
        string[] keys = path.Split('/');
        JsonNode changed = keys.Aggregate(json, (at, key) => int.TryParse(key, out int index) ? at[index]! : Child(at, key));
        changed.ReplaceWith(JsonNode.Parse(value));
        string message = Assert.Throws<ModelException>(() => GltfReader.Read(Encoding.UTF8.GetBytes(json.ToJsonString()), "")).Message;
        Assert.StartsWith("line 1, column ", message, StringComparison.Ordinal);
        Assert.Contains(": " + expected, message, StringComparison.Ordinal);
    }

    // A property to be changed; made where there is none.
    private static JsonNode Child(JsonNode at, string key)
    {
        at[key] ??= 0;
        return at[key]!;
    }

    [Fact]
    public void An_index_out_of_range_is_named_with_its_place()
    {
        TestGltf file = new();
        int positions = file.Accessor(5126, "VEC3", 3, TestGltf.Floats(0, 0, 0, 1, 0, 0, 0, 1, 0));
        int indices = file.Accessor(5123, "SCALAR", 3, TestGltf.Shorts(0, 7, 1));
        file.Mesh($$"""{ "attributes": { "POSITION": {{positions}} }, "indices": {{indices}} }""");
        Assert.EndsWith("meshes[0].primitives[0].indices: element 1 (byte 38 of buffers[0]) of accessors[1] is 7, but there are only 3 vertices", file.Complaint(), StringComparison.Ordinal);
    }

    [Fact]
    public void A_sparse_place_out_of_range_is_refused()
    {
        TestGltf file = new();
        int places = file.View([3]);
        int values = file.View(TestGltf.Floats(1, 2, 3));
        file.Add("accessors", $$"""{ "componentType": 5126, "type": "VEC3", "count": 3, "sparse": { "count": 1, "indices": { "bufferView": {{places}}, "componentType": 5121 }, "values": { "bufferView": {{values}} } } }""");
        file.Mesh("""{ "attributes": { "POSITION": 0 } }""");
        Assert.EndsWith("accessors[0].sparse.indices: place 0 is 3, but the accessor has only 3 elements", file.Complaint(), StringComparison.Ordinal);
    }

    [Fact]
    public void Few_bytes_cannot_ask_for_much_memory()
    {
        TestGltf file = new();
        file.Add("accessors", """{ "componentType": 5126, "type": "VEC3", "count": 2000000000 }""");
        file.Mesh("""{ "attributes": { "POSITION": 0 } }""");
        Assert.EndsWith("accessors[0]: the meshes need far more memory than a file of this size can account for", file.Complaint(), StringComparison.Ordinal);
        string values = "{\"a\":[" + string.Join(',', Enumerable.Repeat("0", 3_000_000)) + "]}";
        Assert.Contains("far too many values", Assert.Throws<ModelException>(() => GltfReader.Read(Encoding.UTF8.GetBytes(values), "")).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Faults_of_a_glb_are_said_with_their_byte()
    {
        byte[] good = TestGltf.Triangle().ToGlb();
        string Complaint(Action<byte[]> change, int? length = null)
        {
            byte[] bad = [.. good[..(length ?? good.Length)]];
            change(bad);
            return Assert.Throws<ModelException>(() => GltfReader.Read(bad, "")).Message;
        }

        Assert.Equal("byte 10: the file ends within its header of 20 bytes", Complaint(_ => { }, 10));
        Assert.Equal("byte 4: the container's version is 1: only version 2 is read", Complaint(b => b[4] = 1));
        Assert.Equal($"byte 8: the header claims {good.Length} bytes, but the file has 100: it is cut off", Complaint(_ => { }, 100));
        Assert.Equal("byte 16: the first chunk is not JSON", Complaint(b => b[16] = (byte)'B'));
        Assert.StartsWith("byte 12: a chunk claims 16777", Complaint(b => b[15] = 1), StringComparison.Ordinal);
        Assert.StartsWith("byte 20: expected a value", Complaint(b => b[20] = (byte)')'), StringComparison.Ordinal);
        int count = good.AsSpan().IndexOf("\"count\":3"u8);
        Assert.StartsWith($"byte {good.AsSpan().IndexOf("{\"bufferView\":0"u8)}: accessors[0]: its 9 elements", Complaint(b => b[count + 8] = (byte)'9'), StringComparison.Ordinal);
    }
}
