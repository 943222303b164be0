using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

public class MitsubaReaderTests
{
    [Fact]
    public void Parameters_stand_for_their_values_and_the_longest_name_is_meant()
    {
        SceneDescription scene = TestScene.Of("""
            <default name="r" value="2"/>
            <default name="r" value="3"/>
            <default name="r2" value="0.5"/>
            <shape type="sphere"><float name="radius" value="$r"/><point name="center" value="$r2, 1$r, 0"/></shape>
            """);
        SphereDescription sphere = Assert.IsType<SphereDescription>(Assert.Single(scene.Shapes));
        Assert.Equal((2, new(0.5f, 12, 0)), (sphere.Radius, sphere.Center));
    }

    [Fact]
    public void Values_out_of_range_are_errors_at_the_place_of_what_has_them_or_of_what_is_around_it()
    {
        using TestScene scene = new();
        string sensor = TestScene.Sensor.Replace("type=\"box\"/>", "type=\"tent\"><float name=\"radius\" value=\"99\"/></rfilter>", StringComparison.Ordinal);
        string path = scene.Write("scene.xml", "<shape type=\"sphere\"><float name=\"radius\" value=\"-1\"/></shape>", sensor);
        SceneLoadResult load = SceneLoader.Load(path);
        Assert.Equal(
            [$"{path}:2:2: error: \"radius\" must be from 0 to 16, but is 99", $"{path}:3:2: error: \"radius\" must be greater than 0, but is -1"],
            load.Diagnostics.Select(d => d.ToString()));
        Assert.All(load.Diagnostics, d => Assert.Equal(DiagnosticRule.OutOfRange, d.Rule));
        Assert.Null(load.Scene);
    }

    [Fact]
    public void Spectra_beyond_the_three_primaries_are_brought_into_range_with_a_warning()
    {
        using TestScene scene = new();
        string path = scene.Write("scene.xml", """
            <shape type="rectangle"><bsdf type="diffuse"><spectrum name="reflectance" value="400:0, 575:0, 576:1, 830:1"/></bsdf></shape><emitter type="constant"/>
            """);
        SceneLoadResult load = SceneLoader.Load(path);
        Assert.Equal(
            "the spectrum of \"reflectance\" is a colour beyond the three primaries: its channels are brought into range, from 0 to 1",
            Assert.Single(load.Diagnostics).Message);
        Assert.NotNull(load.Scene);
    }

    [Fact]
    public void References_reach_forward_and_share_what_they_name()
    {
        SceneDescription scene = TestScene.Of("""
            <shape type="sphere"><ref id="red"/></shape>
            <shape type="rectangle"><ref id="also red"/></shape>
            <bsdf type="diffuse" id="red"><rgb name="reflectance" value="0.7, 0.1, 0.1"/></bsdf>
            <alias id="red" as="also red"/>
            """);
        Assert.Same(scene.Shapes[0].Material, scene.Shapes[1].Material);
        Assert.Same(scene.Shapes[0].Material, scene.Materials["red"]);
    }

