using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>Carries out jobs for a command: with progress on the console, signals that end them, and a report.</summary>
/// <param name="display">The user's choice of what is reported.</param>
/// <param name="streams">The streams to write to.</param>
internal sealed class ConsoleRun(Display display, Streams streams) : IJobWatch
{
    private readonly Stopwatch _total = Stopwatch.StartNew();
    private readonly StageTimes _stages = new(display.Verbose ? streams : null);
    private ProgressDisplay? _progress;
    private RenderJob? _job;
    private Action? _warn;

    /// <summary>Warns of what is doubtful about the command; called once, when the program will not start again with wider registers.</summary>
    public Action? Warn { get; init; }

    /// <inheritdoc/>
    public bool ShowsPasses => display.Preview && streams.HasTerminal;

    /// <summary>Carries out a job of one picture or of several frames.</summary>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    public int Run(RenderJob job)
    {
        if (FrameFiles.AreSeveral(job))
        {
            WideVectors.EnableFor(long.MaxValue);
            WarnOfCommand();
            return new ConsoleFrames(job, display, streams).Run();
        }

        _warn = WarnOfCommand;
        using StopSignals signals = new(streams);
        return Run(job, new(job.WithCheckpoint(), this), () => signals.Status, signals.Token).Status;
    }

    /// <summary>Carries out a job of one picture.</summary>
    /// <param name="job">The job.</param>
    /// <param name="run">Carries it out.</param>
    /// <param name="ended">The exit status that belongs to an early end; 0 where there was none.</param>
    /// <param name="cancellation">Ends the rendering early; what is done so far is written.</param>
    public (int Status, JobResult? Result) Run(RenderJob job, JobRun run, Func<int> ended, CancellationToken cancellation)
    {
        _job = job;
        if (run.Run(cancellation) is not { } result)
        {
            return (SceneFile.FailureStatus(job.Scene), null);
        }

        if (job.Pixel is not null)
        {
            PixelReport.Write(job, result, display.Json, streams);
            return (ended(), result);
        }

        if (result.Film.TotalSamples == 0 && job.Outputs.Count > 0 && ended() == 0)
        {
            streams.Fail("no sample was finite, so there is no picture to write");
        }

        try
        {
            new RenderReport(job, result, display, _stages, _total.Elapsed.TotalSeconds).Write(streams);
        }
        catch (IOException) when (ended() == ExitStatus.HungUp)
        {
            // Nobody reads it any more: the terminal is gone.
        }

        return (ended() is not 0 and var status ? status : !result.IsWritten ? ExitStatus.InputOutput : result.IsNoisy(job) ? ExitStatus.Noisy : ExitStatus.Fine, result);
    }

    void IJobWatch.Warn(string message) => streams.Warn(message);

    /// <inheritdoc/>
    public void Fail(string message) => streams.Fail(message);

    /// <inheritdoc/>
    public void Read(IReadOnlyList<Diagnostic> diagnostics) => streams.Read(diagnostics, display.Quiet);

    /// <inheritdoc/>
    public void Begin(SceneDescription scene)
    {
        WideVectors.EnableFor((long)scene.Render.Width * scene.Render.Height * scene.Render.SamplesPerPixel);
        _warn?.Invoke();
        _warn = null;
    }

    /// <inheritdoc/>
    public void End(JobStage stage) => _stages.End(stage);

    /// <inheritdoc/>
    public IProgress<RenderProgress>? Begin(RenderDescription render) => _progress =
        ShowsPasses ? ProgressDisplay.Start(
            new PreviewDisplay(streams.Error, TerminalPicture.Of(Environment.GetEnvironmentVariable), TerminalSize.Current, _job!.Writing.For(render)) { Limit = Limit })
        : display.Quiet || _job?.Pixel is not null ? null
        : ProgressDisplay.Start(streams, Limit);

    private void WarnOfCommand()
    {
        if (display.Preview && !streams.HasTerminal)
        {
            streams.Warn("--preview: standard error is not a terminal that can show pictures, so nothing is shown");
        }

        Warn?.Invoke();
    }

    // It is the rendering's, which is the first that is shown.
    private TimeSpan? Limit => _progress is null ? _job?.Time : null;

    /// <inheritdoc/>
    public void Offer(Film film, bool isLast) => (_progress as PreviewDisplay)?.Offer(film, isLast);
}
