using System.Collections.Concurrent;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>
/// Learns a guide before the picture, from samples that the picture never contains: they have a seed of their own, as those that decide on the
/// number of samples (<see cref="DecidingSamples"/>). Each pass has twice the samples of the one before, and is guided by what that learned
/// (Müller, Gross &amp; Novák 2017, section 3.3). What is learned depends on the scene alone.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="options">The options of the computation; crop and samples have no effect.</param>
internal sealed class GuideLearning(Scene scene, RenderOptions options)
{
    // Any number: it only has to make the seed another one.
    private const uint SeedChange = 0xBB67AE85u;
    private const int MostPixels = 1 << 16;
    private const int Passes = 6;

    // Of a mean sample.
    private const double Units = 1 << 20;

    // For a pass of one sample; for others, times the root of their number (Müller, Gross & Novák 2017, section 3.1).
    private const double MostRecords = 1000;
    private readonly Scene _scene = scene.Guided(null, scene.Render with { Sampler = SamplerKind.Sobol, SamplesPerPixel = 1 << Passes });
    private readonly uint _seed = Hash.Mix((uint)scene.Render.Seed ^ SeedChange);
    private RenderStatistics _statistics = new();

    /// <summary>The work that it took.</summary>
    public RenderStatistics Statistics => _statistics;

    /// <summary>The number of leaves of the tree over space.</summary>
    public int Leaves { get; private set; }

    /// <summary>Learns.</summary>
    /// <param name="progress">Told how far it is; may be null.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    public PathGuide Learn(IProgress<RenderProgress>? progress = null, CancellationToken cancellation = default)
    {
        int[] pixels = Pixels();
        ProgressSum done = new((long)pixels.Length << Passes, progress);
        ConcurrentBag<GuideRecorder> recorders = [];
        Film film = Render(_scene, pixels, new(0, 1), Noted(() => new(null, 0), recorders), done, cancellation);
        double mean = Enumerable.Range(0, pixels.Length).Select(i => film.Mean(i, 0)).Sum(m => (double)m.R + m.G + m.B) / (3.0 * pixels.Length);
        double units = mean > 0 ? Units / mean : 0;
        GuideSums sums = new(
            recorders.Aggregate(new Vector3(float.PositiveInfinity), (all, r) => Vector3.Min(all, r.Least)),
            recorders.Aggregate(new Vector3(float.NegativeInfinity), (all, r) => Vector3.Max(all, r.Most)));
        PathGuide? guide = null;
        for (int pass = 0; pass < Passes; pass++)
        {
            int samples = 1 << pass;
            sums = pass == 0 ? sums : sums.Refined(MostRecords * Math.Sqrt(samples / 2.0));
            Render(_scene.Guided(guide, _scene.Render), pixels, new(samples, 2 * samples), () => new GuideRecorder(sums, units), done, cancellation);
            guide = sums.ToGuide();
        }

        Leaves = sums.Leaves;
        return guide!;
    }

    private static Func<GuideRecorder> Noted(Func<GuideRecorder> make, ConcurrentBag<GuideRecorder> all) => () =>
    {
        GuideRecorder made = make();
        all.Add(made);
        return made;
    };

    private Film Render(
        Scene guided, int[] pixels, SampleRange samples, Func<PathObserver> observe, ProgressSum done, CancellationToken cancellation)
    {
        Film film = new(pixels.Length, 1);
        PixelRenderer renderer = new(guided, options) { Observe = observe };
        renderer.Render(film, pixels, [.. Enumerable.Range(0, pixels.Length)], samples, _seed, done.Add, cancellation);
        _statistics += renderer.Statistics;
        return film;
    }

    // All of a small picture; of a large one, one of each square, at random.
    private int[] Pixels()
    {
        (int width, int height) = (scene.Render.Width, scene.Render.Height);
        int edge = (int)Math.Ceiling(Math.Sqrt((double)width * height / MostPixels));
        return [.. Tile.Cut(new(0, 0, width, height), edge).Select(cell =>
        {
            int number = (cell.Y * width) + cell.X;
            (int x, int y) = cell.Pixel((int)(Hash.Mix((uint)number ^ _seed) % (uint)cell.Pixels));
            return (y * width) + x;
        })];
    }
}
