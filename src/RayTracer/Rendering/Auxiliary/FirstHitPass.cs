namespace RayTracer.Rendering;

/// <summary>
/// Makes auxiliary images: traces the same camera rays as a rendering, to the first surface and no further. It stands beside the rendering, so that
/// pictures without such images take no longer, and with them have the same bits.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="options">The options of the computation, and the part; null for the defaults.</param>
public sealed class FirstHitPass(Scene scene, RenderOptions? options = null)
{
    private const int LargestTile = 32;
    private readonly RenderOptions _options = options ?? new();

    /// <summary>
    /// True to look through mirrors and clear glass, to the first surface that scatters most of the light to many directions. Media that scatter or send light weaken its albedo and its
    /// normal, as they do the light.
    /// </summary>
    public bool SeesThrough { get; init; }

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

        film.Names = film.HasMattes ? scene.Names : null;
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
            () => Worker(edge * edge),
            (tile, _, add) =>
            {
                for (int first = samples.First; first < samples.End; first += SampleAccumulator.MaxSamples)
                {
                    add(film, tile, new(first, Math.Min(samples.End, first + SampleAccumulator.MaxSamples)));
                }

                return add;
            },
            _ => { });
    }

    private Action<AovFilm, Tile, SampleRange> Worker(int pixels)
    {
        if (SeesThrough)
        {
            SeenThrough beyond = new(scene, _options.StreamSize, pixels);
            return (film, tile, samples) => beyond.Add(film, tile, samples);
        }

        FirstHits first = new(scene, _options.StreamSize, pixels);
        return (film, tile, samples) => first.Add(film, tile, samples);
    }
}
