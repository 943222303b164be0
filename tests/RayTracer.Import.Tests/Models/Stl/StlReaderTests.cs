using System.Numerics;
using System.Text;
using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

[Trait("Category", "Thorough")]
public class StlReaderTests
{
    private static readonly Vector3[] s_corners = [new(0, 0, 0), new(1, 0, 0), new(0, 1, 0), new(0, 0, 1.5e-3f)];
    private static readonly int[] s_indices = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];

    [Fact]
    public void Text_and_binary_give_the_same_mesh_with_equal_corners_made_one()
    {
        foreach (byte[] file in new[] { Text(), Binary("made by a test"), Binary("solid as some programs begin") })
        {
            List<string> notes = [];
            MeshData mesh = StlReader.Parse(file, notes);
            Assert.Empty(notes);
            Assert.Equal([s_corners[0], s_corners[2], s_corners[1], s_corners[3]], mesh.Positions);
            Assert.Equal([0, 1, 2, 0, 2, 3, 0, 3, 1, 2, 1, 3], mesh.Indices);
            Assert.Null(mesh.Normals);
        }
    }

    [Fact]
    public void Zeros_of_both_signs_are_one_corner_and_so_are_equal_numbers_that_are_none()
    {
        byte[] file = Encoding.ASCII.GetBytes("solid\nfacet normal 1.#IND nan -nan\nouter loop\nvertex 0 0 0\nvertex -0 0 -0\nvertex nan 1 2\nendloop endfacet\nfacet normal 0 0 1 outer loop vertex nan 1 2 vertex 0 0 0 vertex 5 5 5 endloop endfacet endsolid");
        Assert.Equal([0, 0, 1, 1, 0, 2], StlReader.Parse(file, []).Indices);
    }

    [Fact]
    public void Any_case_of_words_several_solids_and_all_line_ends_are_read()
    {
        string text = Encoding.ASCII.GetString(Text());
        string two = text + text.ToUpperInvariant().Replace("E-3", "e-3", StringComparison.Ordinal).Replace("ENDSOLID A TEST", "endsolid vertex of a facet", StringComparison.Ordinal);
        foreach (string end in (string[])["\n", "\r\n", "\r"])
        {
            MeshData mesh = StlReader.Parse(Encoding.ASCII.GetBytes(two.Replace("\n", end, StringComparison.Ordinal)), []);
            Assert.Equal((4, 8), (mesh.Positions.Length, mesh.TriangleCount));
        }
    }

    [Fact]
    public void A_large_number_of_corners_is_welded_as_a_dictionary_welds_them()
    {
        var random = new Random(3);
        Vector3[] corners = [.. Enumerable.Range(0, 60_000).Select(_ => new Vector3(random.Next(40), random.Next(40), random.Next(-5, 5) / 3f))];
        byte[] file = Binary("large", corners);
        MeshData mesh = StlReader.Parse(file, []);
        Dictionary<Vector3, int> numbers = [];
        int[] expected = [.. corners.Select(c => numbers.TryGetValue(c, out int number) ? number : numbers[c] = numbers.Count)];
        Assert.Equal(expected, mesh.Indices);
        Assert.Equal(numbers.Keys, mesh.Positions);
    }

    [Fact]
    public void What_stands_behind_a_binary_file_is_left_out_and_noted()
    {
        List<string> notes = [];
        Assert.Equal(4, StlReader.Parse([.. Binary("x"), 1, 2, 3], notes).TriangleCount);
        Assert.Equal(["3 bytes after the last triangle are ignored"], notes);
    }

    public static TheoryData<string, byte[]> BadFiles() => new()
    {
        { "it is not an STL file", [] },
        { "it is not an STL file", [.. "facet normal"u8] },
        { "byte 80: 4 triangles would need 284 bytes, and the file has 283", Binary("x")[..^1] },
        { "byte 80: 4 triangles would need 284 bytes, and the file has 200", Binary("solid x")[..200] },
        { "line 4: expected a number instead of \"1,5\"", [.. "solid a\nfacet\nouter loop\nvertex 1,5 0 0"u8] },
        { "line 4: expected a number instead of \"endloop\"", [.. "solid a\nfacet\nouter loop\nvertex 1 0\tendloop"u8] },
        { "line 3: a loop has 1 corners instead of 3", [.. "solid a\nvertex 1 0 0\nendloop"u8] },
        { "line 3: the file is cut off within a triangle", [.. "solid a\nvertex 1 0 0\n"u8] },
        { "line 2: expected facet, vertex, endloop or another word of STL instead of \"facets\"", [.. "solid a\nfacets normal"u8] },
    };

    [Theory]
    [MemberData(nameof(BadFiles), DisableDiscoveryEnumeration = true)]
    public void Bad_files_are_refused_with_the_place_and_what_was_expected(string message, byte[] file) =>
        Assert.StartsWith(message, Assert.Throws<ModelException>(() => StlReader.Parse(file, [])).Message, StringComparison.Ordinal);

    [Fact]
    public void Damage_gives_nothing_but_a_ModelException()
    {
        ModelFuzz.Run(Text(), f => StlReader.Parse(f, []), [[.. " vertex "u8], [.. " endloop "u8], [.. "1e99"u8], [0]]);
        ModelFuzz.Run(Binary("solid"), f => StlReader.Parse(f, []));
    }

    [SkippableTheory]
    [InlineData("Spider_ascii.stl", 1368)]
    [InlineData("Spider_binary.stl", 1368)]
    [InlineData("sphereWithHole.stl", 0)]
    [InlineData("triangle_with_two_solids.stl", 2)]
    public void Real_files_are_read(string name, int triangles)
    {
        string path = SharedModels.Find("stl", name);
        MeshData mesh = Assert.IsType<MeshDescription>(Assert.Single(ModelFile.Read(path).Scene.Shapes)).Data!;
        int expected = triangles > 0 ? triangles : File.ReadLines(path).Count(l => l.Contains("endfacet", StringComparison.Ordinal));
        Assert.Equal(expected, mesh.TriangleCount);
        Assert.InRange(mesh.Positions.Length, 3, (3 * expected) - (expected > 2 ? 1 : 0));
    }

    private static byte[] Text()
    {
        var text = new StringBuilder("solid a test of several words\n");
        for (int i = 0; i < s_indices.Length; i += 3)
        {
            text.Append("  facet normal 0.0 0.0 1.0\n    outer loop\n");
            foreach (int corner in s_indices[i..(i + 3)])
            {
                text.Append($"      vertex {s_corners[corner].X:e6} {s_corners[corner].Y} {(s_corners[corner].Z == 0 ? "-0.0" : "1.5e-3")}\n");
            }

            text.Append("    endloop\n  endfacet\n");
        }

        return Encoding.ASCII.GetBytes(text.Append("endsolid a test\n").ToString());
    }

    private static byte[] Binary(string header) => Binary(header, [.. s_indices.Select(i => s_corners[i])]);

    private static byte[] Binary(string header, Vector3[] corners)
    {
        using var file = new MemoryStream();
        using var writer = new BinaryWriter(file);
        writer.Write(Encoding.ASCII.GetBytes(header.PadRight(80, '\0')));
        writer.Write(corners.Length / 3);
        for (int i = 0; i < corners.Length; i++)
        {
            writer.Write(i % 3 == 0 ? new byte[12] : []);
            writer.Write(corners[i].X);
            writer.Write(corners[i].Y);
            writer.Write(corners[i].Z);
            writer.Write(i % 3 == 2 ? [0x12, 0x80] : Array.Empty<byte>());
        }

        return file.ToArray();
    }
}
