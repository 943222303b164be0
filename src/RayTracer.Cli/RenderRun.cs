using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>Renders one scene as it was asked for.</summary>
/// <param name="request">What was asked for.</param>
/// <param name="overrides">Puts the options of the command line into the scene.</param>
/// <param name="streams">Where to write.</param>
internal sealed class RenderRun(RenderRequest request, Func<SceneDescription, SceneDescription> overrides, Streams streams)
{
    private readonly Stopwatch _total = Stopwatch.StartNew();
    private readonly NoiseRequest _noise = new(request);
    private readonly StageTimes _stages = new(request.Verbose ? streams : null);

    // From the beginning on, so that it knows what is there before the work.
    private readonly Checkpoints? _checkpoints = request.Checkpoint is { } path ? new(path, request.CheckpointInterval, streams) : null;
    private SceneDescription? _description;
    private string? _content;
    private long _begun;
    private AovFilm? _auxiliary;
    private LightLayerFilm? _light;
    private Denoising? _denoising;

    /// <summary>Reads pictures; null for <see cref="ImageFile.Read"/>.</summary>
    public Func<string, bool, Picture>? ReadPicture { get; init; }

    /// <summary>Takes what it came to and the files that were written, at the end; may be null.</summary>
    public Action<RenderOutcome, IReadOnlyList<string>>? Done { get; init; }

    /// <summary>Loads, renders, writes and reports.</summary>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    public int Run()
    {
        using StopSignals signals = new(streams);
        return Run(() => signals.Status, signals.Token);
    }

    /// <summary>As <see cref="Run()"/>.</summary>
    /// <param name="ended">The exit status that belongs to an early end; 0 where there was none.</param>
    /// <param name="cancellation">Ends the rendering early; what is done so far is written.</param>
    public int Run(Func<int> ended, CancellationToken cancellation)
    {
        AovOutputs aovs = new(request);
        foreach (string output in request.Outputs.Concat(aovs.Files).Concat(request.Checkpoint is { } file ? [file] : []))
        {
            ImageOutputs.CheckFilm(output);
        }

        if (!request.IsOfSequence)
        {
            ImageOutputs.CheckUnfinished(request.Outputs.Concat(request.Checkpoint is { } film ? [film] : []), (request.Resumed ?? request.Decision)?.Path);
        }

        if (Compute(cancellation, aovs) is not { } outcome)
        {
            return SceneFile.FailureStatus(request.ScenePath);
        }

        if (request.Pixel is not null)
        {
            PixelReport.Write(request, outcome, streams);
            return ended();
        }

        bool isWanted = outcome.Film.TotalSamples > 0 && !(request.IsOfSequence && outcome.Statistics.Cancelled);
        IReadOnlyList<string> written = isWanted ? Write(outcome, aovs) : [];
        _stages.EndWrite();
        if (outcome.Film.TotalSamples == 0 && request.Outputs.Count > 0 && ended() == 0)
        {
            streams.Fail("no sample was finite, so there is no picture to write");
        }

        RenderReport report = new(request, outcome, written, _stages, _total.Elapsed.TotalSeconds);
        try
        {
            report.Write(streams);
        }
        catch (IOException) when (ended() == ExitStatus.HungUp)
        {
            // Nobody reads it any more: the terminal is gone.
        }

        Done?.Invoke(outcome, written);
        return ended() is not 0 and var status ? status
            : written.Count < request.Outputs.Count + aovs.Files.Count || outcome.Checkpoints is { HasFailed: true } ? ExitStatus.InputOutput
            : outcome.IsNoisy(request) ? ExitStatus.Noisy : ExitStatus.Fine;
    }

    /// <summary>Loads and renders.</summary>
    /// <param name="cancellation">Ends it early.</param>
    /// <param name="aovs">Takes the names of layers of light; null where none are written.</param>
    /// <returns>What it came to; null where the scene is wrong, which was said.</returns>
    public RenderOutcome? Compute(CancellationToken cancellation, AovOutputs? aovs = null)
    {
        Scene? scene = SceneFile.Load(request.ScenePath, streams, Described, request.Settings, request.Frame, ReadPicture, s => _description = s);
        if (scene is null)
        {
            return null;
        }

        _stages.EndBuild();
        ImageOutputs.CheckSize(request.Outputs, request.Writing, scene.Render.Width, scene.Render.Height);
        RenderOptions options = Options(scene.Render);
        Film film = request.Resumed?.Film ?? FilmFor(scene);
        if ((film.Width, film.Height) != (scene.Render.Width, scene.Render.Height))
        {
            throw ResumeVerb.OtherScene(request.ScenePath);
        }

        if (request.Layers.Count > 0)
        {
            options = options with { Layers = _light = LayersFor(scene, film) };
            aovs?.Add(_light.Names);
        }

        _auxiliary = new(film, request.Aovs);
        _denoising = request.Denoise ? Denoising.Create(scene) : null;
        using ProgressDisplay? display = Display();
        long start = Stopwatch.GetTimestamp();
        RenderOutcome outcome = Render(scene, film, options, display, cancellation);
        outcome = outcome with { Seconds = Stopwatch.GetElapsedTime(start).TotalSeconds };
        display?.Dispose();
        _stages.EndRender();
        return outcome;
    }

