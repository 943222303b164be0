namespace RayTracer.Rendering;

/// <summary>The numbers of samples that pixels will have: one for each block of pixels.</summary>
/// <param name="Area">The part of the picture.</param>
/// <param name="Blocks">Its blocks, row by row.</param>
/// <param name="Samples">For each block, the number of samples of each of its pixels.</param>
/// <param name="Error">
/// The relative error that is expected of the picture: the root of the mean, over all pixels and channels, of the squared error relative to
/// the block's brightness (plus a tenth of the picture's, so that black corners do not count for everything). Cautious where samples are
/// stratified.
/// </param>
/// <param name="Statistics">The work of deciding.</param>
public sealed record SamplePlan(Tile Area, IReadOnlyList<Tile> Blocks, IReadOnlyList<int> Samples, double Error, RenderStatistics Statistics)
{
    /// <summary>The work that was done for a picture and to decide on it.</summary>
    /// <param name="picture">The work for the picture.</param>
    public RenderStatistics Add(RenderStatistics picture) => picture with
    {
        Paths = picture.Paths + Statistics.Paths,
        ClosestHitRays = picture.ClosestHitRays + Statistics.ClosestHitRays,
        ShadowRays = picture.ShadowRays + Statistics.ShadowRays,
    };

    /// <summary>The plan with at most so many samples of each pixel.</summary>
    public SamplePlan UpTo(int samples) => samples >= Most ? this : this with { Samples = [.. Samples.Select(s => Math.Min(s, samples))] };

    /// <summary>Samples of all pixels together.</summary>
    public long TotalSamples => Blocks.Zip(Samples, (block, samples) => (long)block.Pixels * samples).Sum();

    /// <summary>The mean number of samples of a pixel.</summary>
    public double MeanSamples => (double)TotalSamples / Area.Pixels;

    /// <summary>The least samples of a pixel.</summary>
    public int Fewest => Samples.Min();

    /// <summary>The most samples of a pixel.</summary>
    public int Most => Samples.Max();
}
