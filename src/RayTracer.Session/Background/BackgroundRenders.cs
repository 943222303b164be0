using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>What is rendered into files beside the user's work, as jobs: parts, frames, layers of light. What the view shows is rendered, as it is when the job starts.</summary>
/// <param name="document">What is rendered.</param>
/// <param name="view">Knows the number of samples, the region and the threads that the user wants.</param>
/// <param name="jobs">Where the work goes on.</param>
public sealed class BackgroundRenders(SceneDocument document, PictureView view, JobList jobs)
{
    private const int MostFrames = 10_000_000;

    /// <summary>Renders one of several equal shares of the samples into a film.</summary>
    /// <param name="number">Which, from 1.</param>
    /// <param name="count">Of how many.</param>
    /// <param name="path">The film; relative to the document's folder.</param>
    /// <param name="overwrite">Whether files that are there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">There is no such part, or there is such a file.</exception>
    public int Part(int number, int count, string path, bool overwrite)
    {
        string full = Whole(path);
        if (!FilmFile.IsNamed(full))
        {
            throw new SessionException("Parts are written to .rtfilm files.");
        }

        RenderOrder order = Order(out ShownScene shown);
        int total = order.Scene.Render.SamplesPerPixel;
        if (number < 1 || number > count || count > total)
        {
            throw new SessionException($"{total} samples make at most {total} parts, numbered from 1.");
        }

        SampleRange share = Shares.Part(number, count, total);
        (FilmHeader header, string? scene) = FilmHeaders.Of(order, shown, document.Place, full);
        CheckFree(overwrite, scene is null ? [full] : [full, header.Scene]);
        return jobs.Start($"part {number} of {count}: {Path.GetFileName(full)}", (progress, cancellation) =>
        {
            Film film = Render(order.Scene, Options(order) with { Samples = share }, progress, cancellation);
            if (scene is not null)
            {
                SceneTextFile.Write(header.Scene, scene, "\n");
            }

            FilmFile.Write(full, film, header with { Samples = [share], Wanted = share });
            return $"wrote {full}, samples {FilmHeader.Text(share)} of {total}";
        });
    }

    /// <summary>Renders frames of the animation, each to its own file; those that are there and the same stay.</summary>
    /// <param name="first">The first.</param>
    /// <param name="last">The last.</param>
    /// <param name="pattern">The files, with signs # for the number; relative to the document's folder.</param>
    /// <param name="overwrite">Whether files that are there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">There are no such frames, or there is such a file.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public int Frames(int first, int last, string pattern, bool overwrite)
    {
        if (first < 0 || last < first || last >= MostFrames)
        {
            throw new SessionException($"Frames are numbered from 0 to {MostFrames - 1}, and the last is not before the first.");
        }

        string full = Whole(pattern);
        if (!Path.GetFileName(full).Contains('#', StringComparison.Ordinal) && first < last)
        {
            throw new SessionException("Each frame has its own file: mark its number's place in the name, as in frame-####.png.");
        }

        ShownScene shown = view.RequireShown();
        ViewSettings settings = new() { Region = view.Settings.Region, Threads = view.Settings.Threads, Samples = shown.Scene.Render.SamplesPerPixel };
        RenderJob job = ViewJob.Of(document.Place, shown.Description, settings, view.Tone, full) with
        {
            Scene = Path.GetFullPath(document.Place.Path ?? Path.Combine(document.Place.Folder, document.Place.Name)),
            Text = shown.Good.Text,
            Frames = new(first, last, 1),
        };
        if (JobRules.Complaint(job) is { } complaint)
        {
            throw new SessionException(complaint);
        }

        ImageFile.Check(FrameRange.Name(full, first));
        CheckFree(overwrite, job.Frames!.Numbers.Select(f => FrameRange.Name(full, f)));
        return jobs.Start($"frames {first} to {last}", (progress, cancellation) => Frames(job, full, progress, cancellation));
    }

