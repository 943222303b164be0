namespace RayTracer.Rendering;

/// <summary>
/// Renders scenes (the report's class of that name). Tiles of the picture are spread over threads; the film's exact sums make
/// the result the same to the bit however that is done.
/// </summary>
/// <param name="scene">What to render.</param>
/// <param name="options">How to compute it; null for the defaults.</param>
public sealed class RTracer(Scene scene, RenderOptions? options = null)
{
    private const int PathsPerTile = 16384;
    private const int SmallestTile = 8;
    private const int LargestTile = 64;
    private const int LargestStream = 65536;
    private readonly RenderOptions _options = options ?? new();

    /// <summary>Renders the whole picture into a new film.</summary>
    /// <param name="progress">Told how far the rendering is, from the rendering threads; may be null.</param>
    /// <param name="cancellation">Ends the rendering after the tiles under way.</param>
    public (Film Film, RenderStatistics Statistics) Render(IProgress<RenderProgress>? progress = null, CancellationToken cancellation = default)
    {
        Film film = new(scene.Render.Width, scene.Render.Height);
        return (film, Render(film, progress, cancellation));
    }

    /// <summary>Renders samples into a film, which may hold other samples of the same scene already.</summary>
    /// <param name="film">A film of the scene's size.</param>
    /// <param name="progress">Told how far the rendering is, from the rendering threads; may be null.</param>
    /// <param name="cancellation">Ends the rendering after the tiles under way; the film then holds whole samples of some pixels, and stays
    /// usable.</param>
    /// <exception cref="ArgumentException">The film's size is not the scene's, samples or crop lie outside the scene's, or an option is out
    /// of range.</exception>
    /// <exception cref="InvalidOperationException">A thread failed; the inner exception says why.</exception>
    public RenderStatistics Render(Film film, IProgress<RenderProgress>? progress = null, CancellationToken cancellation = default)
    {
        (Tile area, SampleRange samples) = Validate(film);
        int threads = _options.Threads > 0 ? _options.Threads : Environment.ProcessorCount;
        Tile[] tiles = Tile.Cut(area, TileEdge(area, samples, threads));
        Job job = new(film, tiles, samples, (long)area.Width * area.Height * samples.Count, progress, cancellation);
        Wavefront[] workers = new Wavefront[Math.Clamp(tiles.Length, 1, threads)];
        Exception? failure = null;
        void Run(int i)
        {
            try
            {
                workers[i] = new Wavefront(scene, _options.StreamSize, tiles.Max(t => t.Pixels), _options.Layers is { } layers ? new LightContributions(scene, layers) : null);
                job.Work(workers[i]);
            }
            catch (Exception e)
            {
                failure = e;
                job.Stop();
            }
        }

        Thread[] others = [.. Enumerable.Range(1, workers.Length - 1).Select(i => new Thread(() => Run(i)) { IsBackground = true })];
        int started = 0;
        try
        {
            for (; started < others.Length; started++)
            {
                others[started].Start();
            }

            Run(0);
        }
        catch (Exception e) when (e is ThreadStartException or OutOfMemoryException)
        {
            // Too few threads can be had: nothing may go on writing to the film after this returns.
            failure = e;
            job.Stop();
        }

        Array.ForEach(others[..started], t => t.Join());
        return failure is null ? Summarize(workers, job) : throw new InvalidOperationException("Rendering failed.", failure);
    }

    private static RenderStatistics Summarize(Wavefront[] workers, Job job) => new()
    {
        Paths = workers.Sum(w => w.Paths),
        ClosestHitRays = workers.Sum(w => w.ClosestHitRays),
        ShadowRays = workers.Sum(w => w.ShadowRays),
        NonFiniteSamples = workers.Sum(w => w.Accumulator.NonFinite),
        ClampedSamples = workers.Sum(w => w.Accumulator.Clamped),
        BadSamples = [.. workers.SelectMany(w => w.Accumulator.Bad).Order().Take(RenderStatistics.MaxBadSamples)],
        Cancelled = job.WasCancelled,
    };

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

    // Large enough that the streams run full most of the time, small enough that every thread has several tiles.
    private int TileEdge(Tile area, SampleRange samples, int threads)
    {
        if (_options.TileSize > 0)
        {
            return _options.TileSize;
        }

        double paths = BlockSize(samples);
        double share = (double)area.Width * area.Height / (8.0 * threads);
        double edge = double.Sqrt(Math.Min(PathsPerTile / paths, share));
        return Math.Clamp((int)edge, SmallestTile, LargestTile);
    }

    // The samples of a pixel in equal blocks that the accumulator can hold: a short last one would leave the streams empty.
    private static int BlockSize(SampleRange samples)
    {
        int blocks = ((samples.Count - 1) / SampleAccumulator.MaxSamples) + 1;
        return ((samples.Count - 1) / blocks) + 1;
    }

    /// <summary>The work that the threads share.</summary>
    private sealed class Job(
        Film film, Tile[] tiles, SampleRange samples, long totalPaths, IProgress<RenderProgress>? progress, CancellationToken cancellation)
    {
        private int _nextTile = -1;
        private long _pathsDone;
        private long _raysDone;
        private volatile bool _stopped;

        public bool WasCancelled { get; private set; }

        public void Stop() => _stopped = true;

        public void Work(Wavefront wavefront)
        {
            int blockSize = BlockSize(samples);
            int taken;
            while (!_stopped && (taken = Interlocked.Increment(ref _nextTile)) < tiles.Length)
            {
                for (int first = samples.First; first < samples.End; first += blockSize)
                {
                    if (cancellation.IsCancellationRequested)
                    {
                        WasCancelled = true;
                        return;
                    }

                    SampleRange block = new(first, Math.Min(samples.End, first + blockSize));
                    long raysBefore = wavefront.ClosestHitRays + wavefront.ShadowRays;
                    wavefront.Render(film, tiles[taken], block);
                    Report((long)tiles[taken].Pixels * block.Count, wavefront.ClosestHitRays + wavefront.ShadowRays - raysBefore);
                }
            }
        }

        private void Report(long paths, long rays)
        {
            long done = Interlocked.Add(ref _pathsDone, paths);
            long traced = Interlocked.Add(ref _raysDone, rays);
            progress?.Report(new(done, totalPaths, traced));
        }
    }
}
