using System.Diagnostics;
using System.Text;
using RayTracer.Imaging;

namespace RayTracer.Cli.Tests;

/// <summary>
/// Files that are small and ask for much, or that never end, as the command meets them; in processes that are ended when they do not end
/// by themselves. Covers <see cref="LimitOptions"/>, <see cref="AtomicFile"/> and the limits of the readers.
/// </summary>
public sealed class HostileFileTests : IDisposable
{
    private const string Sphere = """{ "type": "sphere", "center": [0, 0, 0] }""";
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60);
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Mixes_of_one_another_are_counted_and_refused()
    {
        StringBuilder materials = new("\"m0\": { \"type\": \"diffuse\" }");
        for (int i = 1; i < 30; i++)
        {
            materials.Append($$""", "m{{i}}": { "type": "mix", "first": "m{{i - 1}}", "second": "m{{i - 1}}" }""");
        }

        Refused("mix.json", $$"""{ "materials": { {{materials}} }, "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": "m29" }] }""", "consists of more than 256 others");
    }

    [Fact]
    public void Blends_of_one_another_in_Mitsubas_format_are_refused()
    {
        StringBuilder scene = new("""<scene version="3.0.0"><sensor type="perspective"><float name="fov" value="40"/></sensor><bsdf type="diffuse" id="b0"/>""");
        for (int i = 1; i < 28; i++)
        {
            scene.Append($"""<bsdf type="blendbsdf" id="b{i}"><float name="weight" value="0.5"/><ref id="b{i - 1}"/><ref id="b{i - 1}"/></bsdf>""");
        }

        Refused("blend.xml", scene + """<shape type="disk"><ref id="b27"/></shape></scene>""", "consists of more than 256 others");
    }

    [Fact]
    public void A_mix_of_many_different_materials_is_none_of_them()
    {
        StringBuilder materials = new("\"m0\": { \"type\": \"diffuse\" }");
        for (int i = 1; i < 40; i++)
        {
            materials.Append($$""", "m{{i}}": { "type": "mix", "first": "m{{i - 1}}", "second": { "type": "phong" } }""");
        }

        string scene = Write("mix.json", $$"""{ "background": "white", "materials": { {{materials}} }, "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": "m39" }] }""");
        Assert.Equal(0, Run("check", scene).Status);
    }

    [Fact]
    public void A_jagged_polygon_of_very_many_corners_is_cut_in_time()
    {
        StringBuilder model = new();
        const int Corners = 60_000;
        for (int i = 0; i < Corners; i++)
        {
            (double radius, double angle) = (1 + (0.5 * (i % 2)), 2 * Math.PI * i / Corners);
            model.Append(System.Globalization.CultureInfo.InvariantCulture, $"v {radius * Math.Cos(angle)} {radius * Math.Sin(angle)} 0\n");
        }

        string file = Write("polygon.obj", model + "f " + string.Join(' ', Enumerable.Range(1, Corners)) + "\n");
        (int status, string said) = Run("check", file);
        Assert.Equal(0, status);
        Assert.Contains("not triangulated properly", said, StringComparison.Ordinal);
    }

    [Fact]
    public void Very_many_names_that_come_twice_are_reported_in_time() =>
        Refused("names.json", "{" + string.Join(',', Enumerable.Range(0, 60_000).Select(i => $"\"k{i % 30_000}\":1")) + "}", "and 89980 more");

    [Fact]
    public void Instances_of_instances_are_counted_against_the_memory()
    {
        StringBuilder objects = new($$""" "o0": { "type": "group", "shapes": [{{Sphere}}] }""");
        for (int i = 1; i < 30; i++)
        {
            objects.Append($$""", "o{{i}}": { "type": "group", "shapes": [{ "type": "instance", "of": "o{{i - 1}}" }, { "type": "instance", "of": "o{{i - 1}}", "transform": [{ "translate": [1, 0, 0] }] }] }""");
        }

        string scene = $$"""{ "background": "white", "objects": { {{objects}} }, "shapes": [{ "type": "instance", "of": "o29" }] }""";
        Refused("instances.json", scene, "beyond its 50 MiB of memory (--memory sets another limit)", "--memory", "50M");
    }

    [Fact]
    public void Pictures_count_against_the_memory_before_and_after_they_are_unpacked()
    {
        // A bit a pixel, and all the same: 4,096 × 4,096 pixels in a few kilobytes.
        byte[] rows = new byte[4096 * 513];
        File.WriteAllBytes(_folder["flat.png"], TestPng.File(TestPng.Header(4096, 4096, 1, 0), TestPng.Chunk("IDAT", TestPng.Zlib(rows)), TestPng.End));
        string texture = """{ "type": "image", "file": "FILE" }""";
        string scene = $$"""
            { "background": "white", "textures": { "a": {{texture.Replace("FILE", "flat.png", StringComparison.Ordinal)}}, "b": {{texture.Replace("FILE", "./flat.png", StringComparison.Ordinal)}} },
              "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": { "type": "mix", "first": { "type": "diffuse", "color": "a" }, "second": { "type": "diffuse", "color": "b" } } }] }
            """;
        Refused("pictures.json", scene, "at most 8738133 in all", "--memory", "100M");
        Refused("pictures.json", scene, "error: cannot read \"flat.png\": a picture of 4096×4096 pixels would take the scene beyond its 10,485,760 steps of work (--work sets another limit)", "--work", "10M");

        // One file by two names is read once, a copy of it is another.
        Assert.Equal(0, Run("check", _folder["pictures.json"], "--memory", "300M", "--work", "17M").Status);
        File.Copy(_folder["flat.png"], _folder["copy.png"]);
        scene = scene.Replace("./flat.png", "copy.png", StringComparison.Ordinal);
        Refused("pictures.json", scene, "a picture of 4096×4096 pixels would take the scene beyond its 300 MiB", "--memory", "300M");
        Refused("pictures.json", scene, "steps of work", "--work", "17M");
        Assert.Equal(0, Run("check", _folder["pictures.json"], "--memory", "0.5GiB").Status);
    }

    [Fact]
    public void Textures_of_one_another_are_counted_and_refused()
    {
        StringBuilder textures = new("\"t0\": { \"type\": \"checker\" }");
        for (int i = 1; i < 30; i++)
        {
            textures.Append($$""", "t{{i}}": { "type": "checker", "even": "t{{i - 1}}", "odd": "t{{i - 1}}" }""");
        }

        string scene = $$"""{ "background": "white", "textures": { {{textures}} }, "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": { "type": "diffuse", "color": "tLAST" } }] }""";
        Refused("textures.json", scene.Replace("LAST", "29", StringComparison.Ordinal), "the texture consists of more than 1024 others");
        Assert.Equal(0, Run("check", Write("few.json", scene.Replace("LAST", "7", StringComparison.Ordinal))).Status);
    }

    [Fact]
    public void A_model_in_many_places_costs_memory_and_work_in_each()
    {
        StringBuilder model = new();
        for (int i = 0; i < 3000; i++)
        {
            model.Append(System.Globalization.CultureInfo.InvariantCulture, $"v {i} 0 0\nv {i} 1 0\nv {i} 0 1\nf {(3 * i) + 1} {(3 * i) + 2} {(3 * i) + 3}\n");
        }

        Write("m.obj", model.ToString());
        string shapes = string.Join(",\n", Enumerable.Range(0, 20).Select(i => $$"""{ "type": "model", "file": "m.obj", "transform": [{ "translate": [0, {{i}}, 0] }] }"""));
        string scene = $$"""{ "background": "white", "shapes": [{{shapes}}] }""";
        Refused("places.json", scene, "places.json:8:28: error: 3000 more triangles would take the scene beyond its 524,288 steps of work (--work sets another limit)", "--work", "512K");
        Refused("places.json", scene, "3000 more triangles would take the scene beyond its 1 MiB of memory", "--memory", "1M");
        Refused("places.json", scene, "steps of work", "--work", "100K");
        Assert.Equal(0, Run("check", _folder["places.json"], "--work", "2M").Status);
    }

    [Fact]
    public void Texts_of_a_picture_are_counted_together()
    {
        byte[] text = [.. "key\0\0"u8, .. TestPng.Zlib(new byte[1 << 22])];
        byte[][] texts = [.. Enumerable.Range(0, 6).Select(_ => TestPng.Chunk("zTXt", text))];
        File.WriteAllBytes(_folder["texts.png"], TestPng.File([TestPng.Header(1, 1), .. texts, TestPng.End]));
        (int status, string said) = Run("info", _folder["texts.png"]);
        Assert.NotEqual(0, status);
        Assert.Contains("texts have more than 16777216 characters together", said, StringComparison.Ordinal);
    }

    [Fact]
    public void A_file_that_many_buffers_name_is_read_once()
    {
        File.WriteAllBytes(_folder["big.bin"], new byte[4 << 20]);
        string buffers = string.Join(',', Enumerable.Repeat("""{ "uri": "big.bin", "byteLength": 4194304 }""", 1000));
        string views = string.Join(',', Enumerable.Range(0, 1000).Select(i => $$"""{ "buffer": {{i}}, "byteLength": 4194304 }"""));
        string accessors = string.Join(',', Enumerable.Range(0, 1000).Select(i => $$"""{ "bufferView": {{i}}, "componentType": 5126, "count": 3, "type": "VEC3" }"""));
        string primitives = string.Join(',', Enumerable.Range(0, 1000).Select(i => $$"""{ "attributes": { "POSITION": {{i}} } }"""));
        string model = Write("buffers.gltf", $$"""
            { "asset": { "version": "2.0" }, "buffers": [{{buffers}}], "bufferViews": [{{views}}], "accessors": [{{accessors}}],
              "meshes": [{ "primitives": [{{primitives}}] }], "nodes": [{ "mesh": 0 }], "scenes": [{ "nodes": [0] }] }
            """);
        using Process process = ProcessTests.Start("check", model);
        _ = process.StandardOutput.ReadToEndAsync();
        _ = process.StandardError.ReadToEndAsync();
        long most = 0;
        for (Stopwatch watch = Stopwatch.StartNew(); !process.WaitForExit(50) && watch.Elapsed < s_patience;)
        {
            process.Refresh();
            most = Math.Max(most, process.HasExited ? 0 : process.WorkingSet64);
        }

        Assert.True(process.HasExited, "the check did not end");
        Assert.InRange(most, 1, 1L << 30);
    }

    [LinuxFact]
    public void What_never_ends_is_no_input()
    {
        ProgramFactAttribute.Run("mkfifo", _folder["pipe.png"], _folder["pipe.obj"]);
        Refused("texture.json", """{ "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": { "type": "diffuse", "color": { "type": "image", "file": "pipe.png" } } }] }""", "only ordinary files are read");
        Refused("model.json", """{ "shapes": [{ "type": "model", "file": "pipe.obj" }] }""", "only ordinary files are read");
        Refused("zero.xml", """<scene version="3.0.0"><shape type="sphere"><bsdf type="diffuse"><spectrum name="reflectance" filename="/dev/zero"/></bsdf></shape></scene>""", "only ordinary files are read");
        Assert.Contains("only ordinary files are read", Run("check", _folder["pipe.obj"]).Said, StringComparison.Ordinal);
    }

    [LinuxFact]
    public void What_is_no_file_is_not_replaced()
    {
        string pipe = _folder["pipe.png"];
        ProgramFactAttribute.Run("mkfifo", pipe);
        File.CreateSymbolicLink(_folder["null.png"], "/dev/null");
        string scene = Write("scene.json", CliRun.Scene);
        foreach (string output in new[] { pipe, _folder["null.png"] })
        {
            (int status, string said) = Run("render", scene, "-o", output, "--quiet");
            Assert.Equal(4, status);
            Assert.Contains("that is a pipe or a device, which a file would replace", said, StringComparison.Ordinal);
        }

        // An empty file is a file.
        File.WriteAllBytes(_folder["empty.png"], []);
        Assert.Equal(0, Run("render", scene, "-o", _folder["empty.png"], "--quiet").Status);
        Assert.True(ImageFile.IsImage(_folder["empty.png"]));
    }

    [Fact]
    public void Scenes_read_nothing_outside_of_the_root()
    {
        Directory.CreateDirectory(_folder["inside"]);
        ImageFile.Write(_folder["inside/a.png"], TestPictures.Noise(4, 4));
        ImageFile.Write(_folder["b.png"], TestPictures.Noise(4, 4));
        string scene = """{ "background": "white", "shapes": [{ "type": "sphere", "center": [0, 0, 0], "material": { "type": "diffuse", "color": { "type": "image", "file": "FILE" } } }] }""";
        string root = _folder["inside"];
        Write("inside/good.json", scene.Replace("FILE", "a.png", StringComparison.Ordinal));
        Assert.Equal((0, ""), (Run("check", _folder["inside/good.json"], "--root", root) is var good ? good.Status : -1, good.Said.Contains("error", StringComparison.Ordinal) ? good.Said : ""));
        Refused("inside/bad.json", scene.Replace("FILE", "../b.png", StringComparison.Ordinal), "it is outside of the folder that scenes may read", "--root", root);
        if (!OperatingSystem.IsWindows())
        {
            Directory.CreateSymbolicLink(_folder["inside/link"], _folder.Path);
            Refused("inside/link.json", scene.Replace("FILE", "link/b.png", StringComparison.Ordinal), "it is outside of the folder that scenes may read", "--root", root);
        }
    }

    [Fact]
    public void Messages_quote_nothing_of_files_that_are_no_scenes()
    {
        File.WriteAllText(_folder["secret"], "root:x:0:0:root\n");
        Write("model.obj", "mtllib secret\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        string spectrum = Write("scene.xml", """<scene version="3.0.0"><shape type="sphere"><bsdf type="diffuse"><spectrum name="reflectance" filename="secret"/></bsdf></shape></scene>""");
        Assert.DoesNotContain("root:x", Run("check", _folder["model.obj"]).Said, StringComparison.Ordinal);
        Assert.DoesNotContain("root:x", Run("check", spectrum).Said, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--memory", "3x", "--memory must be an amount such as 512M or 16G")]
    [InlineData("--memory", "0", "--memory must be an amount such as 512M or 16G")]
    [InlineData("--work", "much", "--work must be an amount such as 512M or 16G")]
    [InlineData("--root", "nowhere", "--root: there is no folder")]
    public void Wrong_limits_are_refused(string option, string value, string expected)
    {
        (int status, string said) = Run("check", Write("scene.json", CliRun.Scene), option, value);
        Assert.Equal(2, status);
        Assert.Contains(expected, said, StringComparison.Ordinal);
    }

    private void Refused(string name, string content, string expected, params string[] options)
    {
        (int status, string said) = Run(["check", Write(name, content), .. options]);
        Assert.Equal(3, status);
        Assert.Contains(expected, said, StringComparison.Ordinal);
    }

    private string Write(string name, string content)
    {
        File.WriteAllText(_folder[name], content);
        return _folder[name];
    }

    // In a process, which has limits for itself.
    private static (int Status, string Said) Run(params string[] args)
    {
        using Process process = ProcessTests.Start(args);
        Task<string> output = process.StandardOutput.ReadToEndAsync();
        Task<string> error = process.StandardError.ReadToEndAsync();
        bool ended = process.WaitForExit(s_patience);
        if (!ended)
        {
            process.Kill();
        }

        Assert.True(ended, $"raytracer {string.Join(' ', args)} did not end in {s_patience.TotalSeconds} s");
        return (process.ExitCode, output.Result + error.Result);
    }
}