    /// <summary>Adds films of different samples of a picture up, into a film or an image.</summary>
    /// <param name="parts">The films' files.</param>
    /// <param name="path">The file to write; relative to the document's folder.</param>
    /// <param name="overwrite">Whether a file that is there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">They do not go together, or there is such a file.</exception>
    /// <exception cref="Textures.PictureException">One cannot be read.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public int Merge(IReadOnlyList<string> parts, string path, bool overwrite)
    {
        string full = Whole(path);
        if (parts.Count == 0)
        {
            throw new SessionException("Choose the films to merge.");
        }

        if (!FilmFile.IsNamed(full))
        {
            ImageFile.Check(full);
        }

        CheckFree(overwrite, [full]);
        FilmMerge merge = FilmMerge.Of([.. parts.Select(Whole)]);
        if (merge.Missing is { } missing && !FilmFile.IsNamed(full))
        {
            throw new SessionException($"The picture is incomplete: {missing}. A film (.rtfilm) may lack some.");
        }

        return jobs.Start($"merging {parts.Count} films", (progress, cancellation) =>
        {
            Film film = merge.Add(progress, cancellation);
            FilmHeader header = merge.Header;
            if (FilmFile.IsNamed(full))
            {
                FilmFile.Write(full, film, header);
            }
            else
            {
                ImageFile.Write(full, film, new() { Exposure = view.Tone.Exposure, ToneMap = view.Tone.ToneMap, Metadata = PictureTexts.Of(header, film.ComputeHash()) });
            }

            return $"wrote {full}, samples {header.SamplesText}{(merge.Missing is { } gaps ? $"; {gaps}" : "")}";
        });
    }

    /// <summary>Renders a picture.</summary>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    internal static Film Render(Scene scene, RenderOptions options, IProgress<double> progress, CancellationToken cancellation, Film? film = null)
    {
        film ??= FilmBudget.Create(scene.Render.Width, scene.Render.Height);
        RenderStatistics done = new RTracer(scene, options).Render(film, new Fractions(progress), cancellation);
        return done.Cancelled ? throw new OperationCanceledException(cancellation) : film;
    }

    /// <summary>How an order is computed.</summary>
    internal static RenderOptions Options(RenderOrder order) => new() { Threads = order.Threads, Crop = order.Region };

    private static string Frames(RenderJob job, string pattern, IProgress<double> progress, CancellationToken cancellation)
    {
        JobWatch watch = new(progress, job.Frames!.Count);
        FrameRun frames = new(job, watch);
        frames.Run(
            (one, run) =>
            {
                cancellation.ThrowIfCancellationRequested();
                JobResult result = run.Run(cancellation) ?? throw new SessionException($"this is wrong at frame {one.Frame}: {watch.Errors[0]}");
                return result.Statistics.Cancelled ? throw new OperationCanceledException(cancellation)
                    : (result, result.IsWritten ? true : throw new SessionException(watch.Errors[0]));
            },
            _ => watch.Next());
        int kept = frames.Done.Count(f => f.Result is null);
        return $"wrote {frames.Done.Count - kept} frames, {FrameRange.Name(pattern, job.Frames.First)} to {Path.GetFileName(FrameRange.Name(pattern, job.Frames.Last))}"
            + (kept > 0 ? $"; {kept} were there already" : "");
    }

    private static void CheckFree(bool overwrite, IEnumerable<string> files)
    {
        if (!overwrite && files.FirstOrDefault(File.Exists) is { } file)
        {
            throw new SessionException($"The file '{file}' exists already.", SessionFault.Conflict);
        }
    }

    private RenderOrder Order(out ShownScene shown)
    {
        shown = view.RequireShown();
        ViewSettings settings = view.Settings;
        return new() { Scene = shown.Scene, Camera = shown.Camera, Picture = shown.Picture, Region = settings.Region, Threads = settings.Threads };
    }

    private string Whole(string path) => string.IsNullOrWhiteSpace(path) || path.Contains('\0', StringComparison.Ordinal)
        ? throw new SessionException("A file needs a name.")
        : Path.GetFullPath(path, Path.GetFullPath(document.Place.Folder is "" ? "." : document.Place.Folder));

    private sealed class Fractions(IProgress<double> progress) : IProgress<RenderProgress>
    {
        public void Report(RenderProgress value) => progress.Report(value.Fraction);
    }

    /// <summary>Reports how far several pictures are together.</summary>
    /// <param name="whole">Takes it.</param>
    /// <param name="count">How many there are.</param>
    private sealed class JobWatch(IProgress<double> whole, int count) : IJobWatch, IProgress<RenderProgress>
    {
        private int _done;

        public List<string> Errors { get; } = [];

        public void Warn(string message)
        {
        }

        public void Fail(string message) => Errors.Add(message);

        public void Read(IReadOnlyList<Diagnostic> diagnostics) => Errors.AddRange(diagnostics.Where(d => d.Severity == Severity.Error).Select(d => d.Message));

        public IProgress<RenderProgress> Begin() => this;

        public void Report(RenderProgress value) => whole.Report((_done + value.Fraction) / count);

        public void Next() => whole.Report((double)++_done / count);
    }
}
