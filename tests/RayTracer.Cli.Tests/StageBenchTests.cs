using System.Text.Json;
using RayTracer.Rendering;

namespace RayTracer.Cli.Tests;

/// <summary><c>bench --stages</c>, alone in its process, as it measures time.</summary>
public sealed class StageBenchTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void The_stages_add_up_to_the_time_of_the_render()
    {
        string scene = _folder["scene.json"];
        File.WriteAllText(scene, CliRun.Scene);
        string[] words = ["bench", scene, "--stages", "--set", "render.width=96", "--set", "render.height=96", "--spp", "64"];
        JsonElement one = JsonDocument.Parse(CliRun.Fine([.. words, "--json"]).Output).RootElement.GetProperty("scenes")[0];
        Dictionary<string, double> stages = one.GetProperty("stages").EnumerateObject().ToDictionary(s => s.Name, s => s.Value.GetDouble());
        Assert.Equal(Enum.GetNames<Stage>().Select(s => s.ToLowerInvariant()).Order(), stages.Keys.Order());
        Assert.All(stages.Values, s => Assert.True(s >= 0));
        Assert.All(["intersect", "film"], s => Assert.True(stages[s] > 0, s));
        double seconds = one.GetProperty("seconds").GetDouble();
        Assert.Equal(seconds, stages.Values.Sum(), 1e-9);
        Assert.True(one.GetProperty("clockedSeconds").GetDouble() > 0);

        // As text: what takes longest comes first.
        double[] shares = [.. CliRun.Fine(words).Output.Split('\n').Where(line => line.EndsWith(" %", StringComparison.Ordinal))
            .Select(line => double.Parse(line.Split(' ', StringSplitOptions.RemoveEmptyEntries)[^2], System.Globalization.CultureInfo.InvariantCulture))];
        Assert.Equal(stages.Count, shares.Length);
        Assert.Equal(shares.OrderDescending(), shares);
        Assert.Equal(100, shares.Sum(), 0.6);
    }

    [Theory]
    [InlineData("--against", "folder")]
    [InlineData("--integrators", "path")]
    [InlineData("--repeat", "2")]
    public void They_are_measured_alone(params string[] words) =>
        CliRun.Refused(ExitStatus.Usage, "--stages does not go with", ["bench", "--stages", .. words]);

    [Fact]
    public void A_clock_leaves_out_what_its_readings_take()
    {
        StageClock clock = new();
        clock.Start();
        for (int i = 0; i < 1000; i++)
        {
            clock.Enter(i % 10 == 0 ? Stage.Light : Stage.Shadow);
        }

        Thread.Sleep(50);
        clock.Enter(Stage.Rest);
        IReadOnlyDictionary<Stage, double> seconds = clock.Seconds(0.05);
        Assert.Equal(0.05, seconds.Values.Sum(), 1e-9);
        Assert.True(seconds[Stage.Shadow] > 0.9 * 0.05, $"{seconds[Stage.Shadow]} s");
    }
}