    // Called when the scene file has been read, before the scene is built.
    private SceneDescription Described(SceneDescription scene)
    {
        _stages.EndLoad();
        return _noise.Widen(overrides(scene));
    }

    private ProgressDisplay? Display() =>
        request.Preview ? ProgressDisplay.Start(new PreviewDisplay(streams.Error, TerminalPicture.Of(Environment.GetEnvironmentVariable), TerminalSize.Current, request.Writing))
        : request.Quiet || request.Pixel is not null ? null
        : ProgressDisplay.Start(streams);

    private RenderOutcome Render(Scene scene, Film film, RenderOptions options, ProgressDisplay? display, CancellationToken cancellation)
    {
        RenderOutcome outcome = new(scene, film, new() { Cancelled = true }, options.Threads, 0);
        try
        {
            _begun = Stopwatch.GetTimestamp();
            if (Decided is { } decided)
            {
                options = options with { Samples = decided };
            }
            else if (Plan(scene, options, display, cancellation) is { } plan)
            {
                outcome = outcome with { Plan = plan };
                options = options with { Samples = new(0, (int)double.Round((double)plan.TotalSamples / plan.Area.Pixels)) };
            }

            if (request.NeedsPasses)
            {
                return RenderPasses(outcome, options, display, cancellation);
            }

            // First, so that they are whole even where the picture is stopped early.
            new FirstHitPass(scene, options).Render(_auxiliary!, cancellation);
            return outcome with
            {
                Samples = request.Adaptive || request.Pixel is not null ? null : options.Samples,
                Statistics = _denoising?.Render(film, options, display, cancellation)
                    ?? (request.Adaptive ? new PlannedRender(scene, options, outcome.Plan!).Render(film, display, cancellation) : Counted(outcome.Plan, new RTracer(scene, options).Render(film, display, cancellation))),
            };
        }
        catch (OperationCanceledException)
        {
            // There is no picture yet.
            return outcome;
        }
    }

    // What an earlier run decided that went by the same words.
    private SampleRange? Decided => request is { Noise: not null, Resumed.Header: var header } && header.Overrides.SequenceEqual(request.FilmWords) ? header.Wanted : null;

    private SamplePlan? Plan(Scene scene, RenderOptions options, ProgressDisplay? display, CancellationToken cancellation)
    {
        if (request.Noise is null || request.Resumed is not null || _checkpoints is null)
        {
            return _noise.Plan(scene, options, null, null, display, cancellation);
        }

        DecisionCheckpoint checkpoint = new(_checkpoints, Header(scene.Render, options.Samples!.Value, options.Crop), _noise.Goal);
        DecidingState? begun = request.Decision is { } decision ? checkpoint.Begun(decision, request.ScenePath) : null;
        try
        {
            return _noise.Plan(scene, options, begun, checkpoint.Keep, display, cancellation);
        }
        catch (OperationCanceledException)
        {
            checkpoint.WriteLatest();
            throw;
        }
    }

    private RenderOutcome RenderPasses(RenderOutcome outcome, RenderOptions options, ProgressDisplay? display, CancellationToken cancellation)
    {
        SampleRange wanted = options.Samples!.Value;
        FilmHeader header = Header(outcome.Scene.Render, wanted, options.Crop);
        header = request.Resumed is { } resumed ? ResumeVerb.GoOn(resumed, header, request, outcome.Scene.Render) : header;

        if (request.IsOfSequence)
        {
            ImageOutputs.CheckUnfinished(request.Outputs, replacement: header with { Samples = [wanted] });
        }

        TimeSpan? left = request.Time is { } limit ? limit - Stopwatch.GetElapsedTime(_begun) : null;
        PassRender passes = new(outcome.Scene, options, header) { Limit = left, Checkpoints = _checkpoints, IsOpenEnded = request.IsOpenEnded, Preview = display as PreviewDisplay };
        SampleRange missing = new(header.Samples is [.., var last] ? last.End : wanted.First, wanted.End);
        RenderStatistics statistics = passes.Render(outcome.Film, missing, display, cancellation);
        header = passes.Header;
        if (header.Samples is [var done])
        {
            RenderAuxiliary(outcome.Scene, options with { Samples = done }, cancellation);
        }

        if (request is { Time: not null, HasSamples: false, Noise: null, Part: null, Samples: null })
        {
            // Nobody asked for more than there was time for.
            header = PassRender.AsAll(header);
        }

        return outcome with { Statistics = Counted(outcome.Plan, statistics), Header = header, Checkpoints = _checkpoints };
    }

