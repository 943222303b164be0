using System.Numerics;
using System.Text;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Import;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

[Trait("Category", "Thorough")]
public class PlyReaderTests
{
    private static readonly string[] s_formats = ["ascii", "binary_little_endian", "binary_big_endian"];

    // A file of which everything is said: vertices with extra numbers and a list, an element to skip before and after, and faces of 3, 4 and 5 corners.
    private static byte[] Full(string format, string countType = "uchar", string indexType = "int")
    {
        var file = new TestPly(format);
        file.Header(
            "comment made by a test", "obj_info nothing", "element camera 2", "property double distance", "property list ushort short marks",
            "element vertex 6", "property float x", "property char extra", "property double y", "property float z", "property list uchar float weights",
            "property float nx", "property float ny", "property float nz", "property float s", "property float t",
            "property uchar red", "property uchar green", "property uchar blue",
            "element face 3", "property int flags", $"property list {countType} {indexType} vertex_indices", "property float quality",
            "element edge 1", "property int vertex1", "property int vertex2");
        file.Add("double", 1.5).Add("ushort", 2).Add("short", -1, -2);
        file.Add("double", 2.5).Add("ushort", 0);
        for (int i = 0; i < 6; i++)
        {
            file.Add("float", Corners[i].X).Add("char", -i).Add("double", Corners[i].Y).Add("float", Corners[i].Z);
            file.Add("uchar", i % 3).Add("float", [.. Enumerable.Repeat(0.25, i % 3)]);
            file.Add("float", 0, 0, 1, i / 8.0, 1 - (i / 4.0)).Add("uchar", 10 * i, 255 - i, 128);
        }

        file.Add("int", 7).Add(countType, 3).Add(indexType, 0, 1, 2).Add("float", 0.5);
        file.Add("int", 8).Add(countType, 4).Add(indexType, 0, 2, 3, 4).Add("float", 0.5);
        file.Add("int", 9).Add(countType, 5).Add(indexType, 1, 2, 3, 4, 5).Add("float", 0.5);
        file.Add("int", 0, 1);
        return file.Bytes();
    }

    private static readonly Vector3[] Corners = [new(0, 0, 0), new(2, 0, 0), new(2, 1, 0), new(1, 2, 0), new(0, 1, 0), new(-0.5f, 0.125f, 0)];

