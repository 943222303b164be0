using System.Diagnostics;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>
/// Renders samples in passes, each of some samples of every pixel, so that the film always holds whole ranges of samples: it can be written at any
/// time, and ends well at a limit of time or a signal. The bits are those of one go.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="options">How to compute it.</param>
/// <param name="header">What the film file says of the film before the first pass.</param>
/// <param name="watch">Is shown the film after each pass.</param>
internal sealed class PassRender(Scene scene, RenderOptions options, FilmHeader header, IJobWatch watch)
{
    private const int MostSamples = 64;

    /// <summary>What a file says of the film as it is.</summary>
    public FilmHeader Header { get; private set; } = header;

    /// <summary>When to stop, after the pass under way, which is the first at least; null for no limit.</summary>
    public TimeSpan? Limit { get; init; }

    /// <summary>Takes the film now and then; may be null.</summary>
    public Checkpoints? Checkpoints { get; init; }

    /// <summary>Whether the samples that there are count as all that were wanted, however many they come to.</summary>
    public bool IsOpenEnded { get; init; }

    // What is shown shall change.
    private double LongestPass => watch.ShowsPasses ? 0.5 : 5;

    /// <summary>What a film file says of a film that shall hold no more samples than it does.</summary>
    public static FilmHeader AsAll(FilmHeader header) => header.Samples is [var all] ? header with { Wanted = all, Total = all.End } : header;

    /// <summary>Renders what is missing.</summary>
    /// <returns>What was done; a pass that was cancelled does not count.</returns>
    public RenderStatistics Render(Film film, SampleRange missing, IProgress<RenderProgress>? progress, CancellationToken cancellation)
    {
        Film pass = new(film.Width, film.Height);
        RenderStatistics statistics = new();
        Tile area = options.Crop ?? new(0, 0, film.Width, film.Height);
        long start = Stopwatch.GetTimestamp();
        int count = 1;
        for (int first = missing.First; first < missing.End && !statistics.Cancelled && !(first > missing.First && Stopwatch.GetElapsedTime(start) >= Limit);)
        {
            SampleRange range = new(first, Math.Min(missing.End, first + count));
            long passStart = Stopwatch.GetTimestamp();
            PassProgress shown = new(progress, statistics, (long)area.Pixels * missing.Count);
            RenderStatistics done = new RTracer(scene, options with { Samples = range }).Render(pass, shown, cancellation);
            if (done.Cancelled)
            {
                statistics = statistics with { Cancelled = true };
                break;
            }

            film.Merge(pass);
            pass.Clear();
            statistics += done;
            first = range.End;
            Header = Header with { Samples = FilmMerge.Join(Header.Samples, range) };
            Header = IsOpenEnded ? AsAll(Header) : Header;
            Checkpoints?.Offer(film, Header);
            watch.Offer(film, isLast: first >= missing.End);
            count = NextCount(Stopwatch.GetElapsedTime(passStart).TotalSeconds / range.Count, Limit - Stopwatch.GetElapsedTime(start));
        }

        if (Header.Samples.Count > 0)
        {
            Checkpoints?.Write(film, Header);
        }

        return statistics;
    }

    private int NextCount(double secondsPerSample, TimeSpan? left)
    {
        double seconds = left is { } rest ? Math.Min(LongestPass, rest.TotalSeconds) : LongestPass;
        return (int)double.Clamp(seconds / Math.Max(1e-9, secondsPerSample), 1, MostSamples);
    }

    /// <summary>Shows a pass as a part of the whole.</summary>
    private sealed class PassProgress(IProgress<RenderProgress>? whole, RenderStatistics before, long total) : IProgress<RenderProgress>
    {
        public void Report(RenderProgress value) => whole?.Report(new(before.Paths + value.PathsDone, total, before.Rays + value.Rays));
    }
}
