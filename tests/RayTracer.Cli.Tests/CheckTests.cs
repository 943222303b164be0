using System.Text.Json;

namespace RayTracer.Cli.Tests;

/// <summary><c>raytracer check</c>.</summary>
public sealed class CheckTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _good;
    private readonly string _bad;

    public CheckTests()
    {
        _good = _folder["good.json"];
        File.WriteAllText(_good, CliRun.Scene);
        _bad = _folder["bad one.json"];
        string balls = string.Concat(Enumerable.Repeat("    { \"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": -1 },\n", 30));
        File.WriteAllText(_bad, $"{{\n  \"camera\": {{ \"fov\": 30 }},\n  \"background\": true,\n  \"shapes\": [\n{balls}    {{ \"radius\": 1 }}\n  ]\n}}\n");
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("a.dae", "Collada")]
    [InlineData("a.usdz", "USD")]
    [InlineData("a.BLEND", "Blender")]
    [InlineData("a.fbx", "FBX")]
    [InlineData("a.pov", "POV-Ray")]
    public void Files_of_other_programs_are_told_apart(string name, string program)
    {
        using TemporaryFolder folder = new();
        File.WriteAllText(folder[name], "LookAt 0 0 0");
        CliRun run = CliRun.Of("check", folder[name]);
        Assert.Equal(3, run.Status);
        Assert.StartsWith($"{folder[name]}: error: files of {program} are not read: scenes are .json, .xml, .pbrt, .pbrt.gz, and models ", run.Output, StringComparison.Ordinal);
        Assert.Contains(".gltf, .obj, .ply", run.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void A_corner_that_a_mesh_has_not_is_an_error_at_its_triangles()
    {
        using TemporaryFolder folder = new();
        string scene = folder["a.json"];
        File.WriteAllText(scene, """{ "shapes": [{ "type": "mesh", "positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2], [0, 1, 3]] }] }""");
        CliRun run = CliRun.Of("check", scene);
        Assert.Equal(3, run.Status);
        Assert.Contains(": error: a triangle has the corner 3, but there are 3, counted from 0", run.Output, StringComparison.Ordinal);
        File.WriteAllText(scene, File.ReadAllText(scene).Replace("1, 3]", "1, -1]", StringComparison.Ordinal));
        Assert.Equal(3, CliRun.Of("check", scene).Status);
    }

    [Fact]
    public void Text_has_what_is_wrong_with_every_file_on_standard_output()
    {
        CliRun run = CliRun.Of("check", _bad, _good, _bad);
        Assert.Equal((3, ""), (run.Status, run.Error));
        string[] lines = run.Output.ReplaceLineEndings("\n").Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(21 + 1 + 21, lines.Length);
        Assert.Equal($"{_bad}:2:15: error: unknown key \"fov\" in \"camera\" (did you mean \"fieldOfView\"?)", lines[0]);
        Assert.Equal("and 13 more", lines[20]);
        Assert.Equal($"{_good}: fine", lines[21]);
    }

    [Fact]
    public void Json_has_all_of_it()
    {
        CliRun run = CliRun.Of("check", "--format", "json", _good, _bad, _folder["none.json"]);
        Assert.Equal((4, ""), (run.Status, run.Error));
        JsonElement json = JsonDocument.Parse(run.Output).RootElement;
        Assert.Equal((34, 0), (json.GetProperty("errors").GetInt32(), json.GetProperty("warnings").GetInt32()));
        JsonElement[] files = [.. json.GetProperty("files").EnumerateArray()];
        Assert.Equal([_good, _bad, _folder["none.json"]], files.Select(f => f.GetProperty("path").GetString()));
        Assert.Equal([true, false, false], files.Select(f => f.GetProperty("fine").GetBoolean()));
        JsonElement[] diagnostics = [.. files[1].GetProperty("diagnostics").EnumerateArray()];
        Assert.Equal(["unknown-word", "wrong-kind", .. Enumerable.Repeat("out-of-range", 30), "missing-value"], diagnostics.Select(d => d.GetProperty("rule").GetString()));
        Assert.Equal((3, 17), (diagnostics[1].GetProperty("line").GetInt32(), diagnostics[1].GetProperty("column").GetInt32()));
        Assert.Equal("unreadable-file", files[2].GetProperty("diagnostics")[0].GetProperty("rule").GetString());
    }

    [Fact]
    public void Sarif_has_rules_places_and_levels()
    {
        File.WriteAllText(_folder["torn.json"], "{ \"camera\": ");
        CliRun run = CliRun.Of("check", "--format", "sarif", _good, _bad, _folder["torn.json"], "--set", "render.width=0");
        Assert.Equal((3, ""), (run.Status, run.Error));
        JsonElement log = JsonDocument.Parse(run.Output).RootElement;
        Assert.Equal("2.1.0", log.GetProperty("version").GetString());
        JsonElement one = log.GetProperty("runs")[0];
        JsonElement[] rules = [.. one.GetProperty("tool").GetProperty("driver").GetProperty("rules").EnumerateArray()];
        JsonElement[] artifacts = [.. one.GetProperty("artifacts").EnumerateArray()];
        Assert.Equal(new Uri(_bad).AbsoluteUri, Uri(artifacts[1]));
        JsonElement[] results = [.. one.GetProperty("results").EnumerateArray()];
        Assert.Equal(1 + 34 + 1, results.Length);
        Assert.All(results, result =>
        {
            Assert.Equal("error", result.GetProperty("level").GetString());
            Assert.Equal(result.GetProperty("ruleId").GetString(), rules[result.GetProperty("ruleIndex").GetInt32()].GetProperty("id").GetString());
            JsonElement place = result.GetProperty("locations")[0].GetProperty("physicalLocation").GetProperty("artifactLocation");
            Assert.Equal(Uri(artifacts[place.GetProperty("index").GetInt32()]), place.GetProperty("uri").GetString());
        });
        Assert.StartsWith("the option --set render.width=0, column 14: \"width\" must be", Message(results[0]), StringComparison.Ordinal);
        JsonElement region = results[2].GetProperty("locations")[0].GetProperty("physicalLocation").GetProperty("region");
        Assert.Equal((2, 15), (region.GetProperty("startLine").GetInt32(), region.GetProperty("startColumn").GetInt32()));
        Assert.Equal("syntax", results[^1].GetProperty("ruleId").GetString());

        static string? Uri(JsonElement artifact) => artifact.TryGetProperty("location", out JsonElement location) ? location.GetProperty("uri").GetString() : null;
        static string Message(JsonElement result) => result.GetProperty("message").GetProperty("text").GetString()!;
    }

    [Fact]
    public void Relative_paths_are_relative_addresses_in_sarif()
    {
        string relative = Path.GetRelativePath(Environment.CurrentDirectory, _bad);
        JsonElement log = JsonDocument.Parse(CliRun.Of("check", "--format", "sarif", relative).Output).RootElement;
        string uri = log.GetProperty("runs")[0].GetProperty("artifacts")[0].GetProperty("location").GetProperty("uri").GetString()!;
        Assert.EndsWith("/bad%20one.json", uri, StringComparison.Ordinal);
        Assert.False(Uri.TryCreate(uri, UriKind.Absolute, out _));
    }
}