    // Of the samples that passes came to, so not before them; a half of them is worth nothing.
    private void RenderAuxiliary(Scene scene, RenderOptions options, CancellationToken cancellation)
    {
        try
        {
            cancellation.ThrowIfCancellationRequested();
            new FirstHitPass(scene, options).Render(_auxiliary!, cancellation);
        }
        catch (OperationCanceledException)
        {
            _auxiliary = null;
            if (request.Aovs.Count > 0)
            {
                streams.Warn("stopped before the auxiliary images (--aov) were made: they are left out");
            }
        }
    }

    private static RenderStatistics Counted(SamplePlan? plan, RenderStatistics picture) => plan?.Add(picture) ?? picture;

    // The content of a scene with large models takes its time.
    private FilmHeader Header(RenderDescription render, SampleRange wanted, Tile? crop) => new()
    {
        Width = render.Width,
        Height = render.Height,
        Content = _content ??= ContentHash.Of(_description!, request.ScenePath, crop),
        Samples = [],
        Wanted = wanted,
        Total = request.Samples is null && request.Part is null ? wanted.End : render.SamplesPerPixel,
        Crop = crop,
        Scene = Path.GetFullPath(request.ScenePath),
        Overrides = request.FilmWords,
        Software = CommandLine.Version,
    };

    private RenderOptions Options(RenderDescription render)
    {
        if (request.Pixel is { } p && (p[0] >= render.Width || p[1] >= render.Height))
        {
            throw Misplaced($"--pixel {p[0]},{p[1]}", render);
        }

        if (request.Crop is { } c && (c[2] < 1 || c[3] < 1 || c[0] > render.Width - c[2] || c[1] > render.Height - c[3]))
        {
            throw Misplaced($"--crop {string.Join(',', c)}", render);
        }

        if (request.Sample >= render.SamplesPerPixel)
        {
            throw new CommandException(ExitStatus.Usage, $"--sample {request.Sample}: the pixels have only samples 0 to {render.SamplesPerPixel - 1}");
        }

        return new()
        {
            Threads = request.Threads,
            Crop = request.Pixel is [var x, var y] ? new(x, y, 1, 1) : request.Area,
            Samples = request.Sample is { } sample ? new((int)sample, (int)sample + 1) : SampleShares.Of(request, render),
        };
    }

    private static CommandException Misplaced(string option, RenderDescription render) =>
        new(ExitStatus.Usage, $"{option}: is not within the picture of {render.Width}×{render.Height} pixels");

