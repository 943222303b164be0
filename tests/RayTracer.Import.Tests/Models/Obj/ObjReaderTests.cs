using System.Numerics;
using System.Text;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Import;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

[Trait("Category", "Thorough")]
public class ObjReaderTests
{
    private const string Square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    [Fact]
    public void Faces_of_all_kinds_of_corners_are_read()
    {
        MeshData mesh = Mesh(Square + "vt 0.25 0.5\nvt 1 0 0\nvn 0 0 2\nf 1/1/1 2/2/1 3/1/1\nf -4/-2/-1 -2/-2/-1 -1/-1/-1");
        Assert.Equal([0, 1, 2, 0, 2, 3], mesh.Indices);
        Assert.Equal([new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new Vector3(0, 1, 0)], mesh.Positions);
        Assert.Equal([new(0.25f, 0.5f), new(1, 0), new(0.25f, 0.5f), new Vector2(1, 0)], mesh.Uv!);
        Assert.All(mesh.Normals!, n => Assert.Equal(new Vector3(0, 0, 2), n));
        Assert.Null(mesh.Colors);
        Assert.Equal((null, null), (Mesh(Square + "f 1 2 3").Normals, Mesh(Square + "f 1 2 3").Uv));
        Assert.Equal(new Vector2(0, 1), Mesh(Square + "vt 0 1\nf 1/1 2/1/ 3").Uv![1]);
        Assert.Equal(Vector3.UnitY, Mesh(Square + "vn 0 1 0\nf 1//1 2//1 3//-1").Normals![2]);
    }

