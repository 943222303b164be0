using System.Diagnostics;

namespace RayTracer.Rendering;

/// <summary>
/// Renders samples of a picture in passes over all of its pixels, on several threads. Each pass doubles the samples, or takes a second, up
/// to 64 samples or 5 s. A thread that finds nothing left of a pass begins the next one, while others still work: it only waits before it
/// hands over samples of pixels that lack those of the pass before. So when the rendering is stopped, every pass but the last is complete
/// as soon as all threads have handed over what they have, and the last is taken back.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="options">The options of the computation.</param>
/// <param name="film">Takes the samples.</param>
/// <param name="cells">All cells.</param>
/// <param name="cut">Cuts a pass into pieces, of all pixels that have such samples.</param>
internal sealed class PassLoop(Scene scene, RenderOptions options, Film film, PassCell[] cells, Func<SampleRange, List<PassItem>> cut)
{
    // The seconds of a pass, where one sample a pixel does not take longer.
    private const double Longest = 5;
    private readonly Lock _beginning = new();
    private volatile Pass? _pass;
    private volatile Exception? _failure;
    private SampleRange _samples;
    private TimeSpan _longest = TimeSpan.FromSeconds(Longest);
    private long _began;
    private CancellationToken _cancellation;
    private IProgress<RenderProgress>? _progress;
    private long _pathsDone;
    private long _raysDone;
    private LightPass? _light;
    private bool _isStopped;

    /// <summary>The number of threads.</summary>
    public required int Threads { get; init; }

    /// <summary>The most pixels of a piece.</summary>
    public required int LargestItem { get; init; }

    /// <summary>All paths that there will be.</summary>
    public required long TotalPaths { get; init; }

    /// <summary>What was done before, for the progress.</summary>
    public RenderStatistics Before { get; init; } = new();

    /// <summary>Renders.</summary>
    /// <param name="samples">The samples.</param>
    /// <param name="progress">Takes how far the rendering is; may be null.</param>
    /// <param name="cancellation">Ends the rendering after the pieces under way.</param>
    public RenderStatistics Render(SampleRange samples, IProgress<RenderProgress>? progress, CancellationToken cancellation)
    {
        // What strategies bring is not taken back: the pass under way is finished.
        (_samples, _progress, _cancellation) = (samples, progress, options.Strategies is null ? cancellation : default);
        (_pathsDone, _raysDone) = (Before.Paths, Before.Rays);
        Wavefront?[] workers = new Wavefront?[Threads];
        long dropped = 0;
        try
        {
            _light = scene.Render.Integrator.Has(Description.IntegratorTraits.TracesLight) ? new(scene, options, Threads, (uint)scene.Render.Seed) { Recorded = options.Strategies } : null;
            while (_longest > TimeSpan.Zero && !_isStopped && Begin())
            {
                if (_light?.Trace(_pass!.Samples.First, _cancellation) != false)
                {
                    Run(workers);
                }

                if (!_pass!.IsTaken)
                {
                    dropped = Drop();
                    break;
                }

                _light?.Splats.Commit(film, _pass.Samples.First, options.Crop);
                _longest = options.AfterPass?.Invoke(_pass.Samples) ?? _longest;
                _isStopped = cancellation.IsCancellationRequested && _pass.Samples.End < _samples.End;
            }
        }
        finally
        {
            Array.ForEach(cells, cell => cell.Free());
            Array.ForEach(workers, worker => worker?.Close());
        }

        return Summarize([.. workers.OfType<Wavefront>()], dropped);
    }

    private RenderStatistics Summarize(Wavefront[] workers, long dropped) => new()
    {
        SamplesPerPixel = (_pass!.IsTaken ? _pass.Samples.End : _pass.Samples.First) - _samples.First,
        Paths = workers.Sum(w => w.Paths) - dropped,
        ClosestHitRays = workers.Sum(w => w.ClosestHitRays) + (_light?.Rays ?? 0),
        ShadowRays = workers.Sum(w => w.ShadowRays),
        NonFiniteSamples = workers.Sum(w => w.Accumulator.NonFinite) + (_light?.Splats.NonFinite ?? 0),
        ClampedSamples = workers.Sum(w => w.Accumulator.Clamped) + (_light?.Splats.Clamped ?? 0),
        BadSamples = [.. workers.SelectMany(w => w.Accumulator.Bad).Order().Take(RenderStatistics.MaxBadSamples)],
        Cancelled = !_pass.IsTaken || _isStopped,
    };

    // False where all samples are there.
    private bool Begin()
    {
        int first = _pass?.Samples.End ?? _samples.First;
        if (first >= _samples.End)
        {
            return false;
        }

        bool hasHalf = film.Planes.Contains(FilmPlane.Half);
        int end = _light is not null ? first + 1 : hasHalf ? FilmPlane.EndOfTurn(first) : _samples.End;
        SampleRange range = new(first, Math.Min(Math.Min(end, _samples.End), EndOfRay(first, first + NextCount(first - _samples.First))));
        PassItem[] items = [.. cut(range)];
        Array.ForEach(items, item => item.Plan());
        _pass = new(range, items, (_pass?.Number ?? 0) + 1, hasHalf && FilmPlane.IsOfHalf(first));
        _began = Stopwatch.GetTimestamp();
        return true;
    }

