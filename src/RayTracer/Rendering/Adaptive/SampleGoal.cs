namespace RayTracer.Rendering;

/// <summary>
/// The samples that a picture shall have where their number is not the same for all of its pixels, or not known beforehand.
/// </summary>
public sealed record SampleGoal
{
    /// <summary>
    /// The wanted relative error of the picture (see <see cref="SamplePlan.Error"/>), above 0; null to spend all samples.
    /// </summary>
    public double? Error { get; init; }

    /// <summary>True where pixels may have different numbers of samples.</summary>
    public bool IsAdaptive { get; init; }

    /// <summary>
    /// The most samples a pixel, on average over the picture; with <see cref="IsAdaptive"/>, those that decide count too, but for the
    /// fewest that it takes to decide at all.
    /// </summary>
    public required int MeanSamples { get; init; }

    /// <summary>The most samples of one pixel.</summary>
    public required int MostSamples { get; init; }
}
