namespace RayTracer.Rendering;

/// <summary>
/// Makes auxiliary images: traces the same camera rays as a rendering, to the first surface and no further. It stands beside the rendering, so that
/// pictures without such images take no longer, and with them have the same bits.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="options">How to compute it, and which part; null for the defaults.</param>
public sealed class FirstHitPass(Scene scene, RenderOptions? options = null)
{
    private const int LargestTile = 32;
    private readonly RenderOptions _options = options ?? new();

    /// <summary>Adds the samples.</summary>
    /// <param name="film">Images of the scene's size.</param>
    /// <param name="cancellation">Ends the work after the tiles under way.</param>
    /// <exception cref="OperationCanceledException">It was cancelled; the images lack samples.</exception>
    /// <exception cref="ArgumentException">The size is not the scene's.</exception>
    public void Render(AovFilm film, CancellationToken cancellation = default)
    {
        if (film.Width != scene.Render.Width || film.Height != scene.Render.Height)
        {
            throw new ArgumentException($"The images have {film.Width}×{film.Height} pixels, but the scene {scene.Render.Width}×{scene.Render.Height}.", nameof(film));
        }

        if (!film.NeedsRays)
        {
            return;
        }

        Tile area = _options.Crop ?? new(0, 0, film.Width, film.Height);
        SampleRange samples = _options.Samples ?? new(0, scene.Render.SamplesPerPixel);
        int edge = _options.TileSize > 0 ? _options.TileSize : LargestTile;
        ParallelOptions parallel = new()
        {
            MaxDegreeOfParallelism = _options.Threads > 0 ? _options.Threads : Environment.ProcessorCount,
            CancellationToken = cancellation,
        };
        Parallel.ForEach(
            Tile.Cut(area, edge),
            parallel,
            () => new FirstHits(scene, _options.StreamSize, edge * edge),
            (tile, _, worker) =>
            {
                for (int first = samples.First; first < samples.End; first += SampleAccumulator.MaxSamples)
                {
                    worker.Add(film, tile, new(first, Math.Min(samples.End, first + SampleAccumulator.MaxSamples)));
                }

                return worker;
            },
            _ => { });
    }
}
