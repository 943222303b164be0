using System.IO.Compression;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

public class SerializedReaderTests
{
    private static readonly Vector3[] s_corners = [new(0, 0, 0), new(1, 0, 0), new(0, 1, 0), new(0.1f, 1, 1)];
    private static readonly uint[] s_indices = [0, 1, 2, 1, 3, 2];

    [Theory]
    [InlineData(4, false)]
    [InlineData(4, true)]
    [InlineData(3, false)]
    public void Meshes_are_read_with_normals_and_uv_in_both_precisions(int version, bool isDouble)
    {
        IReadOnlyList<ShapeDescription> shapes = Read(FileOf(version, Mesh(version, isDouble, "first", hasMore: true), Mesh(version, isDouble, "second", hasMore: false)));
        Assert.Equal(version == 4 ? ["first", "second"] : ["mesh 0", "mesh 1"], shapes.Select(s => s.Name));
        MeshData first = ((MeshDescription)shapes[0]).Data!;
        Assert.Equal(s_corners, first.Positions);
        Assert.Equal(s_corners.Select(c => c + Vector3.One), first.Normals!);
        Assert.Equal(s_corners.Select(c => new Vector2(c.X, c.Y)), first.Uv!);
        Assert.Equal(s_indices.Select(i => (int)i), first.Indices);
        Assert.Null(((MeshDescription)shapes[1]).Data!.Normals);
    }

    [Fact]
    public void A_scene_may_take_one_of_the_meshes_of_a_file()
    {
        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder["two.serialized"], FileOf(4, Mesh(4, false, "a", hasMore: false), Mesh(4, false, "b", hasMore: false)));
        string Scene(int part) => $$"""{ "shapes": [{ "type": "mesh", "file": "two.serialized", "part": {{part}} }] }""";
        SceneLoadResult Load(int part) => SceneLoader.Build(SceneReader.ReadText(Scene(part), "scene.json"), folder.Path);
        Assert.Equal(2, new RayTracer.Rendering.SceneStatistics(Load(1).Scene!).Triangles);
        Assert.Equal(4, new RayTracer.Rendering.SceneStatistics(Load(-1).Scene!).Triangles);
        Assert.Equal("there is no mesh 2 in \"two.serialized\": it has 2, counted from 0", Assert.Single(Load(2).Diagnostics).Message);
    }

    [Fact]
    public void Every_cut_and_every_changed_byte_gives_a_mesh_or_a_message()
    {
        byte[] whole = FileOf(4, Mesh(4, false, "a", hasMore: true));
        for (int i = 0; i < whole.Length; i++)
        {
            Try(whole[..i]);
            byte[] changed = [.. whole];
            changed[i] ^= 0x55;
            Try(changed);
        }

        static void Try(byte[] file)
        {
            try
            {
                Assert.NotEmpty(Read(file));
            }
            catch (ModelException e)
            {
                Assert.NotEmpty(e.Message);
            }
        }
    }

    [Fact]
    public void Counts_are_not_believed()
    {
        byte[] mesh = Compressed(w =>
        {
            w.Write(0x1000u);
            w.Write((byte)0);
            w.Write(100_000_000ul);
            w.Write(100_000_000ul);
        });
        ModelException refused = Assert.Throws<ModelException>(() => Read(FileOf(4, mesh)));
        Assert.Contains("too many for a file of its size", refused.Message, StringComparison.Ordinal);
        Assert.StartsWith("byte 2: ", Assert.Throws<ModelException>(() => Read(FileOf(7, mesh))).Message, StringComparison.Ordinal);
        Assert.StartsWith("byte 0: ", Assert.Throws<ModelException>(() => Read(new byte[20])).Message, StringComparison.Ordinal);
    }

    private static IReadOnlyList<ShapeDescription> Read(byte[] file)
    {
        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder["mesh.serialized"], file);
        return ModelFile.Read(folder["mesh.serialized"]).Scene.Shapes;
    }

    private static byte[] FileOf(int version, params byte[][] meshes)
    {
        using MemoryStream file = new();
        using BinaryWriter writer = new(file);
        List<long> begins = [];
        foreach (byte[] mesh in meshes)
        {
            begins.Add(file.Position);
            writer.Write((ushort)0x041C);
            writer.Write((ushort)version);
            writer.Write(mesh);
        }

        foreach (long begin in begins)
        {
            if (version == 4)
            {
                writer.Write((ulong)begin);
            }
            else
            {
                writer.Write((uint)begin);
            }
        }

        writer.Write((uint)meshes.Length);
        return file.ToArray();
    }

    private static byte[] Mesh(int version, bool isDouble, string name, bool hasMore) => Compressed(w =>
    {
        w.Write((isDouble ? 0x2000u : 0x1000u) | (hasMore ? 3u : 0));
        if (version == 4)
        {
            w.Write(System.Text.Encoding.UTF8.GetBytes(name + "\0"));
        }

        w.Write((ulong)s_corners.Length);
        w.Write((ulong)(s_indices.Length / 3));
        IEnumerable<float> numbers = s_corners.SelectMany(c => new[] { c.X, c.Y, c.Z });
        numbers = hasMore ? numbers.Concat(s_corners.SelectMany(c => new[] { c.X + 1, c.Y + 1, c.Z + 1 })).Concat(s_corners.SelectMany(c => new[] { c.X, c.Y })) : numbers;
        foreach (float number in numbers)
        {
            if (isDouble)
            {
                w.Write((double)number);
            }
            else
            {
                w.Write(number);
            }
        }

        Array.ForEach(s_indices, w.Write);
    });

    private static byte[] Compressed(Action<BinaryWriter> write)
    {
        using MemoryStream compressed = new();
        using (ZLibStream stream = new(compressed, CompressionLevel.Fastest))
        using (BinaryWriter writer = new(stream))
        {
            write(writer);
        }

        return compressed.ToArray();
    }
}