    // Samples that share a ray go together, as far as there is room for them.
    private int EndOfRay(int first, int end) =>
        scene.Splitting?.EndOf(end) is { } all && all - first <= SampleAccumulator.MaxSamples ? all : end;

    // As many samples as there are, or as take a moment: many short passes would cost time. Powers of two in all for as long as possible,
    // which low-discrepancy points like.
    private int NextCount(int done)
    {
        if (_pass is null)
        {
            return 1;
        }

        double seconds = double.Max(Stopwatch.GetElapsedTime(_began).TotalSeconds / _pass.Samples.Count, 1e-9);
        double wanted = double.Max(done, options.ShortestPass.TotalSeconds / seconds);
        int count = (int)double.Clamp(_longest.TotalSeconds / seconds, 1, double.Min(wanted, SampleAccumulator.MaxSamples));
        int total = 1 << int.Log2(done + count);
        return total > done ? total - done : 1 << int.Log2(count);
    }

    // Renders passes to the end, or one where somebody looks after each.
    private void Run(Wavefront?[] workers)
    {
        void Work(int i)
        {
            try
            {
                LightContributions? Observer() => options.Layers is { } layers ? new(scene, layers) : null;
                Render(workers[i] ??= new(scene, options.StreamSize, LargestItem, Observer(), _light, film.Planes, options.Clock));
            }
            catch (Exception e)
            {
                _failure = e;
            }
        }

        Thread[] others = [.. Enumerable.Range(1, workers.Length - 1).Select(i => new Thread(() => Work(i)) { IsBackground = true })];
        int started = 0;
        try
        {
            for (; started < others.Length; started++)
            {
                others[started].Start();
            }

            Work(0);
        }
        catch (Exception e) when (e is ThreadStartException or OutOfMemoryException)
        {
            // Too few threads can be had: nothing may go on writing to the film after this returns.
            _failure = e;
        }

        Array.ForEach(others[..started], t => t.Join());
        if (_failure is { } failure)
        {
            throw failure as RenderFailedException ?? new InvalidOperationException("Rendering failed.", failure);
        }
    }

    private void Render(Wavefront worker)
    {
        while (_failure is null && !_cancellation.IsCancellationRequested && Take(out Pass pass) is { } item)
        {
            long rays = worker.ClosestHitRays + worker.ShadowRays;
            if (Render(worker, pass, item))
            {
                Report(pass, item.Paths, worker.ClosestHitRays + worker.ShadowRays - rays);
            }
        }
    }

    // What is taken is handed over: so nothing may be taken after the rendering was stopped.
    private PassItem? Take(out Pass pass)
    {
        while (true)
        {
            pass = _pass!;
            if (pass.Take() is { } item)
            {
                return item;
            }

            lock (_beginning)
            {
                if (options.AfterPass is not null || _light is not null || (_pass == pass && (_cancellation.IsCancellationRequested || !Begin())))
                {
                    return null;
                }
            }
        }
    }

    private bool Render(Wavefront worker, Pass pass, PassItem item)
    {
        if (options.Layers is not null && !Await(item))
        {
            return false;
        }

        item.Follow(worker, film, (uint)scene.Render.Seed);
        if (!Await(item))
        {
            return false;
        }

        options.Clock?.Enter(Stage.Film);
        item.HandOver(worker, pass.IsOfHalf);
        options.Clock?.Enter(Stage.Rest);
        return true;
    }

    private bool Await(PassItem item)
    {
        if (!item.IsNext)
        {
            SpinWait.SpinUntil(() => item.IsNext || _failure is not null);
        }

        return _failure is null;
    }

    // Takes back what there is of the pass that was broken off.
    private long Drop()
    {
        long paths = 0;
        foreach (PassItem item in _pass!.Taken)
        {
            paths += item.Paths;
            item.TakeBack(film, _pass.IsOfHalf);
            if (options.Layers is { } layers)
            {
                item.TakeBack(layers);
            }
        }

        return paths;
    }

    private void Report(Pass pass, long paths, long rays)
    {
        long done = Interlocked.Add(ref _pathsDone, paths);
        long traced = Interlocked.Add(ref _raysDone, rays);
        int samples = pass.Samples.First - _samples.First;
        _progress?.Report(new(done, Math.Max(done, TotalPaths), traced) { Pass = pass.Number, SamplesDone = samples });
    }

    /// <summary>A pass.</summary>
    /// <param name="samples">The samples of pixels that have that many.</param>
    /// <param name="items">Its pieces.</param>
    /// <param name="number">Its number, from 1.</param>
    /// <param name="isOfHalf">True if the samples are of <see cref="FilmPlane.Half"/>, and the film has that.</param>
    private sealed class Pass(SampleRange samples, PassItem[] items, int number, bool isOfHalf)
    {
        private int _taken;

        public SampleRange Samples => samples;

        public int Number => number;

        public bool IsOfHalf => isOfHalf;

        public bool IsTaken => _taken >= items.Length;

        public ReadOnlySpan<PassItem> Taken => items.AsSpan(0, Math.Min(_taken, items.Length));

        public PassItem? Take() => Interlocked.Increment(ref _taken) is var taken && taken <= items.Length ? items[taken - 1] : null;
    }
}
