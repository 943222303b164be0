using System.Text.Json;
using System.Xml.Linq;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

public sealed class IntegratorBenchTests : IDisposable
{
    private const string Scene = """
        {
          "camera": { "position": [0, 1, 5], "lookAt": [0, 0.5, 0] },
          "render": { "width": 16, "height": 16, "samplesPerPixel": 256 },
          "shapes": [{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] }, { "type": "sphere", "center": [0, 0.5, 0], "radius": 0.5 }],
          "lights": [{ "type": "sphere", "center": [1, 3, 1], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 20 } }]
        }
        """;

    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;
    private readonly string _reference;

    public IntegratorBenchTests()
    {
        (_scene, _reference) = (_folder["scene.json"], _folder["reference.rtfilm"]);
        File.WriteAllText(_scene, Scene);
        CliRun.Fine("render", _scene, "--quiet", "-o", _reference);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Every_integrator_gets_a_curve_that_falls()
    {
        string chart = _folder["curves.svg"];
        JsonElement json = JsonDocument.Parse(CliRun.Fine(Bench("all", "--spp", "64", "--seconds", "100", "-o", chart, "--json")).Output).RootElement;
        JsonElement[] curves = [.. json.GetProperty("integrators").EnumerateArray()];
        string[] names = [.. curves.Select(c => c.GetProperty("integrator").GetString()!)];
        Assert.Equal(["path", "volPath", "light", "bidirectional", "photons", "vcm"], names);
        Assert.All(curves, c =>
        {
            JsonElement[] points = [.. c.GetProperty("points").EnumerateArray()];
            Assert.Equal((1, 64), (points[0].GetProperty("samplesPerPixel").GetInt32(), points[^1].GetProperty("samplesPerPixel").GetInt32()));
            Assert.InRange(points[^1].GetProperty("relativeMseTrimmed").GetDouble(), 1e-9, 0.5 * points[0].GetProperty("relativeMseTrimmed").GetDouble());
            Assert.Equal(points.OrderBy(p => p.GetProperty("seconds").GetDouble()), points);
        });
        Assert.Equal(1, curves[0].GetProperty("factorBelowPath").GetDouble(), 1e-9);
        XElement drawing = XDocument.Load(chart).Root!;
        Assert.Equal(names.Length, drawing.Descendants().Count(e => e.Name.LocalName == "polyline"));
        Assert.Equal(names, drawing.Descendants().Where(e => e.Name.LocalName == "text").Select(t => t.Value).Intersect(names));
        Assert.Equal(chart, json.GetProperty("outputs")[0].GetString());
    }

    [Fact]
    public void Time_ends_a_rendering_that_has_samples_left()
    {
        CliRun run = CliRun.Fine(Bench("volpath,path", "--seconds", "0.2"));
        string[][] rows = [.. run.Output.TrimEnd().Split('\n').Select(line => line.Split(' ', StringSplitOptions.RemoveEmptyEntries))];
        Assert.Equal(["integrator", "path", "volPath"], rows.Select(r => r[0]));
        Assert.All(rows[1..], row => Assert.InRange(double.Parse(row[2], null), 0.2, 60));
        Assert.Equal("1.00", rows[1][5]);
    }

    [Fact]
    public void Samples_of_the_reference_are_not_those_that_are_measured()
    {
        JsonElement curve = JsonDocument.Parse(CliRun.Fine(Bench("path", "--spp", "256", "--json")).Output).RootElement.GetProperty("integrators")[0];
        Assert.True(curve.GetProperty("points").EnumerateArray().Last().GetProperty("relativeMse").GetDouble() > 0);
    }

    [Fact]
    public void Integrators_that_cannot_render_the_scene_are_left_out_with_the_reason()
    {
        const string reason = "light from infinitely far away comes through a surface without end that has an inside";
        string lake = """ "normal": [0, 1, 0], "material": { "type": "dielectric", "priority": 1 } },""";
        string sun = """ "lights": [{ "type": "directional", "direction": [0, -1, 0.3] },""";
        File.WriteAllText(_scene, Scene.Replace(""" "normal": [0, 1, 0] },""", lake, StringComparison.Ordinal).Replace(""" "lights": [""", sun, StringComparison.Ordinal));
        CliRun run = CliRun.Fine(Bench("vcm,volPath,light", "--spp", "2", "--json"));
        JsonElement json = JsonDocument.Parse(run.Output).RootElement;
        Assert.Equal("volPath", Assert.Single(json.GetProperty("integrators").EnumerateArray()).GetProperty("integrator").GetString());
        JsonElement[] leftOut = [.. json.GetProperty("leftOut").EnumerateArray()];
        Assert.Equal(["vcm", "light"], leftOut.Select(l => l.GetProperty("integrator").GetString()));
        Assert.All(leftOut, l => Assert.StartsWith(reason, l.GetProperty("reason").GetString(), StringComparison.Ordinal));
        Assert.Contains($"vcm is left out: {reason}", run.Error, StringComparison.Ordinal);
        CliRun.Refused(3, $"light is left out: {reason}", Bench("light"));
    }

    [Fact]
    public void Wrong_usage_is_found_out_before_the_rendering()
    {
        ImageFile.Write(_folder["large.pfm"], new Picture(5, 4));
        ImageFile.Write(_folder["shown.png"], new Picture(16, 16));
        File.Copy(_reference, _folder["reference.svg"]);
        CliRun.Refused(2, "(did you mean \"path\"?)", Bench("paht"));
        CliRun.Refused(2, $"Give --reference FILE; this makes one: raytracer render {_scene} --spp 16384 -o reference.rtfilm", "bench", _scene, "--integrators", "all");
        CliRun.Refused(2, "has 5×4 pixels, but the scene 16×16", "bench", _scene, "--integrators", "all", "--reference", _folder["large.pfm"]);
        CliRun.Refused(2, "a PNG picture is for displays", "bench", _scene, "--integrators", "all", "--reference", _folder["shown.png"]);
        CliRun.Refused(4, "there is no such file", "bench", _scene, "--integrators", "all", "--reference", _folder["none.exr"]);
        CliRun.Refused(4, "this file is read, and would be lost", "bench", _scene, "--integrators", "all", "--reference", _folder["reference.svg"], "-o", _folder["reference.svg"]);
        CliRun.Refused(2, "whose name ends in .svg", Bench("all", "-o", _folder["curves.png"]));
        CliRun.Refused(2, "the jittered sampler needs the number of samples", Bench("all", "--set", "render.sampler=jittered"));
        CliRun.Refused(2, "is for one scene, but there are 2", Bench("all", _scene));
        CliRun.Refused(2, "--seconds needs --integrators", "bench", _scene, "--seconds", "3");
        CliRun.Refused(2, "--repeat does not go with --integrators", Bench("all", "--repeat", "2"));
    }

    private string[] Bench(string integrators, params string[] more) => ["bench", _scene, "--integrators", integrators, "--reference", _reference, .. more];
}
