using System.Diagnostics;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>
/// Renders samples in passes, each of some samples of every pixel, so that the film always holds whole ranges of samples: it can be written
/// at any
/// time, and ends well at a limit of time or a signal. The bits are those of one go.
/// </summary>
/// <param name="loaded">What to render.</param>
/// <param name="films">What to render into.</param>
/// <param name="watch">Is shown the film after each pass.</param>
internal sealed class PassRender(LoadedJob loaded, JobFilms films, IJobWatch watch)
{
    private const int MostSamples = 64;
    private readonly RenderJob _job = loaded.Job;
    private FilmHeader _header = loaded.Header();

    /// <summary>When to stop, after the pass under way, which is the first at least; null for no limit.</summary>
    public TimeSpan? Limit { get; init; }

    /// <summary>Takes the film now and then; may be null.</summary>
    public Checkpoints? Checkpoints { get; init; }

    // What is shown shall change.
    private double LongestPass => watch.ShowsPasses ? 0.5 : 5;

    /// <summary>Renders what is missing.</summary>
    /// <returns>The outcome; a pass that was cancelled does not count.</returns>
    /// <exception cref="JobException">The film to resume is of another picture, or an unfinished one would be written over.</exception>
    public JobResult Render(JobResult result)
    {
        if (_job.IsOfSequence)
        {
            UnfinishedFilms.Check(_job.Outputs, replacement: _header with { Samples = [loaded.Samples] });
        }

        RenderStatistics statistics = Passes();
        AovFilm? auxiliary = _header.Samples is [var done] ? Auxiliary(loaded.Options with { Samples = done }) : films.Auxiliary;
        if (_job is { Time: not null, GivenSamples: null, Noise: null, Part: null, Samples: null })
        {
            // Nobody asked for more than there was time for.
            _header = AsAll(_header);
        }

        return result with { Statistics = result.Counted(statistics), Header = _header, Checkpoints = Checkpoints, Auxiliary = auxiliary };
    }

    private RenderStatistics Passes()
    {
        SampleRange missing = new(_header.Samples is [.., var last] ? last.End : loaded.Samples.First, loaded.Samples.End);
        Film film = films.Film;
        Film pass = new(film.Width, film.Height, film.Planes);
        RenderStatistics statistics = new();
        long total = (long)(loaded.Options.Crop ?? new(0, 0, film.Width, film.Height)).Pixels * missing.Count;
        long start = Stopwatch.GetTimestamp();
        int count = 1;
        for (int first = missing.First; first < missing.End && !(first > missing.First && Stopwatch.GetElapsedTime(start) >= Limit);)
        {
            SampleRange range = new(first, Math.Min(missing.End, first + count));
            long passStart = Stopwatch.GetTimestamp();
            PassProgress shown = new(loaded.Progress, statistics, total);
            RenderStatistics done = new RTracer(loaded.Scene, loaded.Options with { Samples = range })
                .Render(pass, shown, loaded.Cancellation);
            if (done.Cancelled)
            {
                statistics = statistics with { Cancelled = true };
                break;
            }

            film.Merge(pass);
            pass.Clear();
            statistics += done;
            first = range.End;
            Keep(range, isLast: first >= missing.End);
            count = NextCount(Stopwatch.GetElapsedTime(passStart).TotalSeconds / range.Count, Limit - Stopwatch.GetElapsedTime(start));
        }

        if (_header.Samples.Count > 0)
        {
            Checkpoints?.Write(film, _header);
        }

        return statistics;
    }

    private void Keep(SampleRange range, bool isLast)
    {
        _header = _header with { Samples = FilmMerge.Join(_header.Samples, range) };
        _header = _job.IsOpenEnded ? AsAll(_header) : _header;
        Checkpoints?.Offer(films.Film, _header);
        watch.Offer(films.Film, isLast);
    }

    // Of the samples that passes came to, so not before them; a half of them is worth nothing.
    private AovFilm? Auxiliary(RenderOptions options)
    {
        try
        {
            loaded.Cancellation.ThrowIfCancellationRequested();
            new FirstHitPass(loaded.Scene, options).Render(films.Auxiliary, loaded.Cancellation);
            return films.Auxiliary;
        }
        catch (OperationCanceledException)
        {
            if (_job.Aovs.Count > 0)
            {
                watch.Warn("stopped before the auxiliary images (--aov) were made: they are left out");
            }

            return null;
        }
    }

    // What is said of a film that shall hold no more samples than it does.
    private static FilmHeader AsAll(FilmHeader header) =>
        header.Samples is [var all] ? header with { Wanted = all, Total = all.End } : header;

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
