namespace RayTracer.Rendering;

/// <summary>
/// Renders scenes (the report's class of that name), in passes over the whole picture: of one sample of each pixel at first, then of as
/// many as there are. Tiles are spread over threads; the film's exact sums make the result the same to the bit however that is done.
/// </summary>
/// <param name="scene">The scene to render.</param>
/// <param name="options">The options of the computation; null for the defaults.</param>
public sealed class RTracer(Scene scene, RenderOptions? options = null)
{
    /// <summary>The longest edge of a tile.</summary>
    internal const int LargestTile = 64;

    private const int PathsPerTile = 16384;
    private const int SmallestTile = 8;
    private const int LargestStream = 65536;
    private readonly RenderOptions _options = options ?? new();

    /// <summary>Renders the whole picture into a new film.</summary>
    /// <param name="progress">Takes how far the rendering is, from the rendering threads; may be null.</param>
    /// <param name="cancellation">Ends the rendering after the tiles under way, with the passes that are complete.</param>
    public (Film Film, RenderStatistics Statistics) Render(IProgress<RenderProgress>? progress = null, CancellationToken cancellation = default)
    {
        Film film = new(scene.Render.Width, scene.Render.Height, FilmPlane.Needed(scene.Render.Integrator));
        return (film, Render(film, progress, cancellation));
    }

    /// <summary>Renders samples into a film, which may hold other samples of the same scene already.</summary>
    /// <param name="film">A film of the scene's size.</param>
    /// <param name="progress">Takes how far the rendering is, from the rendering threads; may be null.</param>
    /// <param name="cancellation">Ends the rendering after the tiles under way. The film has the samples of all complete passes then
    /// (<see cref="RenderStatistics.SamplesPerPixel"/>), and nothing of the one that was broken off.</param>
    /// <exception cref="ArgumentException">The film's size is not the scene's, samples or crop lie outside the scene's, or an option is out
    /// of range.</exception>
    /// <exception cref="InvalidOperationException">A thread failed; the inner exception says why, and a <see cref="RenderFailedException"/> where. The film is of
    /// no use then.</exception>
    public RenderStatistics Render(Film film, IProgress<RenderProgress>? progress = null, CancellationToken cancellation = default)
    {
        (Tile area, SampleRange samples) = Validate(film);
        int threads = _options.Threads > 0 ? _options.Threads : Environment.ProcessorCount;
        PassCell[] cells = Array.ConvertAll(Tile.Cut(area, LargestTile), tile => new PassCell(tile));
        List<PassItem> Cut(SampleRange pass)
        {
            List<PassItem> items = [];
            int edge = TileEdge(area, pass.Count, threads);
            Array.ForEach(cells, cell => Array.ForEach(Tile.Cut(cell.Area, edge), tile => items.Add(new(cell, tile, default, pass))));
            return items;
        }

        int least = Tile.Cut(area, _options.TileSize > 0 ? _options.TileSize : SmallestTile).Length;
        PassLoop loop = new(scene, _options, film, cells, Cut)
        {
            Threads = Math.Min(threads, least),
            LargestItem = Math.Min(area.Pixels, LargestTile * LargestTile),
            TotalPaths = (long)area.Pixels * samples.Count,
        };
        return loop.Render(samples, progress, cancellation);
    }

    private (Tile Area, SampleRange Samples) Validate(Film film)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(_options.Threads, nameof(RenderOptions.Threads));
        ArgumentOutOfRangeException.ThrowIfNegative(_options.TileSize, nameof(RenderOptions.TileSize));
        ArgumentOutOfRangeException.ThrowIfGreaterThan(_options.TileSize, LargestTile, nameof(RenderOptions.TileSize));
        ArgumentOutOfRangeException.ThrowIfLessThan(_options.StreamSize, 1, nameof(RenderOptions.StreamSize));
        ArgumentOutOfRangeException.ThrowIfGreaterThan(_options.StreamSize, LargestStream, nameof(RenderOptions.StreamSize));
        (int width, int height) = (scene.Render.Width, scene.Render.Height);
        if (film.Width != width || film.Height != height)
        {
            throw new ArgumentException($"The film has {film.Width}×{film.Height} pixels, but the scene {width}×{height}.", nameof(film));
        }

        Tile area = _options.Crop ?? new(0, 0, width, height);
        if (area.X < 0 || area.Y < 0 || area.Width < 1 || area.Height < 1 || area.X > width - area.Width || area.Y > height - area.Height)
        {
            throw new ArgumentException($"The crop {area.X},{area.Y},{area.Width},{area.Height} does not lie within {width}×{height} pixels.");
        }

        SampleRange samples = _options.Samples ?? new(0, scene.Render.SamplesPerPixel);
        if (samples.First < 0 || samples.Count < 1 || samples.End > scene.Render.SamplesPerPixel)
        {
            throw new ArgumentException($"Samples {samples.First} to {samples.End - 1} are not within the scene's {scene.Render.SamplesPerPixel}.");
        }

        return (area, samples);
    }

    // Large enough that the streams run full most of the time, small enough that every thread has several tiles, unless the pass is short:
    // then threads that find no tile begin the next.
    private int TileEdge(Tile area, int samples, int threads)
    {
        if (_options.TileSize > 0)
        {
            return _options.TileSize;
        }

        double share = (double)area.Width * area.Height / (8.0 * threads);
        double most = Math.Max(_options.StreamSize, PathsPerTile);
        double pixels = Math.Clamp(share, (double)_options.StreamSize / samples, most / samples);
        return Math.Clamp((int)double.Sqrt(pixels), SmallestTile, LargestTile);
    }
}
