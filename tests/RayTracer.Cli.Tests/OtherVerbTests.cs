using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

public sealed class OtherVerbTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public OtherVerbTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Check_says_what_is_fine_and_what_is_not()
    {
        Assert.Equal(new CliRun(0, $"{_scene}: fine{Environment.NewLine}", ""), CliRun.Of("check", _scene));
        File.WriteAllText(_folder["bad.json"], "{ \"shape\": [] }");
        CliRun run = CliRun.Of("check", _folder["bad.json"], _scene);
        Assert.Equal(3, run.Status);
        Assert.Contains("(did you mean \"shapes\"?)", run.Output, StringComparison.Ordinal);
        Assert.Contains("scene.json: fine", run.Output, StringComparison.Ordinal);
        Assert.Equal(4, CliRun.Of("check", _folder["missing.json"]).Status);
    }

    [Fact]
    public void Info_counts()
    {
        ImageFile.Write(_folder["p.png"], new Picture(5, 4));
        string textured = CliRun.Scene.Replace("{ \"type\": \"checker\" }", "{ \"type\": \"image\", \"file\": \"p.png\" }", StringComparison.Ordinal);
        File.WriteAllText(_scene, textured);
        JsonElement json = JsonDocument.Parse(CliRun.Of("info", _scene, "--json").Output).RootElement;
        Assert.Equal(2, json.GetProperty("shapes").GetProperty("sphere").GetInt32());
        Assert.Equal(1, json.GetProperty("shapes").GetProperty("plane").GetInt32());
        Assert.Equal(1, json.GetProperty("textures").GetProperty("image").GetInt32());
        Assert.Equal(1, json.GetProperty("lights").GetInt32());
        Assert.Equal(5 * 4 * 12, json.GetProperty("textureBytes").GetInt32());
        Assert.Equal(24 * 16 * 68, json.GetProperty("filmBytes").GetInt32());
        Assert.Equal(-0.5f, json.GetProperty("boundsMinimum")[0].GetSingle());
        Assert.Equal("report", json.GetProperty("recommendedIntegrator").GetString());
        string reason = json.GetProperty("recommendedBecause").GetString()!;
        string text = CliRun.Of("info", _scene).Output;
        Assert.Contains("24×16 pixels, 4 samples each (sobol)", text, StringComparison.Ordinal);
        Assert.Contains($"integrator report; it fits: {reason}", text, StringComparison.Ordinal);
        Assert.Contains("integrator direct; path fits better: ", CliRun.Of("info", _scene, "--set", "render.integrator=direct").Output, StringComparison.Ordinal);
    }

    [Fact]
    public void Compare_measures_and_judges_by_the_tolerance()
    {
        Gray("a.pfm", 0.5f);
        Gray("b.pfm", 0.75f);
        string[] files = [_folder["a.pfm"], _folder["b.pfm"]];
        JsonElement json = JsonDocument.Parse(CliRun.Of(["compare", .. files, "--json"]).Output).RootElement;
        Assert.Equal(0.25, json.GetProperty("rmse").GetDouble());
        Assert.Equal(0, CliRun.Of(["compare", .. files]).Status);
        Assert.Equal(0, CliRun.Of(["compare", .. files, "--tolerance", "0.25"]).Status);
        CliRun run = CliRun.Of(["compare", .. files, "--tolerance", "0.2", "-o", _folder["d.pfm"]]);
        Assert.Equal(1, run.Status);
        Assert.Contains("RMSE                0.25", run.Output, StringComparison.Ordinal);
        Assert.Equal(0.25f, ImageFile.Read(_folder["d.pfm"]).Pixels[0]);
        Assert.Equal(0, CliRun.Of("compare", files[0], files[0], "--tolerance", "0").Status);
    }

    [Fact]
    public void Compare_draws_what_differs_to_the_eye()
    {
        Gray("a.pfm", 0.5f);
        Gray("b.pfm", 0.6f);
        string[] files = [_folder["a.pfm"], _folder["b.pfm"]];
        double flip = JsonDocument.Parse(CliRun.Of(["compare", .. files, "--json", "--map", _folder["map.png"], "--side-by-side", _folder["sheet.png"]]).Output).RootElement.GetProperty("flip").GetDouble();
        Assert.Equal(FlipError.Compare(ImageFile.Read(files[0]), ImageFile.Read(files[1])).Mean, flip);
        Assert.Contains($"FLIP                {flip:F6}", CliRun.Of(["compare", .. files]).Output, StringComparison.Ordinal);
        Assert.True(ImageFile.Read(_folder["sheet.png"]).Width > 3 * 16 && ImageFile.Read(_folder["map.png"]).Width > 16);
        Assert.Equal(2, CliRun.Of(["compare", .. files, "--pixels-per-degree", "0"]).Status);
    }

    [Fact]
    public void View_shows_an_image_as_the_terminal_can()
    {
        Gray("a.pfm", 0.5f);
        string letters = CliRun.Of("view", _folder["a.pfm"], "--as", "letters", "--columns", "4").Output;
        Assert.Equal("####\n####\n", letters.Replace('*', '#'));
        string blocks = CliRun.Of("view", _folder["a.pfm"], "--as", "blocks", "--columns", "2").Output;
        Assert.Equal("\e[38;2;188;188;188;48;2;188;188;188m▀\e[38;2;188;188;188;48;2;188;188;188m▀\e[0m\n", blocks);
        Assert.Equal(2, CliRun.Of("view", _folder["a.pfm"], "--as", "paper").Status);
        Assert.Equal(4, CliRun.Of("view", _folder["none.pfm"]).Status);
    }

    [Fact]
    public void Compare_fails_on_other_sizes_damaged_and_missing_files()
    {
        Gray("a.pfm", 0.5f);
        ImageFile.Write(_folder["large.png"], new Picture(5, 4));
        CliRun sizes = CliRun.Of("compare", _folder["a.pfm"], _folder["large.png"]);
        Assert.Equal((1, true), (sizes.Status, sizes.Error.Contains("the images differ in size: 16×16 and 5×4 pixels", StringComparison.Ordinal)));
        Assert.Equal(4, CliRun.Of("compare", _folder["a.pfm"], _folder["none.png"]).Status);
        CliRun damaged = CliRun.Of("compare", _folder["a.pfm"], _scene);
        Assert.Equal(4, damaged.Status);
        Assert.Single(damaged.Error.TrimEnd().Split('\n'));
        Assert.Equal(2, CliRun.Of("compare", _folder["a.pfm"]).Status);
    }

    [Fact]
    public void Bench_measures_one_thread_and_all()
    {
        CliRun run = CliRun.Of("bench", _scene, "--repeat", "1", "--spp", "1", "--json");
        JsonElement runs = JsonDocument.Parse(run.Output).RootElement.GetProperty("runs");
        Assert.Equal(2, runs.GetArrayLength());
        Assert.Equal((1, Environment.ProcessorCount), (runs[0].GetProperty("threads").GetInt32(), runs[1].GetProperty("threads").GetInt32()));
        Assert.True(runs[0].GetProperty("raysPerSecond").GetDouble() > 0);
        Assert.Contains(_scene, CliRun.Of("bench", _scene, "--repeat", "1", "--spp", "1").Output, StringComparison.Ordinal);
    }

    private void Gray(string name, float value) =>
        ImageFile.Write(_folder[name], new Picture(16, 16, [.. Enumerable.Repeat(value, 3 * 16 * 16)]));
}