    public static TheoryData<string, string, string> Kinds
    {
        get
        {
            var kinds = new TheoryData<string, string, string>();
            foreach (string format in s_formats)
            {
                foreach ((string count, string index) in new[] { ("uchar", "int"), ("char", "uchar"), ("int", "uint"), ("uint8", "int32"), ("ushort", "short"), ("uint", "ushort"), ("short", "char"), ("float", "double") })
                {
                    kinds.Add(format, count, index);
                }
            }

            return kinds;
        }
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void All_formats_and_types_give_the_same_mesh(string format, string countType, string indexType)
    {
        List<string> notes = [];
        MeshData mesh = PlyReader.Parse(Full(format, countType, indexType), notes);
        Assert.Empty(notes);
        Assert.Equal(Corners, mesh.Positions);
        Assert.Equal([0, 1, 2, 0, 2, 3, 0, 3, 4, 1, 2, 3, 1, 3, 4, 1, 4, 5], mesh.Indices);
        Assert.All(mesh.Normals!, n => Assert.Equal(Vector3.UnitZ, n));
        Assert.Equal(Enumerable.Range(0, 6).Select(i => new Vector2(i / 8f, 1 - (i / 4f))), mesh.Uv!);
        Assert.Equal(Enumerable.Range(0, 6).Select(i => new Rgb(SrgbCurve.Decode8((byte)(10 * i)), SrgbCurve.Decode8((byte)(255 - i)), SrgbCurve.Decode8(128))), mesh.Colors!);
    }

    [Theory]
    [InlineData("u v", "float")]
    [InlineData("s t", "double")]
    [InlineData("texture_u texture_v", "float")]
    [InlineData("texture_s texture_t", "float")]
    public void Uv_has_any_of_its_usual_names(string names, string type)
    {
        string[] name = names.Split(' ');
        byte[] file = new TestPly("ascii").Header("element vertex 3", "property float x", "property float y", "property float z", $"property {type} {name[0]}", $"property {type} {name[1]}", "element face 1", "property list uchar int vertex_index")
            .Add("float", 0, 0, 0, 0.25, 0.5, 1, 0, 0, 0, 0, 0, 1, 0, 1, 1).Add("int", 3, 0, 1, 2).Bytes();
        Assert.Equal([new(0.25f, 0.5f), new(0, 0), new(1, 1)], PlyReader.Parse(file, []).Uv!);
    }

    // Model files hold colours as they are seen on a screen, whatever the type of their numbers.
    [Theory]
    [InlineData("uchar", 255, 0, 188)]
    [InlineData("ushort", 65535, 0, 48316)]
    [InlineData("float", 1, 0, 0.737255)]
    public void Colours_of_all_types_are_decoded_from_sRGB(string type, double full, double none, double grey)
    {
        byte[] file = new TestPly("binary_little_endian").Header("element vertex 1", "property float x", "property float y", "property float z", $"property {type} red", $"property {type} green", $"property {type} blue", "element face 1", "property list uchar int vertex_indices")
            .Add("float", 1, 2, 3).Add(type, full, none, grey).Add("uchar", 3).Add("int", 0, 0, 0).Bytes();
        Rgb color = Assert.Single(PlyReader.Parse(file, []).Colors!);
        Assert.Equal((1f, 0f), (color.R, color.G));
        Assert.Equal(0.5029, color.B, 0.0005);
    }

    [Fact]
    public void Strips_of_triangles_are_read_with_their_alternating_order()
    {
        byte[] file = new TestPly("binary_big_endian").Header("element vertex 5", "property float x", "property float y", "property float z", "element tristrips 1", "property list int int vertex_indices")
            .Add("float", [.. Enumerable.Range(0, 15).Select(i => (double)i)]).Add("int", 8, 0, 1, 2, 3, -1, 4, 2, 1).Bytes();
        Assert.Equal([0, 1, 2, 1, 3, 2, 4, 2, 1], PlyReader.Parse(file, []).Indices);
    }

    [Fact]
    public void Line_ends_of_all_systems_are_read_in_headers_and_texts()
    {
        string text = Encoding.Latin1.GetString(Full("ascii"));
        foreach (string end in (string[])["\r\n", "\r"])
        {
            Assert.Equal(18, PlyReader.Parse(Encoding.Latin1.GetBytes(text.Replace("\n", end, StringComparison.Ordinal)), []).Indices.Length);
        }

        byte[] binary = Full("binary_little_endian");
        int end2 = binary.AsSpan().IndexOf("end_header\n"u8) + 11;
        byte[] header = Encoding.Latin1.GetBytes(Encoding.Latin1.GetString(binary, 0, end2).Replace("\n", "\r\n", StringComparison.Ordinal));
        Assert.Equal(18, PlyReader.Parse([.. header, .. binary[end2..]], []).Indices.Length);
    }

    [Fact]
    public void Faces_without_area_and_numbers_that_are_none_are_left_to_the_mesh()
    {
        List<string> notes = [];
        byte[] file = Encoding.ASCII.GetBytes("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 3\nproperty list uchar int vertex_indices\nend_header\n0 nan 0 inf 0 0 -1.#IND 1 0\n2 0 1\n3 0 1 99\n4 0 1 2 99\n");
        MeshData mesh = PlyReader.Parse(file, notes);
        Assert.Equal([0, 1, 99, 0, 1, 2, 0, 2, 99], mesh.Indices);
        Assert.True(float.IsNaN(mesh.Positions[0].Y));
        Assert.Equal(["1 faces with fewer than three corners are ignored"], notes);
    }

    public static TheoryData<string, string> BadFiles => new()
    {
        { "line 1: it does not begin with \"ply\"", "" },
        { "line 1: it does not begin with \"ply\"", "PLX\n" },
        { "line 2: expected ascii, binary_little_endian or binary_big_endian instead of \"binary\"", "ply\nformat binary 1.0\n" },
        { "line 3: the header ends without end_header", "ply\nformat ascii 1.0\n" },
        { "line 2: the header does not say the format", "ply\nend_header\n" },
        { "line 3: expected an element's name and count instead of \"-4\"", "ply\nformat ascii 1.0\nelement vertex -4\n" },
        { "line 2: a property comes before the first element", "ply\nproperty float x\n" },
        { "line 3: expected a type such as uchar, int or float instead of \"quad\"", "ply\nelement vertex 3\nproperty quad x\n" },
        { "line 3: a property has no name", "ply\nelement vertex 3\nproperty float\n" },
        { "line 2: expected element instead of \"elment\"", "ply\nelment vertex 3\n" },
        { "line 3: the vertices have no x, y and z", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n" },
        { "line 3: faces come before the vertices", "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n3 0 1 2\n" },
        { "there are no vertices in it", "ply\nformat ascii 1.0\nend_header\n" },
        { "line 11: expected a number instead of \"1,5\"", Ascii("0 0 0\n1,5 0 0") },
        { "line 11: expected a number, but the file ends", Ascii("0.00000000 0 0\n1 ") },
        { "line 11: 1 of \"face\" (line 7) take 2 bytes each or more, and 1 are left", Ascii("0 0 0\n1 0 0") },
        { "line 12: expected a whole number instead of \"0.5\"", Ascii("0 0 0\n1 0 0\n3 0 0.5 1") },
        { "line 12: a list \"vertex_indices\" of 9 numbers cannot be in the 5 bytes", Ascii("0 0 0\n1 0 0\n9 0 1") },
        { "line 12: a list \"vertex_indices\" of -3 numbers", Ascii("0 0 0\n1 0 0\n-3 0 1") },
    };

    [Theory]
    [MemberData(nameof(BadFiles))]
    public void Bad_files_are_refused_with_the_line_and_what_was_expected(string message, string file) =>
        Assert.StartsWith(message, Assert.Throws<ModelException>(() => PlyReader.Parse(Encoding.ASCII.GetBytes(file), [])).Message, StringComparison.Ordinal);

    [Fact]
    public void Binary_files_that_are_cut_off_are_refused_with_the_byte()
    {
        byte[] file = Full("binary_little_endian");
        int begin = file.AsSpan().IndexOf("end_header\n"u8) + 11;
        for (int length = begin; length < file.Length; length++)
        {
            string message = Assert.Throws<ModelException>(() => PlyReader.Parse(file.AsSpan(0, length), [])).Message;
            Assert.Matches($"^byte [0-9]+: (the file is cut off|.* (are left|that are left))$", message);
        }
    }

    // A well-known old exporter wrote such headers.
    [Fact]
    public void A_line_without_the_word_comment_is_taken_for_one_and_noted()
    {
        List<string> notes = [];
        string text = Ascii("0 0 0\n1 0 0\n3 0 1 0").Replace("element vertex", "Created by a program\nelement vertex", StringComparison.Ordinal);
        Assert.Equal(3, PlyReader.Parse(Encoding.ASCII.GetBytes(text), notes).Indices.Length);
        Assert.Equal(["line 3 of its header is not a PLY statement and is taken for a comment"], notes);
    }

    [Fact]
    public void Claims_of_size_take_no_memory()
    {
        foreach (string format in s_formats)
        {
            byte[] file = new TestPly(format).Header("element vertex 999999999999", "property float x", "property float y", "property float z", "element face 2", "property list uchar int vertex_indices").Bytes();
            long before = GC.GetAllocatedBytesForCurrentThread();
            Assert.Contains("999999999999 of \"vertex\"", Assert.Throws<ModelException>(() => PlyReader.Parse(file, [])).Message, StringComparison.Ordinal);
            Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1 << 20);
        }
    }

    [Fact]
    public void Damage_gives_nothing_but_a_ModelException()
    {
        byte[][] pieces = [[.. "element vertex 4000000000\n"u8], [.. "property list uchar int a\n"u8], [.. "-1 "u8], [.. "1e39 "u8], [0xFF, 0xFF, 0xFF, 0x7F], [.. "\n"u8]];
        foreach (string format in s_formats)
        {
            ModelFuzz.Run(Full(format), f => PlyReader.Parse(f, []), pieces);
        }
    }

    [SkippableTheory]
    [InlineData("ply/cube.ply", 8, 12, false, false, false)]
    [InlineData("ply/cube_binary.ply", 8, 12, false, false, false)]
    [InlineData("ply/cube_binary_header_with_RN_newline.ply", 8, 12, false, false, false)]
    [InlineData("ply/cube_uv.ply", 24, 12, true, true, false)]
    [InlineData("ply/float-color.ply", 3, 1, false, false, true)]
    [InlineData("ply/Wuson.ply", 11184, 3732, true, true, false)]
    [InlineData("models/igea.ply", 134345, 268686, false, false, false)]
    public void Real_files_are_read(string path, int corners, int triangles, bool normals, bool uv, bool colors)
    {
        ImportedModel model = ModelFile.Read(SharedModels.Find(path.Split('/')));
        MeshData mesh = Assert.IsType<MeshDescription>(Assert.Single(model.Scene.Shapes)).Data!;
        Assert.Equal((corners, triangles), (mesh.Positions.Length, mesh.TriangleCount));
        Assert.Equal((normals, uv, colors), (mesh.Normals is not null, mesh.Uv is not null, mesh.Colors is not null));
        Assert.All(mesh.Indices, i => Assert.InRange(i, 0, corners - 1));
    }

    [SkippableTheory]
    [InlineData("there are no triangles in it (4 corners)", "ply/points.ply")]
    [InlineData("it is empty", "invalid/empty.ply")]
    [InlineData("line ", "invalid/crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply")]
    public void Real_files_without_triangles_or_with_faults_are_refused(string message, string path)
    {
        string file = SharedModels.Find(path.Split('/'));
        Assert.StartsWith(message, Assert.Throws<ModelException>(() => ModelFile.Read(file)).Message, StringComparison.Ordinal);
    }

    // The header has eight lines and end_header.
    private static string Ascii(string values) =>
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" + values;
}
