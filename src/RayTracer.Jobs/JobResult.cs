using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>The outcome of a job.</summary>
/// <param name="Scene">The scene that was rendered.</param>
/// <param name="Film">The picture.</param>
/// <param name="Statistics">The work that it took.</param>
/// <param name="Threads">The number of threads.</param>
/// <param name="Seconds">The time that rendering took.</param>
public sealed record JobResult(Scene Scene, Film Film, RenderStatistics Statistics, int Threads, double Seconds)
{
    private string? _hash;

    /// <summary>The files that were written.</summary>
    public IReadOnlyList<string> Files { get; init; } = [];

    /// <summary>True if all files that were asked for were written, and the latest checkpoint.</summary>
    public bool IsWritten { get; init; }

    /// <summary>The hash of the film as files keep it: of halves of the samples, only where they do.</summary>
    public string Hash => _hash ??= Film.ComputeHash(Header?.Planes ?? [.. Film.Planes.Where(p => p == FilmPlane.Light || FilmPlane.OfSamples.Contains(p))]);

    /// <summary>The decision on the numbers of samples; null where they were given.</summary>
    public SamplePlan? Plan { get; init; }

    /// <summary>What was learned before the picture; null where it is not guided.</summary>
    public GuideResult? Guide { get; init; }

    /// <summary>The header of the film's file; null where it need not hold whole passes.</summary>
    public FilmHeader? Header { get; init; }

    /// <summary>The samples of the pixels, where all have the same.</summary>
    public SampleRange? Samples { get; init; }

    /// <summary>The checkpoints; null where there are none.</summary>
    public Checkpoints? Checkpoints { get; init; }

    /// <summary>The description that the scene was built from; null where it is not known.</summary>
    public SceneDescription? Description { get; init; }

    /// <summary>The auxiliary images; null where they are left out.</summary>
    public AovFilm? Auxiliary { get; init; }

    /// <summary>The layers of light; null where there are none.</summary>
    public LightPathAovFilm? Light { get; init; }

    /// <summary>What each way to make paths brings; null where nobody asks.</summary>
    internal StrategyFilm? Strategies { get; init; }

    /// <summary>Denoises the film; null where no denoised picture is wanted.</summary>
    public Denoising? Denoising { get; init; }

    /// <summary>The denoised picture; null where there is none.</summary>
    public DenoiseResult? Denoised { get; init; }

    /// <summary>The numbers of samples that the pixels have, in words.</summary>
    public string SamplesText => RangeText is { } range ? $"{MeanSamples}{(IsFromFirst(range) ? "" : $" ({range})")}"
        : Plan is null ? $"{Scene.Render.SamplesPerPixel}"
        : $"{Plan.Fewest} to {Plan.Most} (mean {MeanSamples:F1})";

    /// <summary>The samples that all pixels have, the last one included; null where that is not the same for all, or none.</summary>
    public string? RangeText => Header is { Samples.Count: > 0 } header ? header.SamplesText
        : Samples is { Count: > 0 } range ? FilmHeader.Text(range) : null;

    /// <summary>The mean number of samples of a pixel.</summary>
    public double MeanSamples => Header?.Samples.Sum(r => r.Count) ?? Samples?.Count ?? Plan?.MeanSamples ?? Scene.Render.SamplesPerPixel;

    /// <summary>Returns whether the wanted noise was not reached, for want of samples or time.</summary>
    public bool IsNoisy(RenderJob job) => job.Noise is { } wanted && (Plan?.Error > wanted || Header is { IsComplete: false });

    /// <summary>Returns what was done for the picture and to decide on it.</summary>
    internal RenderStatistics Counted(RenderStatistics picture) => Plan?.Add(picture) ?? picture;

    /// <summary>Warns of samples that were made smaller.</summary>
    public void WarnOfClamped(IJobWatch watch)
    {
        if (Statistics.ClampedSamples > 0)
        {
            watch.Warn($"{Statistics.ClampedSamples} samples were clamped at ±{Film.SampleLimit}: the picture is too dark there");
        }
    }

    /// <summary>Rays a second.</summary>
    public double RaysPerSecond => Seconds > 0 ? Statistics.Rays / Seconds : 0;

    private static bool IsFromFirst(string range) =>
        range.StartsWith("0..", StringComparison.Ordinal) && !range.Contains(',', StringComparison.Ordinal);
}
