using System.Diagnostics;
using System.Globalization;
using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>How many samples there are, where that is decided by <c>--noise</c>, <c>--adaptive</c> or <c>--time</c>.</summary>
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

    /// <summary>Whether they ask for anything.</summary>
    public bool IsAny => job.Noise is not null || job.Adaptive;

    /// <summary>What is decided, in words.</summary>
    public string Goal => string.Create(CultureInfo.InvariantCulture, $"{job.Noise}-{_mean}");

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
            throw new JobException(JobFault.Request, $"{option}: the pattern of the {render.Sampler.ToString().ToLowerInvariant()} sampler needs the number of samples in advance: "
                + "use --sampler sobol or independent");
        }

        _mean = (job.Noise is null && job.Time is null) || job.GivenSamples is not null || job.Part is not null || job.Samples is not null ? render.SamplesPerPixel : Limit;
        _most = job.Adaptive ? (int)Math.Min(MostSamples, (long)MostOverMean * _mean) : _mean;
        return scene with { Render = render with { SamplesPerPixel = _most } };
    }

    /// <summary>Decides how many samples the pixels shall have; null where nothing was asked for.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="options">How to compute it.</param>
    /// <param name="begun">What has been decided before; null to begin from scratch.</param>
    /// <param name="keep">Takes how far it has come; may be null.</param>
    /// <param name="progress">Takes how far the picture is.</param>
    /// <param name="cancellation">Ends it.</param>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    public SamplePlan? Plan(
        Scene scene, RenderOptions options, DecidingState? begun, Action<DecidingState>? keep, IProgress<RenderProgress>? progress, CancellationToken cancellation)
    {
        SampleGoal goal = new() { Error = job.Noise, IsAdaptive = job.Adaptive, MeanSamples = _mean, MostSamples = _most };
        long start = Stopwatch.GetTimestamp();

        // Twice the samples take twice the time: no more than half of it all then.
        bool IsShort() => Stopwatch.GetElapsedTime(start) > job.Time / ShareOfTime;
        return IsAny ? new SamplePlanner(scene, options, goal) { IsShortOfTime = job.Time is null ? null : IsShort, Begun = begun, Keep = keep }.Plan(progress, cancellation) : null;
    }
}
