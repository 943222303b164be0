using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>Carries out a job of one picture: loads, renders, writes.</summary>
/// <param name="job">The job to render.</param>
/// <param name="watch">Takes what there is to report.</param>
public sealed class JobRun(RenderJob job, IJobWatch watch)
{
    private readonly SampleDecision _decision = new(job);
    private readonly PictureFiles _files = new(job);

    // From the beginning on, so that it knows what is there before the work.
    private readonly Checkpoints? _checkpoints = job.Checkpoint is { } path ? new(path, job.CheckpointInterval, watch) : null;

    /// <summary>Changes the description before the scene is built; may be null.</summary>
    public Func<SceneDescription, SceneDescription>? Change { get; init; }

    /// <summary>Reads pictures; null for <see cref="ImageFile.Read"/>.</summary>
    public Func<string, bool, Picture>? ReadPicture { get; init; }

    /// <summary>Loads, renders and writes.</summary>
    /// <param name="cancellation">Ends the rendering early; what is done so far is written.</param>
    /// <returns>The outcome; null where the scene is wrong, which was reported.</returns>
    /// <exception cref="JobException">What was asked for cannot be done.</exception>
    /// <exception cref="ImageWriteException">A file cannot be written, which was found out before the work.</exception>
    public JobResult? Run(CancellationToken cancellation)
    {
        using InputFiles inputs = InputFiles.Begin();
        _files.Check();
        if (Compute(cancellation) is not { } result)
        {
            return null;
        }

        return job.Pixel is null ? Written(result) : result;
    }

    /// <summary>Loads and renders.</summary>
    /// <param name="cancellation">Ends it early.</param>
    /// <returns>The outcome; null where the scene is wrong, which was reported.</returns>
    /// <exception cref="JobException">What was asked for cannot be done, or a class of a plug-in threw an exception.</exception>
    public JobResult? Compute(CancellationToken cancellation)
    {
        try
        {
            return Computed(cancellation);
        }
        catch (Exception e) when (PluginFault.Is(e))
        {
            throw PluginFault.Report(e);
        }
    }

    private JobResult? Computed(CancellationToken cancellation)
    {
        SceneLoadResult load = job.Load(Described, ReadPicture);
        watch.Read(load.Diagnostics);
        if (load is not { Scene: { } scene, Description: { } description })
        {
            return null;
        }

        RenderJob rendered = job with { Edition = Edition.For(job.Edition, scene.Render) };
        if (rendered.Edition != job.Edition && JobRules.Complaint(rendered) is { } complaint)
        {
            throw new JobException(JobFault.Request, complaint);
        }

        Textbook.Renderer? textbook = Edition.Renderer(rendered.Edition, load, out IReadOnlyList<Diagnostic> refused);
        watch.Read(refused);
        if (refused.Count > 0)
        {
            return null;
        }

        watch.End(JobStage.Build);
        _files.CheckInputs();
        JobFiles.CheckSize(job.Outputs, job.Writing, scene.Render.Width, scene.Render.Height);
        RenderOptions options = Shares.Options(job, scene.Render);
        JobFilms films = new(job, scene);
        _files.Add(films.Light?.Names ?? []);
        IProgress<RenderProgress>? progress = watch.Begin(scene.Render);
        using IDisposable? shown = progress as IDisposable;
        long start = Stopwatch.GetTimestamp();
        JobResult result = Render(new(rendered, scene, description, options with { Layers = films.Light, Strategies = films.Strategies }, progress, cancellation) { Textbook = textbook }, films);
        result = result with { Seconds = Stopwatch.GetElapsedTime(start).TotalSeconds, Description = description };
        shown?.Dispose();
        watch.End(JobStage.Render);
        return result;
    }

    // Called when the scene file has been read, before the scene is built.
    private SceneDescription Described(SceneDescription scene)
    {
        RenderDescription render = scene.Render;
        SceneSetting? Given(string path) => job.Settings.LastOrDefault(s => s.Path == path);
        if ((Given(RenderJob.SamplesPath) ?? Given("render.sampler")) is { } changed && render.Sampler.Complaint(render.SamplesPerPixel) is { } complaint)
        {
            throw new JobException(JobFault.Request, $"{JobOptions.Given(changed)}: {complaint}");
        }

        scene = _decision.Widen(Change?.Invoke(scene) ?? scene);
        watch.Begin(scene);
        watch.End(JobStage.Load);
        return scene;
    }

    private JobResult Render(LoadedJob loaded, JobFilms films)
    {
        Guidance.Check(loaded);
        JobResult result = new(loaded.Scene, films.Film, new() { Cancelled = true }, loaded.Options.Threads, 0) { Light = films.Light, Strategies = films.Strategies };
        try
        {
            long begun = Stopwatch.GetTimestamp();
            (loaded, GuideResult? learned) = Guidance.Guide(loaded);
            result = result with { Guide = learned };
            _checkpoints?.CheckLost(loaded);
            result = result with { Plan = _decision.Plan(loaded, _checkpoints) };
            loaded = loaded.With(_decision.Earlier ?? SampleDecision.RangeOf(result.Plan));
            return new PassRender(loaded, films, watch) { Limit = job.Time - Stopwatch.GetElapsedTime(begun), Checkpoints = _checkpoints }.Render(result);
        }
        catch (OperationCanceledException)
        {
            // There is no picture yet.
            return result;
        }
        catch (Exception e) when (PluginFault.Is(e))
        {
            throw PluginFault.Report(e, loaded.Scene);
        }
    }

    private DenoiseResult? Denoise(Denoising denoising, Film film, RenderDescription render)
    {
        IProgress<RenderProgress>? progress = watch.Begin(render);
        using IDisposable? shown = progress as IDisposable;
        DenoiseResult? denoised = denoising.Denoise(film, progress is null ? null : new DenoisingProgress(progress));
        if (denoised is null)
        {
            watch.Warn("all samples so far are of one of the two halves that --denoise compares: there is no denoised picture");
        }

        shown?.Dispose();
        watch.End(JobStage.Denoise);
        return denoised;
    }

    private JobResult Written(JobResult result)
    {
        bool isWanted = result.Film.TotalSamples > 0 && !(job.IsOfSequence && result.Statistics.Cancelled);
        if (isWanted && result.Denoising is { } denoising)
        {
            result = result with { Denoised = Denoise(denoising, result.Film, result.Scene.Render) };
        }

        IReadOnlyList<string> files = isWanted ? _files.Write(result, watch) : [];
        watch.End(JobStage.Write);
        return result with { Files = files, IsWritten = files.Count == _files.All.Count && _checkpoints is not { HasFailed: true } };
    }

    private sealed class DenoisingProgress(IProgress<RenderProgress> shown) : IProgress<double>
    {
        private const long Whole = 1000;

        public void Report(double value) => shown.Report(new((long)(value * Whole), Whole, 0));
    }
}
