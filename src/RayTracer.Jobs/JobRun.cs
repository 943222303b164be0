using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>Carries out a job of one picture: loads, renders, writes.</summary>
/// <param name="job">What to render.</param>
/// <param name="watch">Takes what there is to report.</param>
public sealed class JobRun(RenderJob job, IJobWatch watch)
{
    private readonly SampleDecision _decision = new(job);

    // From the beginning on, so that it knows what is there before the work.
    private readonly Checkpoints? _checkpoints = job.Checkpoint is { } path ? new(path, job.CheckpointInterval, watch) : null;
    private readonly BesideFiles _beside = new(job);
    private SceneDescription? _description;
    private string? _content;
    private long _begun;
    private AovFilm? _auxiliary;
    private LightLayerFilm? _light;
    private Denoising? _denoising;

    /// <summary>Changes the description before the scene is built; may be null.</summary>
    public Func<SceneDescription, SceneDescription>? Change { get; init; }

    /// <summary>Reads pictures; null for <see cref="ImageFile.Read"/>.</summary>
    public Func<string, bool, Picture>? ReadPicture { get; init; }

    private bool NeedsPasses => job.NeedsPasses || watch.ShowsPasses;

    /// <summary>Loads, renders and writes.</summary>
    /// <param name="cancellation">Ends the rendering early; what is done so far is written.</param>
    /// <returns>What it came to; null where the scene is wrong, which was reported.</returns>
    /// <exception cref="JobException">What was asked for cannot be done.</exception>
    /// <exception cref="ImageWriteException">A file cannot be written, which was found out before the work.</exception>
    public JobResult? Run(CancellationToken cancellation)
    {
        foreach (string output in job.Outputs.Concat(_beside.Files).Concat(job.Checkpoint is { } file ? [file] : []))
        {
            JobFiles.CheckFilm(output);
        }

        if (!job.IsOfSequence)
        {
            JobFiles.CheckUnfinished(job.Outputs.Concat(job.Checkpoint is { } film ? [film] : []), (job.Resumed ?? job.Decision)?.Path);
        }

        JobResult? result = Compute(cancellation);
        if (result is null || job.Pixel is not null)
        {
            return result;
        }

        bool isWanted = result.Film.TotalSamples > 0 && !(job.IsOfSequence && result.Statistics.Cancelled);
        IReadOnlyList<string> files = isWanted ? Write(result) : [];
        watch.End(JobStage.Write);
        return result with { Files = files, IsWritten = files.Count == job.Outputs.Count + _beside.Files.Count && result.Checkpoints is not { HasFailed: true } };
    }

    /// <summary>Loads and renders.</summary>
    /// <param name="cancellation">Ends it early.</param>
    /// <returns>What it came to; null where the scene is wrong, which was reported.</returns>
    public JobResult? Compute(CancellationToken cancellation)
    {
        SceneLoadResult load = job.Load(Described, ReadPicture);
        watch.Read(load.Diagnostics);
        _description = load.Description;
        if (load.Scene is not { } scene)
        {
            return null;
        }

        watch.End(JobStage.Build);
        JobFiles.CheckSize(job.Outputs, job.Writing, scene.Render.Width, scene.Render.Height);
        RenderOptions options = Options(scene.Render);
        Film film = job.Resumed?.Film ?? FilmFor(scene);
        if ((film.Width, film.Height) != (scene.Render.Width, scene.Render.Height))
        {
            throw Resuming.OtherScene(job.Scene);
        }

        if (job.Layers.Count > 0)
        {
            options = options with { Layers = _light = LayersFor(scene, film) };
            _beside.Add(_light.Names);
        }

        _auxiliary = new(film, job.Aovs);
        _denoising = job.Denoise ? Denoising.Create(scene) : null;
        IProgress<RenderProgress>? progress = watch.Begin();
        using IDisposable? shown = progress as IDisposable;
        long start = Stopwatch.GetTimestamp();
        JobResult result = Render(scene, film, options, progress, cancellation);
        result = result with { Seconds = Stopwatch.GetElapsedTime(start).TotalSeconds };
        shown?.Dispose();
        watch.End(JobStage.Render);
        return result;
    }

    // Called when the scene file has been read, before the scene is built.
    private SceneDescription Described(SceneDescription scene)
    {
        watch.End(JobStage.Load);
        RenderDescription render = scene.Render;
        SceneSetting? changed = job.Settings.LastOrDefault(s => s.Path == RenderJob.SamplesPath) ?? job.Settings.LastOrDefault(s => s.Path == "render.sampler");
        return changed is not null && render.Sampler.Complaint(render.SamplesPerPixel) is { } complaint
            ? throw new JobException(JobFault.Request, $"{JobOptions.Given(changed)}: {complaint}")
            : _decision.Widen(Change?.Invoke(scene) ?? scene);
    }

