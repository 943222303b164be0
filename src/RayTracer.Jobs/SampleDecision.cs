using System.Diagnostics;
using System.Globalization;
using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>The number of samples, where that is decided by <c>--noise</c>, <c>--adaptive</c> or <c>--time</c>.</summary>
/// <param name="job">The whole job.</param>
public sealed class SampleDecision(RenderJob job)
{
    /// <summary>The most samples of a pixel where none is given.</summary>
    public const int Limit = 65536;

    private const int MostSamples = 1 << 24;
    private const int MostOverMean = 16;
    private const int ShareOfTime = 4;
    private int _mean;
    private int _most;

    private bool IsAny => job.Noise is not null || job.Adaptive;

    // What is decided, in words.
    private string Goal => string.Create(CultureInfo.InvariantCulture, $"{job.Noise}-{_mean}");

    /// <summary>Gives a scene as many samples as a pixel may come to.</summary>
    /// <exception cref="JobException">The sampler needs to know the number of samples beforehand.</exception>
    public SceneDescription Widen(SceneDescription scene)
    {
        RenderDescription render = scene.Render;
        if (!IsAny && job.Time is null)
        {
            return scene;
        }

        if (render.Sampler.DependsOnCount)
        {
            string option = job.Adaptive ? "--adaptive" : job.Noise is not null ? "--noise" : "--time";
            string sampler = render.Sampler.ToString().ToLowerInvariant();
            throw new JobException(
                JobFault.Request, $"{option}: the pattern of the {sampler} sampler needs the number of samples in advance: use --sampler sobol or independent");
        }

        bool isGiven = (job.Noise is null && job.Time is null) || job.GivenSamples is not null || job.Part is not null
            || job.Samples is not null;
        _mean = isGiven ? render.SamplesPerPixel : Limit;
        _most = job.Adaptive ? (int)Math.Min(MostSamples, (long)MostOverMean * _mean) : _mean;
        return scene with { Render = render with { SamplesPerPixel = _most } };
    }

    /// <summary>The samples that an earlier run decided on that went by the same words; null where there was none.</summary>
    internal SampleRange? Earlier =>
        job is { Noise: not null, Resumed.Header: var header } && OldFilms.Settings(header).SequenceEqual(job.FilmSettings) ? header.Wanted
            : null;

    /// <summary>Returns the samples of pixels by a plan, where all shall have as many as the mean; null without one.</summary>
    internal static SampleRange? RangeOf(SamplePlan? plan) => plan is null ? null : new(0, (int)double.Round(plan.MeanSamples));

    /// <summary>Decides how many samples the pixels shall have; null where nothing was asked for, or it was decided before.</summary>
    /// <param name="loaded">The loaded scene to render.</param>
    /// <param name="checkpoints">Keep what is decided by; may be null.</param>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    internal SamplePlan? Plan(LoadedJob loaded, Checkpoints? checkpoints)
    {
        if (!IsAny || Earlier is not null)
        {
            return null;
        }

        if (job.Noise is null || job.Resumed is not null || checkpoints is null)
        {
            return Plan(loaded, null, null);
        }

        DecisionCheckpoint checkpoint = new(checkpoints, loaded.NewHeader(), Goal);
        try
        {
            return Plan(loaded, job.Decision is { } decision ? checkpoint.Begun(decision, job, loaded.Description) : null, checkpoint.Keep);
        }
        catch (OperationCanceledException)
        {
            checkpoint.WriteLatest();
            throw;
        }
    }

    private SamplePlan Plan(LoadedJob loaded, DecidingState? begun, Action<DecidingState>? keep)
    {
        SampleGoal goal = new() { Error = job.Noise, IsAdaptive = job.Adaptive, MeanSamples = _mean, MostSamples = _most };
        long start = Stopwatch.GetTimestamp();

        // Twice the samples take twice the time: no more than half of it all then.
        bool IsShort() => Stopwatch.GetElapsedTime(start) > job.Time / ShareOfTime;
        SamplePlanner planner = new(loaded.Scene, loaded.Options, goal) { IsShortOfTime = job.Time is null ? null : IsShort, Begun = begun, Keep = keep };
        return planner.Plan(loaded.Progress, loaded.Cancellation);
    }
}