    private LightLayerFilm LayersFor(Scene scene, Film film)
    {
        try
        {
            return new(film, scene, request.Layers);
        }
        catch (ArgumentException e)
        {
            string hint = scene.Render.Integrator.Has(IntegratorTraits.Layers) ? "give several of them one \"lightGroup\"" : "choose another --integrator";
            throw new CommandException(ExitStatus.Usage, $"--aov: {char.ToLowerInvariant(e.Message[0])}{e.Message[1..].Split(" (Parameter '")[0].TrimEnd('.')}: {hint}");
        }
    }

    private Film FilmFor(Scene scene)
    {
        RenderDescription render = scene.Render;
        long bytes = FilmMemory.Bytes(render.Width, render.Height) + AovFilm.Bytes(request.Aovs, render.Width, render.Height) + LightLayerFilm.Bytes(request.Layers, scene)
            + (request.Denoise ? Denoising.Bytes(render.Width, render.Height) : request.NeedsPasses ? FilmMemory.Bytes(render.Width, render.Height) : 0);
        long available = GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;
        bool fits = bytes <= available && (long)render.Width * render.Height <= Film.MaxPixels;
        return fits ? new(render.Width, render.Height) : throw new CommandException(
            ExitStatus.InputOutput, $"a film of {render.Width}×{render.Height} pixels takes {FilmMemory.Text(bytes)} of memory, more than is available ({FilmMemory.Text(available)})");
    }

    private IReadOnlyList<string> Write(RenderOutcome outcome, AovOutputs aovs)
    {
        KeyValuePair<string, string>[] texts =
        [
            new("Software", CommandLine.Version),
            new("Command", request.CommandText),
            new("Scene", Path.GetFileName(request.ScenePath)),
            new("Samples", $"{outcome.SamplesText}{(outcome.Statistics.Cancelled ? $", unfinished: {outcome.Statistics.Paths} paths" : "")}"),
            new("FilmHash", outcome.Hash),
            .. outcome.RangeText is { } range ? [KeyValuePair.Create("SampleRange", range)] : Array.Empty<KeyValuePair<string, string>>(),
            .. outcome.Plan is { } plan && request.Noise is { } wanted
                ? [KeyValuePair.Create(FinishedPicture.NoiseKey, FinishedPicture.NoiseText(plan.Error, wanted, !outcome.IsNoisy(request)))] : Array.Empty<KeyValuePair<string, string>>(),
            .. request.IsOfSequence ? [KeyValuePair.Create("Content", ContentHash.OfPicture(_description!, request.ScenePath, request.Area))] : Array.Empty<KeyValuePair<string, string>>(),
        ];
        ImageWriteOptions writing = request.Writing with { Metadata = texts };
        Picture? denoised = _denoising?.Denoise(request.Threads);
        IReadOnlyList<ExrLayerChannel> layers = [.. _auxiliary is null ? [] : AovFiles.Layers(_auxiliary), .. _light is null ? [] : AovFiles.Layers(_light), .. denoised is null ? [] : DenoisedFiles.Layers(denoised)];
        writing = writing with { ExrLayers = layers };
        IReadOnlyList<string> pictures = outcome.Header is { } header
            ? ImageOutputs.Write(request.Outputs, outcome.Film, header, writing, streams)
            : ImageOutputs.Write(request.Outputs, outcome.Film, writing, streams);
        return [.. pictures, .. aovs.Write(_auxiliary, _light, denoised, writing with { ExrLayers = [] }, streams)];
    }
}

/// <summary>What a rendering came to.</summary>
/// <param name="Scene">What was rendered.</param>
/// <param name="Film">The picture.</param>
/// <param name="Statistics">What was done for it.</param>
/// <param name="Threads">On how many threads.</param>
/// <param name="Seconds">How long that took.</param>
internal sealed record RenderOutcome(Scene Scene, Film Film, RenderStatistics Statistics, int Threads, double Seconds)
{
    private string? _hash;

    /// <summary>The film's hash.</summary>
    public string Hash => _hash ??= Film.ComputeHash();

    /// <summary>How the numbers of samples were decided; null where they were given.</summary>
    public SamplePlan? Plan { get; init; }

    /// <summary>What a film file says of the film; null where it need not hold whole passes.</summary>
    public FilmHeader? Header { get; init; }

    /// <summary>Which samples the pixels have, where all have the same and no passes were made.</summary>
    public SampleRange? Samples { get; init; }

    /// <summary>The checkpoints; null where there are none.</summary>
    public Checkpoints? Checkpoints { get; init; }

    /// <summary>How many samples the pixels have.</summary>
    public string SamplesText => RangeText is { } range ? range.StartsWith("0..", StringComparison.Ordinal) && !range.Contains(',', StringComparison.Ordinal) ? $"{MeanSamples}" : $"{MeanSamples} ({range})"
        : Plan is null ? $"{Scene.Render.SamplesPerPixel}"
        : $"{Plan.Fewest} to {Plan.Most} (mean {MeanSamples:F1})";

    /// <summary>Which samples all pixels have, the last one included; null where that is not the same for all, or none.</summary>
    public string? RangeText => Header is { Samples.Count: > 0 } header ? header.SamplesText : Samples is { } range && !Statistics.Cancelled ? FilmHeader.Text(range) : null;

    /// <summary>How many samples a pixel has on average.</summary>
    public double MeanSamples => Header?.Samples.Sum(r => r.Count) ?? Samples?.Count ?? (Plan is null ? Scene.Render.SamplesPerPixel : (double)Plan.TotalSamples / Plan.Area.Pixels);

    /// <summary>Whether the wanted noise was not reached, for want of samples or time.</summary>
    public bool IsNoisy(RenderRequest request) => request.Noise is { } wanted && (Plan?.Error > wanted || Header is { IsComplete: false });

    /// <summary>Rays a second.</summary>
    public double RaysPerSecond => Seconds > 0 ? Statistics.Rays / Seconds : 0;
}
