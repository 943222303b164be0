using System.Diagnostics;
using System.Globalization;
using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>What <c>--noise</c> and <c>--adaptive</c> ask for; and how many samples there may be, where <c>--time</c> ends the rendering.</summary>
/// <param name="request">The whole request.</param>
internal sealed class NoiseRequest(RenderRequest request)
{
    /// <summary>The most samples of a pixel where nobody says how many.</summary>
    public const int Limit = 65536;

    private const int MostSamples = 1 << 24;
    private const int MostOverMean = 16;
    private const int ShareOfTime = 4;
    private int _mean;
    private int _most;

    /// <summary>Whether they ask for anything.</summary>
    public bool IsAny => request.Noise is not null || request.Adaptive;

    /// <summary>What is decided, in words.</summary>
    public string Goal => string.Create(CultureInfo.InvariantCulture, $"{request.Noise}-{_mean}");

    /// <summary>Gives a scene as many samples as a pixel may come to.</summary>
    /// <exception cref="CommandException">The sampler needs to know the number of samples beforehand.</exception>
    public SceneDescription Widen(SceneDescription scene)
    {
        RenderDescription render = scene.Render;
        if (!IsAny && request.Time is null)
        {
            return scene;
        }

        if (render.Sampler.DependsOnCount)
        {
            string option = request.Adaptive ? "--adaptive" : request.Noise is not null ? "--noise" : "--time";
            throw new CommandException(
                ExitStatus.Usage, $"{option}: the pattern of the {render.Sampler.ToString().ToLowerInvariant()} sampler needs the number of samples in advance: use --sampler sobol or independent");
        }

        _mean = (request.Noise is null && request.Time is null) || request.HasSamples || request.Part is not null || request.Samples is not null ? render.SamplesPerPixel : Limit;
        _most = request.Adaptive ? (int)Math.Min(MostSamples, (long)MostOverMean * _mean) : _mean;
        return scene with { Render = render with { SamplesPerPixel = _most } };
    }

    /// <summary>Decides how many samples the pixels shall have; null where nothing was asked for.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="options">How to compute it.</param>
    /// <param name="begun">Where to go on from; null to begin anew.</param>
    /// <param name="keep">Told how far it has come; may be null.</param>
    /// <param name="progress">Told how far the picture is.</param>
    /// <param name="cancellation">Ends it.</param>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    public SamplePlan? Plan(Scene scene, RenderOptions options, DecidingState? begun, Action<DecidingState>? keep, IProgress<RenderProgress>? progress, CancellationToken cancellation)
    {
        SampleGoal goal = new() { Error = request.Noise, IsAdaptive = request.Adaptive, MeanSamples = _mean, MostSamples = _most };
        long start = Stopwatch.GetTimestamp();

        // Twice the samples take twice the time: no more than half of it all then.
        bool IsShort() => Stopwatch.GetElapsedTime(start) > request.Time / ShareOfTime;
        return IsAny ? new SamplePlanner(scene, options, goal) { IsShortOfTime = request.Time is null ? null : IsShort, Begun = begun, Keep = keep }.Plan(progress, cancellation) : null;
    }
}
