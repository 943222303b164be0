using System.Text.Json;
using RayTracer.Imaging;

namespace RayTracer.Cli.Tests;

public sealed class AovTests : IDisposable
{
    private const string All = "depth,normal,albedo,uv,primitive,cryptoObject,cryptoMaterial,bvhCost,samples,error";

    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public AovTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Images_are_layers_of_exr_and_files_beside_other_formats()
    {
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.png"], "-o", _folder["a.exr"], "-o", _folder["b.pfm"], "--aov", All, "--json");
        Assert.Equal((0, ""), (run.Status, run.Error));
        string[] beside = [.. All.Split(',').SelectMany(n => new[] { $"a.{n}.png", $"b.{n}.pfm" })];
        string[] files = ["scene.json", "a.png", "a.exr", "b.pfm", .. beside];
        Assert.Equal(files.Order(StringComparer.Ordinal), Directory.GetFiles(_folder.Path).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));
        JsonElement json = JsonDocument.Parse(run.Output).RootElement;
        Assert.Equal(files.Length - 1, json.GetProperty("outputs").GetArrayLength());

        byte[] exr = File.ReadAllBytes(_folder["a.exr"]);
        foreach (string channel in new[] { "depth.Z", "normal.Y", "albedo.B", "uv.U", "primitive.Y", "bvhCost.Y", "samples.Y", "error.Y" })
        {
            string[] name = channel.Split('.');
            int component = Math.Max(0, "XYZ".IndexOf(name[0] == "normal" ? name[1] : "-", StringComparison.Ordinal)) + (channel == "albedo.B" ? 2 : 0);
            float[] pfm = ImageFile.Read(_folder[$"b.{name[0]}.pfm"]).Pixels;
            Assert.Equal(ExrReader.ReadChannel(exr, channel), pfm.Where((_, i) => i % 3 == component).Select(v => (double)v));
        }

