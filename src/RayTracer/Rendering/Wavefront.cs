using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Follows the camera paths of a tile: rays are generated, followed in <see cref="Stages"/>, and finished paths go to the film. Each thread has
/// one.
/// </summary>
internal sealed unsafe class Wavefront
{
    private readonly RayGenerator _generator;
    private readonly SurfaceShader _shader;
    private readonly SampleAccumulator _accumulator;
    private readonly FinishedPaths _finished;
    private readonly Stages _stages;
    private readonly Action<PathStream> _afterStep;
    private readonly PathObserver? _observer;
    private readonly Backdrop? _backdrop;
    private readonly Wavefront? _alone;
    private Film? _unused;

    /// <summary>Makes one.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="streamSize">The number of paths that are followed together.</param>
    /// <param name="maxTilePixels">The most pixels of a tile.</param>
    /// <param name="observer">Sees what happens to the paths; null where nobody asks.</param>
    /// <param name="light">The light paths of the pass, where the integrator traces such.</param>
    /// <param name="planes">The planes of the films that it renders; null for none.</param>
    /// <param name="clock">Measures the stages; null where nobody looks.</param>
    public Wavefront(
        Scene scene, int streamSize, int maxTilePixels, PathObserver? observer = null, LightPass? light = null, IReadOnlyList<FilmPlane>? planes = null, StageClock? clock = null)
        : this(scene, streamSize, maxTilePixels, observer, light, clock, planes?.Contains(FilmPlane.Alpha) == true ? new() : null, withAll: null)
    {
        if (scene.MattesAlone is { } alone && planes?.Contains(FilmPlane.Matte) == true)
        {
            _alone = new(alone, streamSize, maxTilePixels, observer: null, light: null, clock, new(), withAll: this);
        }
    }

    private Wavefront(
        Scene scene, int streamSize, int maxTilePixels, PathObserver? observer, LightPass? light, StageClock? clock, Backdrop? backdrop, Wavefront? withAll)
    {
        streamSize = Math.Max(streamSize, scene.Splitting?.Ways ?? 1);
        _backdrop = backdrop;
        observer = PathObservers.Of(_backdrop, observer);
        _observer = observer;

        // An observer sees every sample by itself.
        _generator = new(scene, maxTilePixels, splits: observer is null);
        _accumulator = withAll?._accumulator ?? new(maxTilePixels);
        _finished = new(scene, streamSize, _generator, _accumulator, observer, _backdrop, withAll?._backdrop);
        bool queues = !scene.World.IsPlain && scene.SampledLights.Count > 0 && !scene.TracksInteriors && !scene.WeakensShadows;
        _shader = scene.Render.Integrator.CreateShader(new(scene, _finished, queues ? new(scene, PathObserver.OfLights(observer)) : null, observer, light) { Clock = clock });
        _stages = new(scene, streamSize, _shader, clock);
        _afterStep = next =>
        {
            _observer?.EndStep(_finished, next);
            _finished.Drain();
        };
    }

    public SampleAccumulator Accumulator => _accumulator;

    public long Paths { get; private set; }

    public long ClosestHitRays => _stages.Rays + (_alone?.ClosestHitRays ?? 0);

    public long ShadowRays => _shader.ShadowRays + (_alone?.ShadowRays ?? 0);

    /// <summary>Gives its memory back; it follows no more paths.</summary>
    public void Close()
    {
        _stages.Close();
        _alone?.Close();
    }

    /// <summary>Follows the paths of some samples of every pixel of a tile; the accumulator has them then.</summary>
    /// <param name="film">The film that they are for.</param>
    /// <param name="tile">The pixels.</param>
    /// <param name="samples">The samples, at most <see cref="SampleAccumulator.MaxSamples"/>.</param>
    public void Follow(Film film, in Tile tile, SampleRange samples)
    {
        _accumulator.Begin(film, tile, samples.Count);
        Follow(tile, samples);
        _alone?.Follow(tile, samples);
        Paths += (long)tile.Pixels * samples.Count;
    }

    /// <summary>Follows the paths of some samples of single pixels; the accumulator has them then.</summary>
    /// <param name="film">The film that they are for.</param>
    /// <param name="pixels">The pixels' numbers in the picture, row by row.</param>
    /// <param name="targets">The place of each: numbers of pixels of the film.</param>
    /// <param name="samples">The samples, at most <see cref="SampleAccumulator.MaxSamples"/>.</param>
    /// <param name="seed">Selects the random numbers, in the place of the scene's seed.</param>
    public void Follow(Film film, ReadOnlySpan<int> pixels, ReadOnlyMemory<int> targets, SampleRange samples, uint seed)
    {
        _accumulator.BeginPixels(film, targets, samples.Count);
        Follow(pixels, samples, seed);
        _alone?.Follow(pixels, samples, seed);
        Paths += (long)pixels.Length * samples.Count;
    }

    private void Follow(ReadOnlySpan<int> pixels, SampleRange samples, uint seed)
    {
        _backdrop?.Begin(pixels.Length * samples.Count);
        _generator.Begin(pixels, samples, seed);
        Follow(samples);
    }

    private void Follow(in Tile tile, SampleRange samples)
    {
        _backdrop?.Begin(tile.Pixels * samples.Count);
        _generator.Begin(tile, samples);
        _observer?.Begin(tile, samples);
        Follow(samples);
    }

    /// <summary>Follows the paths of some samples of every pixel of a tile for an observer alone.</summary>
    public void Observe(in Tile tile, SampleRange samples) => Follow(_unused ??= new(1, 1), tile, samples);

    private void Follow(SampleRange samples)
    {
        _finished.Begin(samples);
        _stages.Follow(_generator, samples, _afterStep);
        _finished.Drain();
    }
}
