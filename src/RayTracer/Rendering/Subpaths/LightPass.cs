using System.Collections.Concurrent;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// The light paths of a pass, which are those of one sample of the whole picture: of each pixel, or of one of 2ᵏ pixels. Their light in the picture and
/// their vertices are the same whatever part of the picture is rendered, and on any number of threads.
/// </summary>
internal sealed class LightPass
{
    // About the most light paths of a pass, which bounds the memory for their vertices.
    private const int MostPaths = 1 << 20;

    // 2ᵏ camera paths for each light path, where they are connected: where lights are in sight, a light path and its connections are worth less than the
    // camera paths that cost as much. Caustics want more light paths: measured between both.
    private const int RarityOfConnected = 1;

    // Knaus & Zwicker 2011, equation 15: how fast the circles shrink.
    private const double Alpha = 0.75;
    private const float FirstRadius = 1;
    private readonly Scene _scene;
    private readonly RenderOptions _options;
    private readonly int _threads;
    private readonly uint _seed;
    private readonly Strategies _strategies;
    private readonly Tile _area;
    private readonly int _rarity;
    private readonly float _firstRadius;
    private readonly LightInteriors? _interiors;

    // No bag: that keeps its things in variables of threads, and things that know the bag would keep it there for ever.
    private readonly ConcurrentStack<Worker> _idle = [];

    /// <summary>Prepares.</summary>
    /// <param name="scene">A scene whose integrator traces light.</param>
    /// <param name="options">The options of the computation.</param>
    /// <param name="threads">The number of threads.</param>
    /// <param name="seed">Selects the random numbers.</param>
    public LightPass(Scene scene, RenderOptions options, int threads, uint seed)
    {
        _strategies = ((LightTracingIntegrator)scene.Render.Integrator).Strategies;
        (_scene, _options, _threads, _seed) = (scene, options, threads, seed);
        _area = options.Crop ?? new(0, 0, scene.Render.Width, scene.Render.Height);
        Vertices = new(scene.Render.Width * scene.Render.Height);
        _rarity = Has(Strategies.Connections) ? RarityOfConnected : 0;
        while (Vertices.Paths >> _rarity > MostPaths)
        {
            _rarity++;
        }

        Splats = new(scene.Render.Width, scene.Render.Height) { Threads = threads };
        Emission = new(scene);
        _interiors = scene.TracksInteriors ? new(scene) : null;
        if (Has(Strategies.Merges))
        {
            Photons = new();
            _firstRadius = scene.Render.MergeRadius > 0 ? scene.Render.MergeRadius : FirstRadius * PixelFootprint.Median(scene);
        }
    }

    /// <summary>Takes what each path brings; null where nobody asks.</summary>
    public IArrivals? Recorded { get; init; }

    /// <summary>The constants of the weights.</summary>
    public PathWeights Weights { get; private set; } = new(1, 1, 0);

    /// <summary>How many light paths' vertices a merge takes in, for each unit of their density: N·πr².</summary>
    public float MergedPaths { get; private set; }

    /// <summary>The vertices of the paths.</summary>
    public LightVertices Vertices { get; }

    /// <summary>Finds those near a point; null where none are merged.</summary>
    public PhotonGrid? Photons { get; }

    /// <summary>The light that the paths bring to the picture.</summary>
    public SplatSums Splats { get; }

    /// <summary>Knows how likely a path starts from a light.</summary>
    public LightEmission Emission { get; }

    /// <summary>The rays of all passes, those to the camera included.</summary>
    public long Rays => _idle.Sum(w => w.Rays);

    /// <summary>Makes what tells <see cref="Recorded"/> of a thread's paths; null where nobody asks.</summary>
    public StrategyRecorder? Recorder() => Recorded is null ? null : new(_scene, Recorded);

    /// <summary>Traces the light of a sample.</summary>
    /// <param name="sample">The sample.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <returns>True if all of it was traced; else nothing may be used.</returns>
    public bool Trace(int sample, CancellationToken cancellation)
    {
        float radius = _firstRadius * (float)double.Sqrt(Shrunk(sample));
        int perLightPath = 1 << _rarity;
        MergedPaths = Vertices.Paths * float.Pi * radius * radius / perLightPath;
        Weights = new(Vertices.Paths, perLightPath, Has(Strategies.Merges | Strategies.Camera) ? radius : 0);
        ParallelLoopResult done = Parallel.For(0, Vertices.Blocks, new ParallelOptions { MaxDegreeOfParallelism = _threads }, (block, state) =>
        {
            if (cancellation.IsCancellationRequested)
            {
                state.Stop();
                return;
            }

            Worker worker = _idle.TryPop(out Worker? idle) ? idle : new(this);
            int first = block * LightVertices.BlockSize;
            worker.Follow(first, Math.Min(LightVertices.BlockSize, Vertices.Paths - first), sample);
            Vertices.SetBlock(block, worker.Vertices);
            _idle.Push(worker);
        });
        if (done.IsCompleted && (Has(Strategies.Connections) || Has(Strategies.Merges)))
        {
            Vertices.Join(_threads);
            Photons?.Build(Vertices, radius);
        }

        return done.IsCompleted;
    }

    /// <summary>Returns what follows a path once more, by its number in its pass and the number of the pass, and finds its light's number.</summary>
    /// <param name="observer">Sees what happens to it.</param>
    public Func<uint, int, int> Follower(PathObserver observer)
    {
        Worker worker = new(this, observer);
        return (path, sample) =>
        {
            observer.Begin(default, new(sample, sample + 1));
            worker.Follow((int)path, 1, sample);
            return worker.FirstLight;
        };
    }

    private bool Has(Strategies strategies) => (_strategies & strategies) == strategies;

    // The squared radius of a sample's circles over that of the first: of a sample's number alone, so that samples may come in any order.
    private static double Shrunk(int sample)
    {
        double factor = 1;
        for (int i = 1; i <= sample; i++)
        {
            factor *= (i + Alpha) / (i + 1);
        }

        return factor;
    }

    private sealed class Worker
    {
        private readonly LightPass _pass;
        private readonly LightStarts _starts;
        private readonly LightSubpaths _shader;
        private readonly Stages _stages;

        public Worker(LightPass pass, PathObserver? observer = null)
        {
            _pass = pass;
            _starts = new(pass._scene, pass._interiors is { } known ? new(known) : null);
            Strategies strategies = observer is null ? pass._strategies : Strategies.None;
            _shader = new(new(pass._scene, null!, null, observer), strategies, pass.Splats, pass._area, pass.Recorder());
            _stages = new(pass._scene, pass._options.StreamSize, _shader);
        }

        public long Rays => _stages.Rays + _shader.ShadowRays;

        public ReadOnlySpan<LightVertex> Vertices => _shader.Vertices;

        public unsafe int FirstLight => (int)_starts.Lights[0];

        public void Follow(int firstPath, int count, int sample)
        {
            _starts.Begin(firstPath, count, sample, _pass._rarity, _pass._seed);
            _shader.Begin(_starts, _pass.Weights);
            _stages.Follow(_starts, new(sample, sample + 1));
        }
    }
}
