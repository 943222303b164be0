using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Follows the paths of a tile in stages: new rays are generated, all rays meet the scene, hits are sorted by what is shaded
/// together, every group is shaded (which samples the lights and sends the paths on), and finished paths go to the film.
/// Each thread has one. The report's recursion (listing 6.3) is this loop turned inside out.
/// </summary>
internal sealed unsafe class Wavefront
{
    private readonly Scene _scene;
    private readonly RayGenerator _generator;
    private readonly SurfaceShader _shader;
    private readonly SampleAccumulator _accumulator;
    private readonly FinishedPaths _finished;
    private readonly GroupMembers _members;
    private readonly PinnedBuffer<int> _hits;
    private readonly PathObserver? _observer;
    private PathStream _current;
    private PathStream _next;

    /// <summary>Makes one.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="streamSize">The number of paths that are followed together.</param>
    /// <param name="maxTilePixels">The most pixels of a tile.</param>
    /// <param name="observer">Sees what happens to the paths; null where nobody asks.</param>
    public Wavefront(Scene scene, int streamSize, int maxTilePixels, PathObserver? observer = null)
    {
        _scene = scene;
        _observer = observer;
        _current = new(streamSize);
        _next = new(streamSize);
        _generator = new(scene, maxTilePixels);
        _accumulator = new(maxTilePixels);
        _finished = new(scene, streamSize, _generator, _accumulator, observer);
        bool queues = !scene.World.IsPlain && scene.SampledLights.Count > 0 && !scene.TracksInteriors && !scene.WeakensShadows;
        _shader = scene.Render.Integrator.CreateShader(new(scene, _finished, queues ? new(scene, observer) : null, observer));
        _hits = new(scene.World.RoomForHits(streamSize));
        _members = new(scene, streamSize);
    }

    public SampleAccumulator Accumulator => _accumulator;

    public long Paths { get; private set; }

    public long ClosestHitRays { get; private set; }

    public long ShadowRays => _shader.ShadowRays;

    /// <summary>Follows the paths of some samples of every pixel of a tile; the accumulator has them then.</summary>
    /// <param name="film">The film that they are for.</param>
    /// <param name="tile">The pixels.</param>
    /// <param name="samples">The samples, at most <see cref="SampleAccumulator.MaxSamples"/>.</param>
    public void Follow(Film film, in Tile tile, SampleRange samples)
    {
        _accumulator.Begin(film, tile, samples.Count);
        Follow(tile, samples);
        Paths += (long)tile.Pixels * samples.Count;
    }

    /// <summary>Follows the paths of some samples of single pixels; the accumulator has them then.</summary>
    /// <param name="film">The film that they are for.</param>
    /// <param name="pixels">The pixels' numbers in the picture, row by row.</param>
    /// <param name="targets">Where each goes: numbers of pixels of the film.</param>
    /// <param name="samples">The samples, at most <see cref="SampleAccumulator.MaxSamples"/>.</param>
    /// <param name="seed">Selects the random numbers, in the place of the scene's seed.</param>
    public void Follow(Film film, ReadOnlySpan<int> pixels, ReadOnlyMemory<int> targets, SampleRange samples, uint seed)
    {
        _accumulator.BeginPixels(film, targets, samples.Count);
        _generator.Begin(pixels, samples, seed);
        Follow(samples);
        Paths += (long)pixels.Length * samples.Count;
    }

    /// <summary>Follows the paths of some samples of every pixel of a tile; an observer may take them from the film.</summary>
    public void Follow(in Tile tile, SampleRange samples)
    {
        _generator.Begin(tile, samples);
        _observer?.Begin(tile, samples);
        Follow(samples);
    }

    private void Follow(SampleRange samples)
    {
        _finished.Begin(samples);
        _shader.Begin(_generator, samples);
        _current.Count = 0;
        while (true)
        {
            _generator.Fill(_current);
            if (_current.Count == 0)
            {
                break;
            }

            _scene.World.ClosestHit(_current, _hits.Pointer);
            ClosestHitRays += _current.Count;
            _shader.SampleMedia(_current);
            _members.Sort(_current);
            Shade();
            _observer?.EndStep(_finished, _next);
            _finished.Drain();
            (_current, _next) = (_next, _current);
        }
    }

    private void Shade()
    {
        _next.Count = 0;
        for (int group = 0; group < _members.Count; group++)
        {
            uint* members = _members.Of(group, out int count);
            if (count == 0)
            {
                continue;
            }

            if (group == _scene.Groups.Length)
            {
                _shader.Miss(_current, members, count);
            }
            else if (group > _scene.Groups.Length)
            {
                _shader.Scatter(_current, _next, members, count);
            }
            else
            {
                _shader.Shade(_scene.Groups[group], _current, _next, members, count);
            }
        }

        _shader.Flush(_next);
    }
}