    [Fact]
    public void A_position_with_several_uv_or_normals_becomes_several_corners()
    {
        MeshData mesh = Mesh(Square + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 1 0 0\nf 1/1/1 2/1/1 3/1/1\nf 1/2/1 3/1/2 4/1/1\nf 1/1/1 3/1/1 4/1/1");
        Assert.Equal([0, 1, 2, 3, 4, 5, 0, 2, 5], mesh.Indices);
        Assert.Equal((mesh.Positions[0], mesh.Positions[2]), (mesh.Positions[3], mesh.Positions[4]));
    }

    [Fact]
    public void Lines_may_be_continued_commented_indented_and_end_in_any_way()
    {
        const string Text = "\uFEFF# a comment \\\n  v 0 \\\n 0 \\\n0 # another\nv 1 0 0\r\nv\t1 1 0\rv +0 1. .0\n\n f 1 2\\\n3\\\n 4\nv 5 5 5\\";
        MeshData mesh = Mesh(Text);
        Assert.Equal([0, 1, 2, 0, 2, 3], mesh.Indices);
        Assert.Equal(new Vector3(0, 1, 0), mesh.Positions[3]);
    }

    [Fact]
    public void Colours_behind_positions_are_decoded_from_sRGB_and_lie_on_white()
    {
        ImportedModel model = Parse("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 1.0 0 0 1\nf 1 2 3");
        MeshDescription shape = Shape(model);
        Assert.Equal([new(1, (float)SrgbCurve.Decode(0.5), 0), Rgb.White, new Rgb(0, 0, 1)], shape.Data!.Colors!);
        Assert.Equal(Rgb.White, Color(Assert.IsType<DiffuseMaterialDescription>(shape.Material).Color));
    }

    // A roof of two faces: smooth over the ridge in one group, the mean of the faces weighted by their areas; flat without.
    [Theory]
    [InlineData("s 1\n", "", true)]
    [InlineData("s 3\n", "s 3\n", true)]
    [InlineData("s 1\n", "s 2\n", false)]
    public void Smoothing_groups_make_normals_of_their_own_faces(string first, string second, bool isSmooth)
    {
        MeshData mesh = Mesh("v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 -3\n" + first + "f 1 3 2\n" + second + "f 1 2 4");
        (Vector3 right, Vector3 left) = (new(0, 0, 1), new(-3, 0, 0));
        Assert.Equal(isSmooth ? 4 : 6, mesh.Positions.Length);
        Assert.Equal(isSmooth ? right + left : right, mesh.Normals![0]);
        Assert.Equal(right, mesh.Normals![1]);
        Assert.Equal(left, mesh.Normals![^1]);
    }

    [Fact]
    public void Groups_are_meshes_of_their_names_and_flat_faces_are_parted_from_smooth_ones()
    {
        ImportedModel model = Parse(Square + "g one two\nf 1 2 3\no other\nf 1 3 4\ng one two\nf 2 3 4\ns 1\nf 1 2 4\ns off\nf 1 2 3");
        MeshDescription[] shapes = [.. model.Scene.Shapes.Cast<MeshDescription>()];
        Assert.Equal([("one two", 3, false), ("other", 1, false), ("one two", 1, true)], shapes.Select(s => (s.Name, s.Data!.TriangleCount, s.Data.Normals is not null)));
        Assert.Equal([0, 1, 2, 1, 2, 3, 0, 1, 2], shapes[0].Data!.Indices);
    }

    [Fact]
    public void Very_many_groups_are_one_mesh()
    {
        var text = new StringBuilder(Square);
        for (int i = 0; i < 3000; i++)
        {
            text.Append($"g part {i}\nf 1 2 3\n");
        }

        Assert.Equal(3000, Mesh(text.ToString()).TriangleCount);
    }

    [Fact]
    public void Materials_are_chosen_by_triangle_and_files_with_spaces_in_their_names_are_found()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["my materials.mtl"], "newmtl red paint \nKd 1 0 0\nnewmtl green\nKd 0 0.25 0\n");
        File.WriteAllText(folder["two.mtl"], "newmtl blue\nKd 0 0 1");
        ImportedModel model = Parse(Square + "mtllib my materials.mtl\nmtllib two.mtl none.mtl\nusemtl red paint\nf 1 2 3\nusemtl green\nf 1 2 3\nf 2 3 4\nusemtl red paint\nf 1 2 3\nusemtl strange\nf 1 2 3", folder.Path);
        MeshDescription shape = Shape(model);
        Assert.Equal([0, 1, 1, 0, 2], shape.Data!.MaterialOfTriangle!);
        Assert.Equal([new(1, 0, 0), new Rgb(0, 0.25f, 0)], shape.Materials.Take(2).Select(m => Color(((DiffuseMaterialDescription)m).Color)));
        Assert.Same(ShapeDescription.DefaultMaterial, shape.Materials[2]);
        Assert.Equal(["no material file describes \"strange\": grey is used instead", "the material file \"none.mtl\" does not exist"], model.Notes);
        Assert.Equal(new Rgb(0, 0, 1), Color(((DiffuseMaterialDescription)Shape(Parse(Square + "mtllib TWO.mtl\nusemtl blue\nf 1 2 3", folder.Path)).Material).Color));
    }

    public static TheoryData<string, MaterialDescription> Materials => new()
    {
        { "Kd 0.5 0.25 2\nKa 1 1 1", Matt(0.5f, 0.25f, 1) },
        { "Kd 0.5", Matt(0.5f, 0.5f, 0.5f) },
        { "", Matt(0.8f, 0.8f, 0.8f) },
        { "Kd 0.5\nKs 0.2 0.1 0\nNs 30", Shining(0.5f, 0.5f) with { Specular = 0.2f } },
        { "Kd 0 0 0\nKs 0.9 0.8 0.7\nNs 30\nillum 3", Shining(1, 0.5f) with { BaseColor = Solid(0.9f, 0.8f, 0.7f), Specular = 0.9f, Metallic = Number(1) } },
        { "Kd 0.5\nKs 1 1 1\nillum 1", Matt(0.5f, 0.5f, 0.5f) },
        { "Kd 0.5\nPr 0.3\nPm 0.9\nPs 0.1\nPc 0.4\nPcr 0.2\naniso 0.6", Shining(0.5f, 0.3f) with { Metallic = Number(0.9f), Sheen = Number(0.1f), Clearcoat = Number(0.4f), ClearcoatRoughness = Number(0.2f), Anisotropic = Number(0.6f) } },
        { "Kd 0.5\nillum 7\nNi 1.33", new DielectricMaterialDescription { RefractiveIndex = 1.33f } },
        { "illum 4", new DielectricMaterialDescription { RefractiveIndex = 1.5f } },
        { "Kd 0.5\nTr 0.75", new MaskMaterialDescription { Material = Matt(0.5f, 0.5f, 0.5f), Opacity = Number(0.25f) } },
        { "Tr 1\nd 1\nKd 0.5", Matt(0.5f, 0.5f, 0.5f) },
        { "d -halo 0.1\nKd 0.5", Matt(0.5f, 0.5f, 0.5f) },
        { "d 0.75\nKd 0.5", new MaskMaterialDescription { Material = Matt(0.5f, 0.5f, 0.5f), Opacity = Number(0.75f) } },
        { "illum 7\nNi 1.0", new DielectricMaterialDescription { RefractiveIndex = 1.5f } },
        { "Ke 3 2 1\nKd 0.5", new LuminaireMaterialDescription { Color = Solid(3, 2, 1), Material = Matt(0.5f, 0.5f, 0.5f) } },
    };

    [Theory]
    [MemberData(nameof(Materials), DisableDiscoveryEnumeration = true)]
    public void Materials_become_the_nearest_of_ours(string statements, MaterialDescription expected)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["a.mtl"], "newmtl m\n" + statements.Replace("\n", "\r\n\t", StringComparison.Ordinal));
        Assert.Equal(expected, Shape(Parse(Square + "mtllib a.mtl\nusemtl m\nf 1 2 3", folder.Path)).Material);
    }

    [Fact]
    public void Pictures_are_found_with_their_options_and_what_is_missing_is_noted()
    {
        using TemporaryFolder folder = new();
        ImageFile.Write(folder["A picture.png"], new Picture(2, 2));
        File.WriteAllText(folder["picture.tga"], "x");
        File.WriteAllText(folder["a.mtl"], """
            newmtl a
            Kd 0.5 0.5 0.5
            map_Kd -s 2 3 1 -o 0.5 -clamp on -mm 0 1 C:\textures\a Picture.png
            map_bump -bm 0.25 A picture.png
            map_d A picture.png
            map_Bump nothing.png
            newmtl b
            refl x.png
            Kd 1 0 0
            map_Kd missing.png
            newmtl c
            map_Kd picture.tga
            newmtl e
            map_Ke A picture.png
            Tf 0.5 1 1
            """);
        ImportedModel model = Parse(Square + "mtllib a.mtl\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\nusemtl e\nf 1 2 3", folder.Path);
        IReadOnlyList<MaterialDescription> materials = Shape(model).Materials;
        ImageTextureDescription expected = new() { File = folder["A picture.png"], Scale = new(2, 3), Offset = new(0.5f, 0), Wrapping = Wrapping.Clamp };
        ImageTextureDescription plain = new() { File = folder["A picture.png"] };
        MaskMaterialDescription mask = Assert.IsType<MaskMaterialDescription>(materials[0]);
        BumpMapMaterialDescription bump = Assert.IsType<BumpMapMaterialDescription>(mask.Material);
        Assert.Equal(plain with { Raw = true }, mask.Opacity);
        Assert.Equal((0.25f, plain with { Raw = true }), (bump.Scale, bump.Map));
        Assert.Equal(new ProductTextureDescription { First = expected, Second = Solid(0.5f, 0.5f, 0.5f) }, ((DiffuseMaterialDescription)bump.Material).Color);
        Assert.Equal(
            new ProductTextureDescription { First = new ImageTextureDescription { Picture = StandIn.Checks }, Second = Solid(1, 0, 0) },
            ((DiffuseMaterialDescription)materials[1]).Color);
        Assert.Equal(plain, ((LuminaireMaterialDescription)materials[3]).Color);
        Assert.Equal(
            [
                "emission (Ke) becomes a luminaire with Ke as its radiance, on the side that the normal points to",
                "the picture \"missing.png\" is not there: magenta checks are shown instead",
                "the picture \"nothing.png\" is not there: its number is used instead",
                "the picture \"picture.tga\" has no readable format (.png, .jpg, .pfm, .exr or .hdr): magenta checks are shown instead",
                "these material statements are ignored: Tf, refl",
            ],
            model.Notes);
    }

    [Fact]
    public void What_is_left_out_is_noted_once()
    {
        ImportedModel model = Parse(Square + "l 1 2\np 1\ncurv 0 1 2\nf 1 2\nf 1 2 3\nf 3\nnonsense 1\nrubbish\nv 3.1+e2 0 0\n");
        Assert.Equal(
            ["line 13: a number is followed by stray characters, which are ignored", "line 8: faces with fewer than three corners are ignored",
                "ignored: \"nonsense\" in line 11 and other lines that are not OBJ statements; curves and curved surfaces; lines and points"],
            model.Notes);
    }

    public static TheoryData<string, string> BadFiles => new()
    {
        { "there are no faces in it (0 vertices)", "" },
        { "there are no faces in it (4 vertices)", Square },
        { "line 5: there is no vertex 5: 4 come before this face, counted from 1, or back from -1", Square + "f 1 2 5" },
        { "line 5: there is no vertex -5: 4 come", Square + "f 1 2 -5" },
        { "line 6: there is no vertex 0: 4 come", Square + "\nf 0 1 2" },
        { "line 5: there is no uv (vt) 1: 0 come", Square + "f 1/1 2/1 3/1" },
        { "line 5: there is no normal (vn) 99999999", Square + "f 1//99999999999999999999 2 3" },
        { "line 5: expected a corner such as 1, 1/2, 1//3 or 1/2/3 instead of \"1.5\"", Square + "f 1.5 2 3" },
        { "line 5: expected a corner such as 1, 1/2, 1//3 or 1/2/3 instead of \"a\"", Square + "f 1 2 a" },
        { "line 5: expected a corner such as 1, 1/2, 1//3 or 1/2/3 instead of \"1/-/-\"", Square + "f 1/-/-" },
        { "line 3: expected a number instead of \"0,5\"", "v 0 0 0\n#\nv 0,5 0 0" },
        { "line 2: expected a number, but the file ends", "#\nv 0 0\nv 0 0 0" },
        { "line 1: expected a number instead of \"x\\u007F\"", "v\u0001x\u007F 0 0" },
    };

    [Theory]
    [MemberData(nameof(BadFiles), DisableDiscoveryEnumeration = true)]
    public void Bad_files_are_refused_with_the_line_and_what_was_expected(string message, string file) =>
        Assert.StartsWith(message, Assert.Throws<ModelException>(() => Parse(file)).Message, StringComparison.Ordinal);

    [Fact]
    public void Faults_of_material_files_are_reported_with_their_file_and_line()
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder["a.mtl"], "newmtl m\nKd red");
        ImportedModel model = Parse(Square + "mtllib a.mtl\nusemtl m\nf 1 2 3", folder.Path);
        Assert.Equal("a.mtl: line 2: expected a number instead of \"red\": the statement is ignored", Assert.Single(model.Notes));
        Assert.Equal(new Rgb(1, 0, 1), Assert.IsType<SolidTextureDescription>(Assert.IsType<DiffuseMaterialDescription>(Shape(model).Materials is [var only] ? only : Shape(model).Material).Color).Color);
        StandIn.IsError = true;
        Assert.Equal("a.mtl: line 2: expected a number instead of \"red\"", Assert.Throws<ModelException>(() => Parse("mtllib a.mtl", folder.Path)).Message);
        File.WriteAllText(folder["a.mtl"], "Kd 1 0 0");
        Assert.Equal("a.mtl: line 1: a statement comes before the first newmtl", Assert.Throws<ModelException>(() => Parse("mtllib a.mtl", folder.Path)).Message);
    }

    [Fact]
    public void Damage_gives_nothing_but_a_ModelException()
    {
        const string Text = Square + "vt 0 0\nvt 1 1\nvn 0 0 1\n# comment\nmtllib a.mtl\ng a b\nusemtl m\ns 1\nf 1/1/1 2/2/1 3/1/1 4/2/1\nf -1 -2 -3 \\\n -4\ns off\no c\nf 1//1 2//1 3//1\nl 1 2\nv 1e5 2.5 -3.25 0.5 0.25 1\nf 1 2 5 3 4\n";
        byte[][] pieces = [[.. "f 1 2 3\n"u8], [.. " 999999999 "u8], [.. "\\\n"u8], [.. "//"u8], [.. "-"u8], [.. "1e999"u8], [0], [.. "\nusemtl x\n"u8]];
        ModelFuzz.Run(Encoding.ASCII.GetBytes(Text), f => ObjReader.Parse(f, "", "x"), pieces);
        const string Statements = "newmtl m\nKd 1 0.5 0\nKs 0.5 0.5 0.5\nNs 20\nd 0.5\nTr 0.25\nillum 2\nKe 0 0 0\nmap_Kd -s 1 2 3 -o 1 x.png\nbump -bm 2 y.png\nPr 0.5\nNi 1.5\nnewmtl n\nKd xyz 1 2 3\nTf 1 1 1\n";
        StandIn.IsError = true;
        ModelFuzz.Run(Encoding.ASCII.GetBytes(Statements), ReadMaterials, pieces);
    }

    [SkippableTheory]
    [InlineData("obj/box.obj", 12, 1)]
    [InlineData("obj/box_longline.obj", 944, 1)]
    [InlineData("obj/box_without_lineending.obj", 12, 1)]
    [InlineData("obj/concave_polygon.obj", 64, 1)]
    [InlineData("obj/cube_usemtl.obj", 12, 1)]
    [InlineData("obj/cube_with_vertexcolors.obj", 12, 1)]
    [InlineData("obj/number_formats.obj", 1, 1)]
    [InlineData("obj/space_in_material_name.obj", 64, 1)]
    [InlineData("obj/testmixed.obj", 12, 1)]
    [InlineData("models/cow.obj", 5804, 1)]
    [InlineData("models/rocker-arm.obj", 20088, 1)]
    [InlineData("models/spot.obj", 5856, 1)]
    [InlineData("models/stanford-bunny.obj", 69451, 1)]
    [InlineData("models/teapot.obj", 6320, 1)]
    public void Real_files_are_read(string path, int triangles, int shapes)
    {
        ImportedModel model = ModelFile.Read(SharedModels.Find(path.Split('/')));
        Assert.Equal(shapes, model.Scene.Shapes.Count);
        Assert.Equal(triangles, model.Scene.Shapes.Cast<MeshDescription>().Sum(s => s.Data!.TriangleCount));
    }

    [SkippableFact]
    public void Real_files_that_are_broken_on_purpose_get_a_message()
    {
        Assert.StartsWith("it is empty", Refusal("empty.obj"), StringComparison.Ordinal);
        Assert.Matches("^line [0-9]+: there is no vertex 12: 8 come before this face", Refusal("malformed.obj"));
        Assert.Contains(ModelFile.Read(SharedModels.Find("invalid", "malformed2.obj")).Notes, n => n.EndsWith("faces with fewer than three corners are ignored", StringComparison.Ordinal));
    }

    private static string Refusal(string name)
    {
        string path = SharedModels.Find("invalid", name);
        return Assert.Throws<ModelException>(() => ModelFile.Read(path)).Message;
    }

    private static void ReadMaterials(byte[] file)
    {
        var library = new MtlLibrary("");
        library.Use("m");
        library.Parse(file);
        library.Materials([]);
    }

    private static ImportedModel Parse(string text, string folder = "") => ObjReader.Parse(Encoding.UTF8.GetBytes(text), folder, "name");

    private static MeshDescription Shape(ImportedModel model) => Assert.IsType<MeshDescription>(Assert.Single(model.Scene.Shapes));

    private static MeshData Mesh(string text) => Shape(Parse(text)).Data!;

    private static Rgb Color(TextureDescription texture) => ((SolidTextureDescription)texture).Color;

    private static SolidTextureDescription Solid(float r, float g, float b) => new() { Color = new(r, g, b) };

    private static DiffuseMaterialDescription Matt(float r, float g, float b) => new() { Color = Solid(r, g, b) };

    private static SolidTextureDescription Number(float value) => Solid(value, value, value);

    private static PrincipledMaterialDescription Shining(float color, float roughness) => new() { BaseColor = Number(color), Roughness = Number(roughness) };
}
