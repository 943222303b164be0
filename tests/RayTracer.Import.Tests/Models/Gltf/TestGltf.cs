using System.Buffers.Binary;
using System.Globalization;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Scenes;
using RayTracer.Shapes;
using JsonNode = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Import.Tests;

/// <summary>Makes small glTF files, without the code under test.</summary>
internal sealed class TestGltf
{
    private readonly List<byte> _bytes = [];

    /// <summary>The JSON, to be changed at will.</summary>
    public JsonObject Json { get; } = new() { ["asset"] = new JsonObject { ["version"] = "2.0" } };

    /// <summary>A file that shows one mesh: a triangle in the plane z = 0, with uv and, if one is given, a material.</summary>
    public static TestGltf Triangle(string? material = null)
    {
        TestGltf file = new();
        int positions = file.Accessor(5126, "VEC3", 3, Floats(0, 0, 0, 1, 0, 0, 0, 1, 0));
        int uv = file.Accessor(5126, "VEC2", 3, Floats(0, 0, 1, 0, 0, 1));
        file.Mesh($$"""{ "attributes": { "POSITION": {{positions}}, "TEXCOORD_0": {{uv}} }{{(material is null ? "" : ", \"material\": 0")}} }""");
        if (material is not null)
        {
            file.Add("materials", material);
        }

        return file;
    }

    public static byte[] Floats(params float[] numbers) => MemoryMarshal.AsBytes(numbers.AsSpan()).ToArray();

    public static byte[] Shorts(params ushort[] numbers) => MemoryMarshal.AsBytes(numbers.AsSpan()).ToArray();

    /// <summary>Appends to one of the root's lists.</summary>
    /// <returns>The index.</returns>
    public int Add(string list, string json)
    {
        if (Json[list] is not JsonArray array)
        {
            Json[list] = array = [];
        }

        array.Add(JsonNode.Parse(json));
        return array.Count - 1;
    }

    /// <summary>Appends bytes as a buffer view.</summary>
    public int View(byte[] bytes, string more = "")
    {
        int offset = _bytes.Count;
        _bytes.AddRange(bytes);
        _bytes.AddRange(new byte[(4 - (_bytes.Count % 4)) % 4]);
        return Add("bufferViews", $$"""{ "buffer": 0, "byteOffset": {{offset}}, "byteLength": {{bytes.Length}}{{more}} }""");
    }

    /// <summary>Appends an accessor of its own buffer view.</summary>
    public int Accessor(int componentType, string type, int count, byte[] bytes, string more = "", string viewMore = "") =>
        Add("accessors", $$"""{ "bufferView": {{View(bytes, viewMore)}}, "componentType": {{componentType}}, "type": "{{type}}", "count": {{count}}{{more}} }""");

    /// <summary>Appends a mesh and a node that shows it.</summary>
    public int Mesh(string primitives, string nodeMore = "")
    {
        int mesh = Add("meshes", $$"""{ "primitives": [{{primitives}}] }""");
        Add("nodes", $$"""{ "mesh": {{mesh}}{{nodeMore}} }""");
        return mesh;
    }

    /// <summary>As a .gltf whose buffer is embedded.</summary>
    public byte[] ToGltf()
    {
        JsonObject json = (JsonObject)Json.DeepClone();
        if (_bytes.Count > 0 && json["buffers"] is null)
        {
            json["buffers"] = new JsonArray(new JsonObject
            {
                ["byteLength"] = _bytes.Count,
                ["uri"] = "data:application/octet-stream;base64," + Convert.ToBase64String([.. _bytes]),
            });
        }

        return Encoding.UTF8.GetBytes(json.ToJsonString(new JsonSerializerOptions { WriteIndented = true }));
    }

    /// <summary>As a .glb whose buffer is the binary chunk.</summary>
    public byte[] ToGlb()
    {
        JsonObject json = (JsonObject)Json.DeepClone();
        json["buffers"] = new JsonArray(new JsonObject { ["byteLength"] = _bytes.Count });
        byte[] text = Encoding.UTF8.GetBytes(json.ToJsonString());
        byte[] padded = [.. text, .. Enumerable.Repeat((byte)' ', (4 - (text.Length % 4)) % 4)];
        return [.. Header(28 + padded.Length + _bytes.Count), .. Chunk("JSON", padded), .. Chunk("BIN\0", [.. _bytes])];
    }

    /// <summary>What the importer makes of it.</summary>
    public ImportedModel Import(string folder = "") => GltfReader.Read(ToGltf(), folder);

    /// <summary>The message with which the importer refuses it.</summary>
    public string Complaint() => Assert.Throws<ModelException>(() => Import()).Message;

    /// <summary>The only mesh of what the importer makes of it.</summary>
    public MeshDescription ImportMesh() => Assert.IsType<MeshDescription>(Assert.Single(Import().Scene.Shapes));

    /// <summary>The triangles of that mesh.</summary>
    public MeshData ImportData() => ImportMesh().Data!;

    /// <summary>The corners of the triangles, in their order.</summary>
    public static IEnumerable<Vector3> Corners(MeshData mesh) => mesh.Indices.Select(i => mesh.Positions[i]);

    public static string Text(IEnumerable<float> numbers) => string.Join(", ", numbers.Select(n => n.ToString("R", CultureInfo.InvariantCulture)));

    private static byte[] Header(int length)
    {
        byte[] header = new byte[12];
        "glTF"u8.CopyTo(header);
        BinaryPrimitives.WriteInt32LittleEndian(header.AsSpan(4), 2);
        BinaryPrimitives.WriteInt32LittleEndian(header.AsSpan(8), length);
        return header;
    }

    private static byte[] Chunk(string type, byte[] content)
    {
        byte[] header = new byte[8];
        BinaryPrimitives.WriteInt32LittleEndian(header, content.Length);
        Encoding.Latin1.GetBytes(type, header.AsSpan(4));
        return [.. header, .. content];
    }
}