        // What the numbers of a Cryptomatte mean stands in the .exr file alone.
        Assert.Contains(ExrReader.ReadText(exr), t => t.Key == "cryptomatte/3ae39a5/manifest");
        Assert.DoesNotContain(ImageFile.ReadAll(_folder["a.png"]).Texts, t => t.Key.Contains("cryptomatte", StringComparison.Ordinal));
        Assert.Contains(ExrReader.ReadChannel(exr, "CryptoMaterial00.G"), part => part > 0);
    }

    [Fact]
    public void Pngs_say_what_their_colours_mean()
    {
        CliRun.Of("render", _scene, "-o", _folder["a.png"], "--aov", "bvhCost,depth", "--exposure", "3");
        Dictionary<string, string> texts = ImageFile.ReadText(_folder["a.depth.png"]).ToDictionary();
        Assert.Equal("depth", texts["Aov"]);
        Assert.Matches(@"^[\d.]+ \(white\) to [\d.]+ \(black\) scene units", texts["Range"]);
        Assert.Contains("nodes and triangles per ray", ImageFile.ReadText(_folder["a.bvhCost.png"]).ToDictionary()["Range"], StringComparison.Ordinal);
        Assert.Equal(1, ImageFile.Read(_folder["a.depth.png"], raw: true).Pixels.Max());
    }

    [Fact]
    public void Colours_of_corners_tint_the_albedo()
    {
        File.WriteAllText(_folder["red.ply"], """
            ply
            format ascii 1.0
            element vertex 3
            property float x
            property float y
            property float z
            property uchar red
            property uchar green
            property uchar blue
            element face 1
            property list uchar int vertex_indices
            end_header
            -9 -9 0 255 0 0
            9 -9 0 255 0 0
            0 9 0 255 0 0
            3 0 1 2

            """);
        File.WriteAllText(_scene, """
            { "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0] }, "render": { "integrator": "report", "width": 8, "height": 8, "samplesPerPixel": 4 },
              "shapes": [{ "type": "mesh", "file": "red.ply", "material": { "type": "diffuse", "color": [0.5, 0.25, 1] } }], "background": "white" }
            """);
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.pfm"], "--aov", "albedo", "--quiet");
        Assert.Equal(new CliRun(0, "", ""), run);
        Assert.Equal([0.5f, 0, 0], ImageFile.Read(_folder["a.albedo.pfm"]).Pixels[(3 * 36)..(3 * 37)]);
    }

    [Fact]
    public void The_picture_and_the_film_are_the_same_with_and_without()
    {
        string without = Hash("-o", _folder["a.pfm"]);
        byte[] picture = File.ReadAllBytes(_folder["a.pfm"]);
        Assert.Equal(without, Hash("-o", _folder["a.pfm"], "--aov", All));
        Assert.Equal(picture, File.ReadAllBytes(_folder["a.pfm"]));
    }

    [Theory]
    [InlineData("-o OUT --aov dept", "--aov dept: unknown image \"dept\" (did you mean \"depth\"?), expected some of depth, normal, albedo, uv, motion, primitive, cryptoObject, cryptoMaterial, bvhCost, luminance, samples, error")]
    [InlineData("-o OUT --aov motion", "--aov motion: nothing moves while the shutter is open for no time: give \"shutter\" under \"render\"")]
    [InlineData("-o OUT --aov depth,bvhcost", "unknown image \"bvhcost\" (did you mean \"bvhCost\"?)")]
    [InlineData("-o OUT --aov depth,", "unknown image \"\", expected some of")]
    [InlineData("--pixel 0,0 --aov depth", "--pixel prints numbers and writes no image: leave --aov out")]
    [InlineData("--json --aov depth", "--aov writes images: where to? Give -o FILE")]
    [InlineData("-o OUT -o BESIDE --aov depth", "but another image goes there")]
    public void Wrong_requests_are_refused(string options, string message)
    {
        string line = options.Replace("OUT", _folder["a.png"], StringComparison.Ordinal).Replace("BESIDE", _folder["a.depth.png"], StringComparison.Ordinal);
        CliRun run = CliRun.Of(["render", _scene, .. line.Split(' ')]);
        Assert.Equal(2, run.Status);
        Assert.Contains(message, run.Error.Split(Environment.NewLine)[0], StringComparison.Ordinal);
        Assert.Equal([_scene], Directory.GetFiles(_folder.Path));
    }

    [Fact]
    public void Ways_to_make_paths_are_layers_of_exr_and_a_sheet_beside_other_formats()
    {
        string[] line = ["render", _scene, "-o", _folder["a.png"], "-o", _folder["a.exr"], "--aov", "strategies,depth", "--integrator", "vcm", "--quiet"];
        Assert.Equal(new CliRun(0, "", ""), CliRun.Of(line));
        Assert.Equal(["a.depth.png", "a.exr", "a.png", "a.strategies.png", "scene.json"], Directory.GetFiles(_folder.Path).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));
        byte[] exr = File.ReadAllBytes(_folder["a.exr"]);
        Assert.Contains(ExrReader.ReadChannel(exr, "s1t2.weighted.R"), v => v > 0);
        Assert.Contains(ExrReader.ReadChannel(exr, "merge.s2t2.unweighted.B"), v => v > 0);
        Assert.Equal(ExrReader.ReadChannel(exr, "R").Length, ExrReader.ReadChannel(exr, "longer.G").Length);
        Assert.True(ImageFile.Read(_folder["a.strategies.png"]).Width > 7 * ImageFile.Read(_folder["a.png"]).Width);
        Assert.Equal(0, CliRun.Of("verify", _folder["a.png"]).Status);
    }

    [Fact]
    public void A_sample_is_the_sum_of_what_the_ways_to_make_its_paths_bring()
    {
        string[] Line(int sample) => ["render", _scene, "--pixel", "16,12", "--spp", "8", "--sample", $"{sample}", "--integrator", "vcm", "--aov", "strategies"];
        double[] Numbers(JsonElement of, string key) => [.. of.GetProperty(key).EnumerateArray().Select(n => n.GetDouble())];
        int most = 0;
        for (int sample = 0; sample < 6; sample++)
        {
            JsonElement json = JsonDocument.Parse(CliRun.Of([.. Line(sample), "--json"]).Output).RootElement;
            JsonElement[] ways = [.. json.GetProperty("strategies").EnumerateArray()];
            most = Math.Max(most, ways.Length);
            Assert.All(Enumerable.Range(0, 3), i => Assert.Equal(Numbers(json, "radiance")[i], ways.Sum(w => Numbers(w, "weighted")[i]), 1e-6));
            Assert.All(ways.Where(w => w.GetProperty("name").GetString() != "longer"), w => Assert.All(Enumerable.Range(0, 3), i => Assert.InRange(Numbers(w, "weighted")[i], 0, Numbers(w, "unweighted")[i] * 1.001)));
        }

        // Not all of the samples have a light path.
        Assert.True(most > 2);
        Assert.Matches(@"  s1t2: radiance [\d.E-]+ [\d.E-]+ [\d.E-]+; alone [\d.E-]+ [\d.E-]+ [\d.E-]+, weight [01]", CliRun.Of(Line(0)).Output);
    }

    [Fact]
    public void Integrators_that_make_paths_from_the_camera_alone_have_no_pyramid()
    {
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.png"], "--aov", "strategies", "--integrator", "path");
        Assert.Equal(2, run.Status);
        Assert.Contains("--aov strategies: only the light, bidirectional, photons and vcm integrators make paths from the lights too", run.Error, StringComparison.Ordinal);
        Assert.Contains("choose one of them with --integrator", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_file_beside_that_cannot_be_written_is_reported_before_the_work()
    {
        Directory.CreateDirectory(_folder["a.depth.png"]);
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.png"], "--aov", "depth");
        Assert.Equal(4, run.Status);
        Assert.Contains("a.depth.png", run.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(_folder["a.png"]));
    }

    [Fact]
    public void Info_counts_triangles_instances_memory_and_trees()
    {
        const string square = """{ "type": "mesh", "positions": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], "triangles": [[0, 1, 2], [0, 2, 3]] }""";
        File.WriteAllText(_scene, $$"""
            { "objects": { "square": {{square}} },
              "shapes": [ {{square}}, { "type": "instance", "of": "square", "transform": [{ "translate": [3, 0, 0] }] }, { "type": "instance", "of": "square", "transform": [{ "translate": [0, 5, 0] }] } ] }
            """);
        JsonElement json = JsonDocument.Parse(CliRun.Of("info", _scene, "--json").Output).RootElement;
        Assert.Equal((2, 4, 6, 2), (Int(json, "meshes"), Int(json, "triangles"), Int(json, "trianglesShown"), Int(json, "instances")));
        JsonElement[] trees = [.. json.GetProperty("trees").EnumerateArray()];
        Assert.Equal(["triangles of the world", "triangles of object 1", "instances"], trees.Select(t => t.GetProperty("holds").GetString()));
        Assert.All(trees, t => Assert.Equal((2, 1, 1), (Int(t, "primitives"), Int(t, "nodes"), Int(t, "depth"))));
        Assert.All(trees, t => Assert.True(t.GetProperty("sahCost").GetDouble() >= 1 && t.GetProperty("buildSeconds").GetDouble() > 0));
        Assert.Equal(trees.Length * 128, Int(json, "nodeBytes"));
        Assert.InRange(Int(json, "instanceBytes"), 2 * 96, 2 * 128);

        // Corners and indices, and the copies in the leaves, in each of two meshes.
        Assert.InRange(Int(json, "triangleBytes"), 2 * ((4 * 12) + (6 * 4) + (2 * 36)), 2000);
        Assert.Equal([-1, -1, 0, 4, 6, 0], json.GetProperty("boundsMinimum").EnumerateArray().Concat(json.GetProperty("boundsMaximum").EnumerateArray()).Select(n => Math.Round(n.GetDouble(), 4)));
        string text = CliRun.Of("info", _scene).Output;
        Assert.Contains("triangles  4 in 2 meshes, 6 shown", text, StringComparison.Ordinal);
        Assert.Contains("instances  2", text, StringComparison.Ordinal);
        Assert.Matches(@"tree       2 triangles of object 1: 1 nodes, 1 leaves, depth 1, SAH cost \d+\.\d\d, built in \d+\.\d{3} s", text);
    }

    private static int Int(JsonElement json, string key) => json.GetProperty(key).GetInt32();

    private string Hash(params string[] options) =>
        JsonDocument.Parse(CliRun.Of(["render", _scene, "--json", .. options]).Output).RootElement.GetProperty("filmHash").GetString()!;
}