    private JobResult Render(Scene scene, Film film, RenderOptions options, IProgress<RenderProgress>? progress, CancellationToken cancellation)
    {
        JobResult result = new(scene, film, new() { Cancelled = true }, options.Threads, 0);
        try
        {
            _begun = Stopwatch.GetTimestamp();
            if (Decided is { } decided)
            {
                options = options with { Samples = decided };
            }
            else if (Plan(scene, options, progress, cancellation) is { } plan)
            {
                result = result with { Plan = plan };
                options = options with { Samples = new(0, (int)double.Round((double)plan.TotalSamples / plan.Area.Pixels)) };
            }

            if (NeedsPasses)
            {
                return RenderPasses(result, options, progress, cancellation);
            }

            // First, so that they are whole even where the picture is stopped early.
            new FirstHitPass(scene, options).Render(_auxiliary!, cancellation);
            return result with
            {
                Samples = job.Adaptive || job.Pixel is not null ? null : options.Samples,
                Statistics = _denoising?.Render(film, options, progress, cancellation)
                    ?? (job.Adaptive ? new PlannedRender(scene, options, result.Plan!).Render(film, progress, cancellation) : Counted(result.Plan, new RTracer(scene, options).Render(film, progress, cancellation))),
            };
        }
        catch (OperationCanceledException)
        {
            // There is no picture yet.
            return result;
        }
    }

    // What an earlier run decided that went by the same words.
    private SampleRange? Decided => job is { Noise: not null, Resumed.Header: var header } && OldFilms.Settings(header).SequenceEqual(job.FilmSettings) ? header.Wanted : null;

    private SamplePlan? Plan(Scene scene, RenderOptions options, IProgress<RenderProgress>? progress, CancellationToken cancellation)
    {
        if (job.Noise is null || job.Resumed is not null || _checkpoints is null)
        {
            return _decision.Plan(scene, options, null, null, progress, cancellation);
        }

        DecisionCheckpoint checkpoint = new(_checkpoints, Header(scene.Render, options.Samples!.Value, options.Crop), _decision.Goal);
        DecidingState? begun = job.Decision is { } decision ? checkpoint.Begun(decision, job, _description!) : null;
        try
        {
            return _decision.Plan(scene, options, begun, checkpoint.Keep, progress, cancellation);
        }
        catch (OperationCanceledException)
        {
            checkpoint.WriteLatest();
            throw;
        }
    }

