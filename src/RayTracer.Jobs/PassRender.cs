using System.Diagnostics;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>
/// Renders the samples that a job lacks, and does between passes what there is to do: the film always holds whole ranges of samples then,
/// so that it can be written and shown, and the rendering can end for want of time.
/// </summary>
/// <param name="loaded">The loaded scene to render.</param>
/// <param name="films">The films to render into.</param>
/// <param name="watch">Is shown the film after each pass.</param>
internal sealed class PassRender(LoadedJob loaded, JobFilms films, IJobWatch watch)
{
    private readonly RenderJob _job = loaded.Job;
    private readonly long _start = Stopwatch.GetTimestamp();
    private readonly FilmHeader? _begun = loaded.Job.KeepsFilm ? loaded.Header() : null;
    private FilmHeader? _header;

    /// <summary>When to stop, after the pass under way, which is the first at least; null for no limit.</summary>
    public TimeSpan? Limit { get; init; }

    /// <summary>Takes the film now and then; may be null.</summary>
    public Checkpoints? Checkpoints { get; init; }

    // What is shown shall change.
    private TimeSpan LongestPass => TimeSpan.FromSeconds(watch.ShowsPasses ? 0.5 : 5);

    private bool HasWorkAfterPasses => Limit is not null || Checkpoints is not null || watch.ShowsPasses || films.Auxiliary.NeedsRays;

    /// <summary>Renders what is missing.</summary>
    /// <returns>The outcome; a pass that was cancelled does not count.</returns>
    /// <exception cref="JobException">The film to resume is of another picture, or an unfinished one would be written over.</exception>
    public JobResult Render(JobResult result)
    {
        if (_job.IsOfSequence && _begun is not null)
        {
            UnfinishedFilms.Check(_job.Outputs, replacement: _begun with { Samples = [loaded.Samples] });
        }

        SampleRange all = _job.Adaptive ? new(0, result.Plan!.Most) : loaded.Samples;
        SampleRange missing = new(_begun is { Samples: [.., var last] } ? last.End : all.First, all.End);
        AovFilm? auxiliary = Auxiliary(new(all.First, missing.First));
        RenderStatistics statistics = missing.Count > 0 ? Passes(missing, result.Plan) : new();
        SampleRange done = new(missing.First, missing.First + statistics.SamplesPerPixel);
        Keep(done);
        if (_header is not null && _job is { Time: not null, GivenSamples: null, Noise: null, Part: null, Samples: null })
        {
            // Nobody asked for more than there was time for.
            _header = AsAll(_header);
        }

        if (_header is { Samples.Count: > 0 })
        {
            Checkpoints?.Write(films.Film, _header);
        }

        return result with
        {
            Statistics = _job.Adaptive ? statistics : result.Counted(statistics),
            Samples = _job.Adaptive || _job.Pixel is not null ? null : new(all.First, done.End),
            Plan = _job.Adaptive ? result.Plan!.UpTo(done.End) : result.Plan,
            Denoising = _job.Denoise ? new(loaded.Scene, loaded.Options) : null,
            Header = _header,
            Checkpoints = Checkpoints,
            Auxiliary = auxiliary,
        };
    }

    private RenderStatistics Passes(SampleRange missing, SamplePlan? plan)
    {
        RenderOptions options = loaded.Options with
        {
            Samples = missing,
            AfterPass = HasWorkAfterPasses ? pass => AfterPass(pass, missing) : null,
        };
        return loaded.Textbook is { } textbook ? new TextbookRender(textbook, options).Render(films.Film, loaded.Progress, loaded.Cancellation)
            : _job.Adaptive
            ? new PlannedRender(loaded.Scene, options, plan!).Render(films.Film, loaded.Progress, loaded.Cancellation)
            : new RTracer(loaded.Scene, options).Render(films.Film, loaded.Progress, loaded.Cancellation);
    }

    // It takes little time, and without it the samples would be worth less: so it is not cancelled.
    private TimeSpan AfterPass(SampleRange pass, SampleRange missing)
    {
        // Pixels with more samples than most are seen as sharply as those.
        SampleRange seen = new(pass.First, Math.Min(pass.End, loaded.Samples.End));
        if (seen.Count > 0)
        {
            new FirstHitPass(loaded.Scene, loaded.Options with { Samples = seen }).Render(films.Auxiliary);
        }

        Keep(new(missing.First, pass.End));
        if (_header is not null)
        {
            Checkpoints?.Offer(films.Film, _header);
        }

        watch.Offer(films.Film, isLast: pass.End >= missing.End);
        return Limit - Stopwatch.GetElapsedTime(_start) is { } left && left < LongestPass ? left : LongestPass;
    }

    // Takes down which samples there are.
    private void Keep(SampleRange range)
    {
        if (_begun is not null)
        {
            _header = range.Count > 0 ? _begun with { Samples = FilmMerge.Join(_begun.Samples, range) } : _begun;
            _header = _job.IsOpenEnded ? AsAll(_header) : _header;
        }
    }

    // Those of the samples of a film that is resumed; a half of them is worth nothing.
    private AovFilm? Auxiliary(SampleRange held)
    {
        try
        {
            if (held.Count > 0)
            {
                new FirstHitPass(loaded.Scene, loaded.Options with { Samples = held }).Render(films.Auxiliary, loaded.Cancellation);
            }

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
}
