using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>What a job came to.</summary>
/// <param name="Scene">What was rendered.</param>
/// <param name="Film">The picture.</param>
/// <param name="Statistics">What was done for it.</param>
/// <param name="Threads">On how many threads.</param>
/// <param name="Seconds">How long that took.</param>
public sealed record JobResult(Scene Scene, Film Film, RenderStatistics Statistics, int Threads, double Seconds)
{
    private string? _hash;

    /// <summary>The files that were written.</summary>
    public IReadOnlyList<string> Files { get; init; } = [];

    /// <summary>Whether all files that were asked for were written, and the latest checkpoint.</summary>
    public bool IsWritten { get; init; }

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
    public bool IsNoisy(RenderJob job) => job.Noise is { } wanted && (Plan?.Error > wanted || Header is { IsComplete: false });

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
}
