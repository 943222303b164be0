using System.Text.Json;

namespace RayTracer.Cli.Tests;

/// <summary>Models that are rendered by themselves: what is made up, and what is said of it.</summary>
public sealed class ModelViewTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _model;

    public ModelViewTests()
    {
        _model = _folder["a.obj"];
        File.WriteAllText(_model, "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void One_line_says_what_was_made_up_and_quiet_silences_it()
    {
        string[] command = ["render", _model, "--width", "4", "--spp", "1", "-o", _folder["a.png"]];
        CliRun run = CliRun.Of(command);
        Assert.Equal(0, run.Status);
        Assert.StartsWith($"{_model}: note: the file has no camera and no light", Assert.Single(run.Error.TrimEnd().Split('\n')), StringComparison.Ordinal);
        Assert.Equal(new CliRun(0, "", ""), CliRun.Of([.. command, "--quiet"]));
    }

    [Fact]
    public void Another_axis_that_is_up_moves_the_whole_view()
    {
        JsonElement Scene(params string[] words)
        {
            Assert.Equal(0, CliRun.Of(["convert", _model, _folder["s.json"], .. words]).Status);
            return JsonDocument.Parse(File.ReadAllText(_folder["s.json"])).RootElement;
        }

        float[] Numbers(JsonElement owner, string key) => [.. owner.GetProperty(key).EnumerateArray().Select(n => n.GetSingle())];
        JsonElement standing = Scene();
        JsonElement lying = Scene("--set", "camera.up=[0,0,1]");
        Assert.Equal([0, 0, 1], Numbers(lying.GetProperty("camera"), "up"));
        Assert.True(Numbers(lying.GetProperty("camera"), "position") is [_, < 0, > 0.5f]);
        Assert.True(Numbers(standing.GetProperty("camera"), "position") is [_, > 0.5f, > 0]);
        Assert.Equal([0, 0, 1], Numbers(lying.GetProperty("shapes")[1], "normal"));
        Assert.Equal(
            CliRun.FilmHash("render", _model, "--set", "camera.up=[0,0,1]", "--width", "8", "--spp", "1", "--json", "--quiet"),
            CliRun.FilmHash("render", _model, "--up", "z", "--width", "8", "--spp", "1", "--json", "--quiet"));
    }

    [Fact]
    public void Solids_have_z_upwards()
    {
        string solid = _folder["a.stl"];
        File.WriteAllText(solid, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1\nendloop\nendfacet\nendsolid a\n");
        string[] size = ["--width", "8", "--spp", "1", "--json", "--quiet"];
        Assert.Equal(CliRun.FilmHash(["render", solid, "--up", "z", .. size]), CliRun.FilmHash(["render", solid, .. size]));
        Assert.NotEqual(CliRun.FilmHash(["render", solid, "--up", "y", .. size]), CliRun.FilmHash(["render", solid, .. size]));
    }

    [Fact]
    public void What_is_known_of_a_model_is_of_the_file_alone()
    {
        CliRun run = CliRun.Of("info", _model);
        Assert.Equal("", run.Error);
        Assert.Contains("bounds     (0, 0, 0) to (2, 1, 1)", run.Output, StringComparison.Ordinal);
        Assert.Contains("lights     0", run.Output, StringComparison.Ordinal);
        Assert.Contains("shapes     1 (1 model)", run.Output, StringComparison.Ordinal);
    }
}
