using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Takes noise out of renders: non-local means (Buades, Coll &amp; Morel 2005) over two halves of the samples, each filtered with weights
/// that the other one gives, so that no noise chooses its own weights (Rousselle, Knaus &amp; Zwicker 2012), and guided by normals and
/// albedos (Rousselle, Manzi &amp; Zwicker 2013). What is filtered is the light, which is the colour divided by the albedo. A pixel's result
/// depends on its surroundings only, in a fixed order: it is the same to the bit for any number of threads.
/// </summary>
public static class Denoiser
{
    /// <summary>Memory that is taken besides the halves, in bytes a pixel of a large picture.</summary>
    public const int BytesPerPixel = 300;

    // A picture of half the size has a quarter of the work.
    private const double CoarseBegins = 0.8;

    /// <summary>Denoises a picture.</summary>
    /// <param name="first">One half of the samples.</param>
    /// <param name="second">The other half; of the same size.</param>
    /// <param name="threads">The number of threads; 0 for one a core.</param>
    /// <param name="progress">Takes how much is done, 0 to 1; may be null.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <returns>The mean of both halves, without most of its noise; where one has no samples, the mean of all there are.</returns>
    /// <exception cref="ArgumentException">The sizes differ.</exception>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    public static DenoiseResult Denoise(HalfRender first, HalfRender second, int threads = 0, IProgress<double>? progress = null, CancellationToken cancellation = default)
    {
        (int width, int height) = (first.Film.Width, first.Film.Height);
        return (second.Film.Width, second.Film.Height) == (width, height)
            ? Denoise(HalfPlanes.Of(first), HalfPlanes.Of(second), threads, progress, cancellation)
            : throw new ArgumentException($"Halves of {width}×{height} and {second.Film.Width}×{second.Film.Height} pixels are not of one picture.", nameof(second));
    }

    /// <summary>Denoises a film whose halves are not known: its noise is estimated from its pixels alone, which is worse.</summary>
    /// <param name="whole">All samples.</param>
    /// <param name="threads">The number of threads; 0 for one a core.</param>
    public static Picture Denoise(HalfRender whole, int threads = 0)
    {
        HalfPlanes planes = HalfPlanes.Of(whole);
        return Denoise(planes, planes, threads).Picture;
    }

    /// <summary>Denoises a picture of which no halves are known: its noise is estimated from its pixels alone, which is worse.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="albedo">The surfaces' colours; null where they are not known.</param>
    /// <param name="normal">The surfaces' normals; null where they are not known.</param>
    /// <param name="threads">The number of threads; 0 for one a core.</param>
    /// <exception cref="ArgumentException">The sizes differ.</exception>
    public static Picture Denoise(Picture picture, Picture? albedo, Picture? normal, int threads = 0)
    {
        HalfPlanes planes = HalfPlanes.Of(picture, albedo, normal);
        return Denoise(planes, planes, threads).Picture;
    }

    /// <inheritdoc cref="Denoise(HalfRender, HalfRender, int, IProgress{double}?, CancellationToken)"/>
    internal static DenoiseResult Denoise(HalfPlanes first, HalfPlanes second, int threads = 0, IProgress<double>? progress = null, CancellationToken cancellation = default)
    {
        double cut = DenoiserInput.Cut(first, second);
        ParallelOptions parallel = new() { MaxDegreeOfParallelism = threads > 0 ? threads : Environment.ProcessorCount, CancellationToken = cancellation };
        DenoiserInput input = new(first, second);
        Picture result = Filter(input, parallel, done => progress?.Report(CoarseBegins * done));
        DenoiserInput coarse = input.Halved();
        Picture coarseResult = Filter(coarse, parallel, done => progress?.Report(CoarseBegins + ((1 - CoarseBegins) * done)));
        CoarserScale.Correct(result, input, coarseResult, coarse);
        return new(result, cut);
    }

    private static Picture Filter(DenoiserInput input, ParallelOptions parallel, Action<double> report)
    {
        Picture result = new(input.Sampled.Width, input.Sampled.Height);
        int across = (result.Width + DenoiserTile.Width - 1) / DenoiserTile.Width;
        int down = (result.Height + DenoiserTile.Height - 1) / DenoiserTile.Height;
        int done = 0;
        Parallel.For(0, across * down, parallel, () => new DenoiserTile(input), (i, _, tile) =>
        {
            tile.Filter(i % across * DenoiserTile.Width, i / across * DenoiserTile.Height);
            tile.Write(result);
            report(Interlocked.Increment(ref done) / (double)(across * down));
            return tile;
        }, _ => { });
        return result;
    }
}

/// <summary>What a denoiser makes.</summary>
/// <param name="Picture">The picture without most of its noise.</param>
/// <param name="CutShare">The share of its light that was taken away, because it stood out of one half alone.</param>
public sealed record DenoiseResult(Picture Picture, double CutShare);