    private JobResult RenderPasses(JobResult result, RenderOptions options, IProgress<RenderProgress>? progress, CancellationToken cancellation)
    {
        SampleRange wanted = options.Samples!.Value;
        FilmHeader header = Header(result.Scene.Render, wanted, options.Crop);
        header = job.Resumed is { } resumed ? Resuming.Header(resumed, header, job, _description!) : header;

        if (job.IsOfSequence)
        {
            JobFiles.CheckUnfinished(job.Outputs, replacement: header with { Samples = [wanted] });
        }

        TimeSpan? left = job.Time is { } limit ? limit - Stopwatch.GetElapsedTime(_begun) : null;
        PassRender passes = new(result.Scene, options, header, watch) { Limit = left, Checkpoints = _checkpoints, IsOpenEnded = job.IsOpenEnded };
        SampleRange missing = new(header.Samples is [.., var last] ? last.End : wanted.First, wanted.End);
        RenderStatistics statistics = passes.Render(result.Film, missing, progress, cancellation);
        header = passes.Header;
        if (header.Samples is [var done])
        {
            RenderAuxiliary(result.Scene, options with { Samples = done }, cancellation);
        }

        if (job is { Time: not null, GivenSamples: null, Noise: null, Part: null, Samples: null })
        {
            // Nobody asked for more than there was time for.
            header = PassRender.AsAll(header);
        }

        return result with { Statistics = Counted(result.Plan, statistics), Header = header, Checkpoints = _checkpoints };
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
            if (job.Aovs.Count > 0)
            {
                watch.Warn("stopped before the auxiliary images (--aov) were made: they are left out");
            }
        }
    }

    private static RenderStatistics Counted(SamplePlan? plan, RenderStatistics picture) => plan?.Add(picture) ?? picture;

    // The content of a scene with large models takes its time.
    private FilmHeader Header(RenderDescription render, SampleRange wanted, Tile? crop) => new()
    {
        Width = render.Width,
        Height = render.Height,
        Content = _content ??= ContentHash.Of(_description!, job.Scene, crop),
        Samples = [],
        Wanted = wanted,
        Total = job.Samples is null && job.Part is null ? wanted.End : render.SamplesPerPixel,
        Crop = crop,
        Scene = Path.GetFullPath(job.Scene),
        Settings = job.FilmSettings,
        Software = ProgramName.Text,
    };

    private RenderOptions Options(RenderDescription render)
    {
        if (job.Pixel is { } p && (p.X >= render.Width || p.Y >= render.Height))
        {
            throw Misplaced($"--pixel {p.X},{p.Y}", render);
        }

        if (job.Crop is { } c && (c.Width < 1 || c.Height < 1 || c.X > render.Width - c.Width || c.Y > render.Height - c.Height))
        {
            throw Misplaced($"--crop {c.X},{c.Y},{c.Width},{c.Height}", render);
        }

        if (job.Sample >= render.SamplesPerPixel)
        {
            throw new JobException(JobFault.Request, $"--sample {job.Sample}: the pixels have only samples 0 to {render.SamplesPerPixel - 1}");
        }

        return new()
        {
            Threads = job.Threads,
            Crop = job.Pixel is var (x, y) ? new(x, y, 1, 1) : job.Crop,
            Samples = job.Sample is { } sample ? new(sample, sample + 1) : Shares.Of(job, render),
        };
    }

    private static JobException Misplaced(string option, RenderDescription render) =>
        new(JobFault.Request, $"{option}: is not within the picture of {render.Width}×{render.Height} pixels");

    private LightLayerFilm LayersFor(Scene scene, Film film)
    {
        try
        {
            return new(film, scene, job.Layers);
        }
        catch (ArgumentException e)
        {
            string hint = scene.Render.Integrator.Has(IntegratorTraits.Layers) ? "give several of them one \"lightGroup\"" : "choose another --integrator";
            throw new JobException(JobFault.Request, $"--aov: {char.ToLowerInvariant(e.Message[0])}{e.Message[1..].Split(" (Parameter '")[0].TrimEnd('.')}: {hint}");
        }
    }

    private Film FilmFor(Scene scene)
    {
        RenderDescription render = scene.Render;
        long bytes = FilmMemory.Bytes(render.Width, render.Height) + AovFilm.Bytes(job.Aovs, render.Width, render.Height) + LightLayerFilm.Bytes(job.Layers, scene)
            + (job.Denoise ? Denoising.Bytes(render.Width, render.Height) : NeedsPasses ? FilmMemory.Bytes(render.Width, render.Height) : 0);
        long available = GC.GetGCMemoryInfo().TotalAvailableMemoryBytes;
        bool fits = bytes <= available && (long)render.Width * render.Height <= Film.MaxPixels;
        return fits ? new(render.Width, render.Height) : throw new JobException(
            JobFault.File, $"a film of {render.Width}×{render.Height} pixels takes {FilmMemory.Text(bytes)} of memory, more than is available ({FilmMemory.Text(available)})");
    }

    private IReadOnlyList<string> Write(JobResult result)
    {
        string samples = $"{result.SamplesText}{(result.Statistics.Cancelled ? $", unfinished: {result.Statistics.Paths} paths" : "")}";
        ImageWriteOptions writing = job.Writing with
        {
            Metadata =
            [
                .. PictureTexts.Of(job, result.Hash, samples, result.RangeText),
                .. result.Plan is { } plan && job.Noise is { } wanted ? PictureTexts.Noise(plan.Error, wanted, !result.IsNoisy(job)) : [],
                .. job.IsOfSequence ? PictureTexts.Content(ContentHash.OfPicture(_description!, job.Scene, job.Crop)) : [],
            ],
        };
        Picture? denoised = _denoising?.Denoise(job.Threads);
        ExrLayerChannel[] layers =
        [
            .. _auxiliary is null ? [] : AovFiles.Layers(_auxiliary),
            .. _light is null ? [] : AovFiles.Layers(_light),
            .. denoised is null ? [] : DenoisedFiles.Layers(denoised),
        ];
        IReadOnlyList<string> pictures = JobFiles.Write(job.Outputs, result.Film, result.Header, writing with { ExrLayers = layers }, watch);
        return [.. pictures, .. _beside.Write(_auxiliary, _light, denoised, writing, watch)];
    }
}
