using System.Text.Json;
using RayTracer.Cli;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli.Tests;

/// <summary><c>--verbose</c> and <c>--preview</c>.</summary>
public sealed class DisplayTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;

    public DisplayTests()
    {
        _scene = _folder["scene.json"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Verbose_tells_each_stage_and_the_memory_on_standard_error()
    {
        CliRun quiet = CliRun.Of("render", _scene, "-o", _folder["a.png"]);
        CliRun run = CliRun.Of("render", _scene, "-o", _folder["a.png"], "--verbose");
        Assert.Equal((0, 0), (quiet.Status, run.Status));
        Assert.DoesNotContain("load", quiet.Error, StringComparison.Ordinal);
        string[] stages = [.. run.Error.ReplaceLineEndings("\n").Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(l => l.Split(' ')[0])];
        Assert.Equal(["load", "build", "render", "write", "memory"], stages);
        Assert.DoesNotContain("memory", run.Output, StringComparison.Ordinal);
        CliRun both = CliRun.Of("render", _scene, "--json", "--verbose", "--quiet");
        Assert.Equal(2, both.Status);
        Assert.Contains("--quiet and --verbose cannot go together", both.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Json_has_the_stages_and_the_memory()
    {
        JsonElement json = JsonDocument.Parse(CliRun.Of("render", _scene, "--json", "-o", _folder["a.png"]).Output).RootElement;
        double[] seconds = [.. new[] { "load", "build", "render", "write", "total" }.Select(s => json.GetProperty($"{s}Seconds").GetDouble())];
        Assert.All(seconds, s => Assert.True(s > 0));
        Assert.True(seconds[..4].Sum() <= seconds[4]);
        Assert.True(json.GetProperty("peakMemoryBytes").GetInt64() > 1 << 20);
    }

    [Theory]
    [InlineData(10, 0, null, @"^0 %$")]
    [InlineData(50, 100, null, @"^50 %, 1 s left$")]
    [InlineData(1, 1000, 11.0, @"^\d+ %, (8|9|10) s left$")]
    [InlineData(999, 1000, 3600.0, @"^100 %, 0 s left$")]
    [InlineData(0, 1000, 11.0, @"^\d+ %, (8|9|10) s left$")]
    public void The_time_left_goes_by_what_ends_first(long done, long total, double? limit, string expected)
    {
        using SharedWriter lines = new();
        using (ProgressDisplay display = ProgressDisplay.Start(new ProgressLines(lines) { Limit = limit is { } seconds ? TimeSpan.FromSeconds(seconds) : null }))
        {
            display.Report(new(done, total, 0));
            Assert.True(SpinWait.SpinUntil(() => lines.ToString().Contains('\n', StringComparison.Ordinal), 60_000));
        }

        Assert.Matches(expected, lines.ToString().ReplaceLineEndings("\n").Split('\n')[0]);
    }

    [Fact]
    public void How_many_samples_a_noise_takes_is_not_known_before_some_are_there()
    {
        Reports reports = new();
        SamplePlan plan = new SamplePlanner(new RenderJob { Scene = _scene }.Load().Scene!, new(), new() { Error = 0.01, MeanSamples = 65536, MostSamples = 65536 }).Plan(reports);
        Assert.Equal(0, reports.All[0].PathsTotal);
        Assert.InRange(reports.All[^1].PathsTotal, plan.MeanSamples * 24 * 16 / 10, plan.MeanSamples * 24 * 16 * 10);
    }

    private sealed class Reports : IProgress<RenderProgress>
    {
        public List<RenderProgress> All { get; } = [];

        public void Report(RenderProgress value)
        {
            lock (All)
            {
                All.Add(value);
            }
        }
    }

    [Fact]
    public void A_preview_changes_no_bit()
    {
        CliRun plain = CliRun.Of("render", _scene, "--json", "--quiet");
        CliRun run = CliRun.OnTerminal("render", _scene, "--json", "--preview");
        Assert.Equal(Hash(plain), Hash(run));
        Assert.StartsWith("\e[?25l", run.Error, StringComparison.Ordinal);
        Assert.EndsWith("\e[K\e[?25h", run.Error, StringComparison.Ordinal);
        Assert.Equal(0, CliRun.OnTerminal("render", _scene, "-o", _folder["a.png"], "--preview").Status);
        Assert.Equal(0, CliRun.Of("verify", _folder["a.png"]).Status);

        static string Hash(CliRun run) => JsonDocument.Parse(run.Output).RootElement.GetProperty("filmHash").GetString()!;
    }

    [Fact]
    public void Without_a_terminal_nothing_is_shown()
    {
        CliRun run = CliRun.Of("render", _scene, "--json", "--preview", "--quiet");
        Assert.Equal((0, "raytracer: warning: --preview: standard error is not a terminal that can show pictures, so nothing is shown"), (run.Status, run.Error.TrimEnd()));
    }

    [Theory]
    [InlineData(false, "xterm", true)]
    [InlineData(false, null, true)]
    [InlineData(false, "dumb", false)]
    [InlineData(true, "xterm", false)]
    public void A_dumb_terminal_counts_as_none(bool isRedirected, string? term, bool expected) => Assert.Equal(expected, Streams.IsTerminal(isRedirected, term));

    [Fact]
    public void A_frame_that_was_stopped_is_named()
    {
        using StringWriter error = new();
        Streams streams = new(TextWriter.Null, error);
        RenderJob job = new() { Scene = _scene, Frames = new(7, 7, 1), IsOfSequence = true };
        JobResult result = new(job.Load().Scene!, new(1, 1), new() { Cancelled = true }, 1, 0);
        new RenderReport(job, result, new(Quiet: true), new(null), 0).Write(streams);
        Assert.Equal("raytracer: warning: frame 7 was stopped after 0 paths; no image was written", error.ToString().TrimEnd());
    }

    [Theory]
    [InlineData(TerminalGraphics.Blocks, "\e[4A", "▀")]
    [InlineData(TerminalGraphics.Letters, "\e[4A", " ")]
    [InlineData(TerminalGraphics.Kitty, "\e_Ga=d,q=2\e\\\e[H\e_G", "f=100")]
    [InlineData(TerminalGraphics.Sixel, "\e[2J", "\e[H\eP0;1q")]
    public void Pictures_are_drawn_in_the_same_place_again(TerminalGraphics graphics, string place, string picture)
    {
        using SharedWriter terminal = new();
        PreviewDisplay preview = new(terminal, graphics, new(20, 6), new());
        Film film = new(32, 16);
        preview.Offer(film, isLast: false);
        using (ProgressDisplay.Start(preview))
        {
            Assert.True(SpinWait.SpinUntil(() => terminal.ToString().Contains(picture, StringComparison.Ordinal), 60_000));
            preview.Offer(film, isLast: true);
        }

        string text = terminal.ToString();
        Assert.Contains(place, text, StringComparison.Ordinal);
        Assert.EndsWith("\e[?25h", text, StringComparison.Ordinal);
        Assert.All(text.Split('\n'), line => Assert.True(graphics > TerminalGraphics.Letters || line.Count(c => c is '▀' or ' ') <= 40));
    }

    // Written to by one thread and looked at by another.
    private sealed class SharedWriter : StringWriter
    {
        private readonly Lock _lock = new();

        public override void Write(string? value)
        {
            lock (_lock)
            {
                base.Write(value);
            }
        }

        public override string ToString()
        {
            lock (_lock)
            {
                return base.ToString();
            }
        }
    }
}
