using System.Collections.Concurrent;

namespace RayTracer.Rendering;

/// <summary>
/// Renders samples of single pixels, wherever they are, on several threads. It keeps what the threads need from one call to the next.
/// </summary>
/// <param name="scene">The scene to render.</param>
/// <param name="options">The options of the computation.</param>
internal sealed class PixelRenderer(Scene scene, RenderOptions options)
{
    /// <summary>The most pixels that are rendered together.</summary>
    public const int LargestList = 4096;

    private const int SmallestList = 64;
    private const int PathsPerList = 16384;
    private readonly ConcurrentStack<Wavefront> _idle = [];
    private LightPass? _light;
    private readonly int _threads = options.Threads > 0 ? options.Threads : Environment.ProcessorCount;

    /// <summary>Makes what sees the paths of a thread; null where nobody asks.</summary>
    public Func<PathObserver>? Observe { get; init; }

    /// <summary>The work that was done so far.</summary>
    public RenderStatistics Statistics => new()
    {
        Paths = _idle.Sum(w => w.Paths),
        ClosestHitRays = _idle.Sum(w => w.ClosestHitRays),
        ShadowRays = _idle.Sum(w => w.ShadowRays),
        NonFiniteSamples = _idle.Sum(w => w.Accumulator.NonFinite),
        ClampedSamples = _idle.Sum(w => w.Accumulator.Clamped),
        BadSamples = [.. _idle.SelectMany(w => w.Accumulator.Bad).Order().Take(RenderStatistics.MaxBadSamples)],
    };

    /// <summary>Returns how many of some pixels should be rendered together.</summary>
    /// <param name="pixels">The number of pixels.</param>
    /// <param name="samples">The samples of each.</param>
    /// <param name="threads">The number of threads.</param>
    public static int ListLength(int pixels, int samples, int threads) =>
        Math.Clamp(Math.Min(PathsPerList / samples, pixels / (8 * threads)), SmallestList, LargestList);

    /// <summary>Renders.</summary>
    /// <param name="film">Takes the samples.</param>
    /// <param name="pixels">The pixels' numbers in the picture, row by row.</param>
    /// <param name="targets">The place of each: numbers of pixels of the film, each at most once.</param>
    /// <param name="samples">Which samples of each.</param>
    /// <param name="seed">Selects the random numbers, in the place of the scene's seed.</param>
    /// <param name="report">Told, by the rendering threads, how many more paths and rays are done.</param>
    /// <param name="cancellation">Ends the work after the pixels under way.</param>
    /// <exception cref="OperationCanceledException">It was cancelled: some pixels have all the samples, others have none.</exception>
    public void Render(Film film, int[] pixels, int[] targets, SampleRange samples, uint seed, Action<long, long> report, CancellationToken cancellation)
    {
        if (!scene.Render.Integrator.Has(Description.IntegratorTraits.TracesLight))
        {
            RenderLists(film, pixels, targets, samples, seed, report, cancellation);
            return;
        }

        // Light comes sample by sample; its splats are the same for all pixels, however many camera samples they get.
        _light ??= new(scene, options, _threads, seed);
        for (int sample = samples.First; sample < samples.End && _light.Trace(sample, cancellation); sample++)
        {
            if (film.Planes.Contains(FilmPlane.Light))
            {
                AddSplats(film, pixels, targets, sample);
            }

            _light.Splats.Drop();
            RenderLists(film, pixels, targets, new(sample, sample + 1), seed, report, cancellation);
        }

        cancellation.ThrowIfCancellationRequested();
    }

    private void AddSplats(Film film, int[] pixels, int[] targets, int sample)
    {
        for (int i = 0; i < pixels.Length; i++)
        {
            long first = 3L * pixels[i];
            (int y, int x) = int.DivRem(targets[i], film.Width);
            film.AddLight(x, y, [_light!.Splats.Sum(first), _light.Splats.Sum(first + 1), _light.Splats.Sum(first + 2)], sample);
        }
    }

    private void RenderLists(Film film, int[] pixels, int[] targets, SampleRange samples, uint seed, Action<long, long> report, CancellationToken cancellation)
    {
        int length = ListLength(pixels.Length, samples.Count, _threads);
        int lists = ((pixels.Length - 1) / length) + 1;
        ParallelOptions parallel = new() { MaxDegreeOfParallelism = _threads, CancellationToken = cancellation };
        Parallel.For(0, lists, parallel, list =>
        {
            Wavefront worker = _idle.TryPop(out Wavefront? idle) ? idle : new(scene, options.StreamSize, LargestList, Observe?.Invoke(), _light);
            long paths = worker.Paths;
            long rays = worker.ClosestHitRays + worker.ShadowRays;
            int start = list * length;
            int count = Math.Min(length, pixels.Length - start);
            for (int first = samples.First; first < samples.End; first += SampleAccumulator.MaxSamples)
            {
                SampleRange block = new(first, Math.Min(samples.End, first + SampleAccumulator.MaxSamples));
                worker.Follow(film, pixels.AsSpan(start, count), targets.AsMemory(start, count), block, seed);
                worker.Accumulator.End();
            }

            report(worker.Paths - paths, worker.ClosestHitRays + worker.ShadowRays - rays);
            _idle.Push(worker);
        });
    }
}
