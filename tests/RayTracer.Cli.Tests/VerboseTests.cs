using System.Text.RegularExpressions;

namespace RayTracer.Cli.Tests;

/// <summary>The output of <c>--verbose</c>, and lengths of time.</summary>
public sealed class VerboseTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Every_verb_of_stages_tells_their_times_and_the_memory()
    {
        string scene = _folder["scene.json"];
        File.WriteAllText(scene, CliRun.Scene);
        (string film, string image) = (_folder["a.rtfilm"], _folder["a.png"]);
        StagesAre("load build render write memory", "render", scene, "-o", film, "-o", image);
        StagesAre("load build render write memory", "resume", film, "--spp", "5");
        StagesAre("headers load write memory", "merge", film, "-o", _folder["b.png"]);
        StagesAre("file load build render memory", "verify", image);
        StagesAre("load write memory", "convert", image, _folder["c.png"]);
        StagesAre("load build write memory", "convert", scene, _folder["c.json"]);
        StagesAre("load compare write memory", "compare", image, _folder["c.png"]);
        StagesAre("load build memory", "check", scene);
        StagesAre("load build memory", "info", scene);
        StagesAre("load memory", "info", film);
        StagesAre("load build render memory", "bench", scene, "--repeat", "1");
        StagesAre("check load build render load build render pictures write memory", "sweep", scene, "-o", _folder["s.png"], "--spp", "1", "--set", "camera.fieldOfView=20,35");
    }

    [Fact]
    public void Lengths_of_time_are_read_as_people_write_them()
    {
        string scene = _folder["scene.json"];
        File.WriteAllText(scene, CliRun.Scene);
        foreach (string time in new[] { "90", "90s", "10min", "1.5h", "1h30m", "1d2h3m4sec" })
        {
            Assert.Equal(0, CliRun.Of("render", scene, "--json", "--spp", "1", "--time", time, "--checkpoint-interval", "5s").Status);
        }
    }

    private static void StagesAre(string stages, params string[] words)
    {
        CliRun run = CliRun.Of([.. words, "--verbose"]);
        IEnumerable<string> written = Regex.Matches(run.Error, @"^([a-z]+) +[\d.]+ ([KMG]iB at most|s)\r?$", RegexOptions.Multiline, TimeSpan.FromSeconds(10)).Select(m => m.Groups[1].Value);
        Assert.Equal(stages, string.Join(' ', written));
    }
}
