using System.Security.Cryptography;
using System.Text.Json;
using RayTracer.Benchmarks.Standing;

namespace RayTracer.Cli.Tests;

/// <summary>The scenes on which builds are compared before a release.</summary>
public sealed class StandingScenesTests : IDisposable
{
    private static readonly JsonDocumentOptions s_asScenes = new() { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip };
    private readonly TemporaryFolder _folder = new();
    private readonly string[] _scenes;

    public StandingScenesTests()
    {
        StandingScenes.Write(_folder.Path);
        _scenes = Directory.GetFiles(_folder.Path, "*.json");
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void All_load_and_leave_no_default_to_the_build()
    {
        Assert.Equal(11, _scenes.Length);
        CliRun.Fine(["check", "--strict", .. _scenes]);
        foreach (string path in _scenes)
        {
            using JsonDocument scene = JsonDocument.Parse(File.ReadAllText(path), s_asScenes);
            JsonElement render = scene.RootElement.GetProperty("render");
            string[] depths = render.GetProperty("integrator").GetString() == "report" ? ["maxDiffuseDepth", "maxSpecularDepth"] : ["maxDepth"];
            Assert.All(["sampler", "width", "height", "samplesPerPixel", .. depths], key => Assert.True(render.TryGetProperty(key, out _), $"{path}: no {key}"));
        }
    }

    [Fact]
    public void What_is_computed_has_the_same_bytes_on_every_machine() => Assert.Equal(
        [
            "boulder.ply df3d17e35464601df68b19e1c63bd61655dd2e363d2a757e28fa9854aa009bf0",
            "million.ply 16e38b73273beaf36d63240c2e8c383f2c8d9731f21757d374c717291db16da9",
            "ten-thousand-lamps.json 55b48eeff9cedb48f68ad4fdcf996b5f7fcb3802462483b703a52e05521ac682",
            "thousand-instances.json 7b33ac304bad01c8aa99bc3702326f12f2f04156df2abc3010a625bb9b16652e",
        ],
        new[] { "boulder.ply", "million.ply", "ten-thousand-lamps.json", "thousand-instances.json" }
            .Select(name => $"{name} {Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(_folder[name])))}"));

    [LinuxFact]
    public void Builds_are_compared_on_them()
    {
        CliRun run = CliRun.Of(
            "bench", _folder["four-lamps.json"], "--against", AppContext.BaseDirectory, "--rounds", "2", "--set", "render.width=16", "--set", "render.height=16");

        // Two rounds say nothing about the time.
        Assert.True(run.Status is ExitStatus.Fine or ExitStatus.Different, run.Error);
        Assert.Contains("(same bits)", run.Output, StringComparison.Ordinal);
    }
}