    [Fact]
    public void Included_files_add_their_things_and_name_files_from_where_they_are()
    {
        using TestScene scene = new();
        Directory.CreateDirectory(scene["parts"]);
        File.WriteAllText(scene["parts/cube.obj"], "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        scene.Write("parts/things.xml", """<shape type="obj"><string name="filename" value="cube.obj"/><ref id="grey"/></shape>""", "");
        File.WriteAllText(scene["parts/grey.xml"], """<bsdf version="3.0.0" type="diffuse" id="grey"/>""");
        string path = scene.Write("scene.xml", """<include filename="parts/things.xml"/><include filename="parts/grey.xml"/><emitter type="constant"/>""");
        SceneLoadResult load = SceneLoader.Load(path);
        Assert.Equal("", Diagnostic.Format(load.Diagnostics));
        Assert.Equal("parts/cube.obj", Assert.IsType<MeshDescription>(Assert.Single(load.Description!.Shapes)).File);
    }

    [Fact]
    public void Files_are_looked_for_where_paths_say_too()
    {
        using TestScene scene = new();
        Directory.CreateDirectory(scene["pictures"]);
        File.WriteAllBytes(scene["pictures/a.png"], []);
        string path = scene.Write("scene.xml", """
            <path value="pictures"/>
            <shape type="sphere"><bsdf type="diffuse"><texture type="bitmap" name="reflectance"><string name="filename" value="a.png"/></texture></bsdf></shape>
            """);
        OneSidedMaterialDescription side = Assert.IsType<OneSidedMaterialDescription>(MitsubaReader.Read(path).Description!.Shapes[0].Material);
        DiffuseMaterialDescription matt = Assert.IsType<DiffuseMaterialDescription>(side.Material);
        Assert.Equal("pictures/a.png", Assert.IsType<ImageTextureDescription>(matt.Color).File);
    }

    [Fact]
    public void Complaints_about_built_things_have_their_places_too()
    {
        using TestScene scene = new();
        string path = scene.Write("scene.xml", """<shape type="obj"><string name="filename" value="no.obj"/></shape>""");
        Diagnostic complaint = Assert.Single(SceneLoader.Load(path).Diagnostics);
        Assert.Equal((path, 3, 2), (complaint.File, complaint.Line, complaint.Column));
        Assert.StartsWith("cannot read \"no.obj\": file not found", complaint.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_scene_reads_back_equal_after_it_is_written_in_the_native_format()
    {
        SceneDescription scene = TestScene.Of("""
            <bsdf type="twosided" id="gold"><bsdf type="roughconductor"><string name="material" value="Au"/><float name="alpha" value="0.2"/></bsdf></bsdf>
            <shape type="shapegroup" id="things"><shape type="cube"><ref id="gold"/></shape><shape type="disk"/></shape>
            <shape type="instance"><ref id="things"/><transform name="to_world"><scale x="1" y="2" z="3"/></transform></shape>
            <shape type="sphere"><emitter type="area"><rgb name="radiance" value="3"/></emitter></shape>
            <emitter type="constant"/>
            """);
        string text = SceneWriter.Write(scene);
        SceneReadResult read = SceneReader.ReadText(text, "written.json");
        Assert.Equal("", Diagnostic.Format(read.Diagnostics));
        Assert.Equal(text, SceneWriter.Write(read.Description!));
        Assert.Equal(Rgb.White, read.Description!.Background);
    }

    [Fact]
    public void What_refers_to_what_refers_on_ends_somewhere()
    {
        string Chain(int length) => string.Concat(Enumerable.Range(0, length).Select(i => $"""<bsdf type="mask" id="m{i}"><ref id="m{i + 1}"/></bsdf>""")) + $"""<bsdf type="diffuse" id="m{length}"/>""";
        Assert.Equal(51, TestScene.Of(Chain(50)).Materials.Count);
        using TestScene scene = new();
        IReadOnlyList<Diagnostic> diagnostics = [.. MitsubaReader.Read(scene.Write("scene.xml", Chain(20_000))).Diagnostics];
        Assert.NotEmpty(diagnostics);
        Assert.All(diagnostics, d => Assert.Equal("objects are nested more than 64 deep", d.Message));
    }

    [Fact]
    public void Anything_in_the_middle_of_a_file_gives_diagnostics_and_no_exception()
    {
        string[] pieces =
            ["<shape type=\"sphere\">", "</shape>", "<bsdf type=\"diffuse\"/>", "<ref id=\"a\"/>", "<rgb name=\"reflectance\" value=\"1,2\"/>", "<integer/>", "&amp;", "&no;", "<a b='c'/>", "\"", "<", "<!--", "]]>", "<float name=\"radius\" value=\"$x\"/>", "<transform name=\"to_world\"><scale value=\"0\"/></transform>"];
        using TestScene scene = new();
        int good = 0;
        for (int i = 0; i < 300; i++)
        {
            IEnumerable<string> chosen = Enumerable.Range(0, 4).Select(k => pieces[(int)((((uint)i * 2654435761u) >> (4 * k)) % (uint)pieces.Length)]);
            SceneLoadResult load = SceneLoader.Load(scene.Write("scene.xml", string.Concat(chosen)));
            Assert.Equal(load.Scene is null, load.Diagnostics.Any(d => d.Severity == Severity.Error));
            good += load.Scene is null ? 0 : 1;
        }

        Assert.InRange(good, 0, 299);
    }
}
