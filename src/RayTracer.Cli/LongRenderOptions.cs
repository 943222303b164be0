using System.CommandLine;

namespace RayTracer.Cli;

/// <summary>The options of verbs that render for long.</summary>
internal sealed class LongRenderOptions
{
    private static readonly TimeSpan s_standardInterval = TimeSpan.FromSeconds(30);
    private readonly ParsedOption<TimeSpan?> _time = Durations.Option("--time", "Stops after this time, at the end of the current pass over the picture: 90s, 10m, 1.5h, 1h30m. At most --spp samples are taken (default 65,536).");
    private readonly Option<string?> _checkpoint = new("--checkpoint") { HelpName = "FILE" };
    private readonly ParsedOption<TimeSpan?> _interval = Durations.Option(
        "--checkpoint-interval", "The time between checkpoints. Default: 30s. Longer if writing would take more than 1 % of the time.", allowsZero: true);

    /// <summary>Gives a command the options.</summary>
    /// <param name="command">The command.</param>
    /// <param name="checkpoint">What the checkpoint's file is for.</param>
    public LongRenderOptions(Command command, string checkpoint)
    {
        _checkpoint.Description = checkpoint;
        command.Options.Add(_time.Symbol);
        command.Options.Add(_checkpoint);
        command.Options.Add(_interval.Symbol);
    }

    /// <summary>Whether there is a limit of time.</summary>
    public bool HasTime(ParseResult result) => _time.Value(result) is not null;

    /// <summary>Warns of an interval of checkpoints where there are none.</summary>
    public void WarnOfUnused(ParseResult result, RenderRequest request, Streams streams)
    {
        if (request.Checkpoint is null && _interval.Value(result) is not null)
        {
            streams.Warn("--checkpoint-interval has no effect: there are no checkpoints without --checkpoint FILE");
        }
    }

    /// <summary>A request with what was asked for.</summary>
    public RenderRequest Put(ParseResult result, RenderRequest request) => request with
    {
        Time = _time.Value(result),
        Checkpoint = result.GetValue(_checkpoint) ?? request.Checkpoint,
        CheckpointInterval = _interval.Value(result) ?? s_standardInterval,
    };
}
