using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// Renders into files beside the user's work: parts, and frames. What the view shows is rendered, as it is when the job starts.
/// </summary>
/// <param name="document">The document that is rendered.</param>
/// <param name="view">The samples, the region, the threads and the tone that the user wants.</param>
/// <param name="jobs">The list of what is being done.</param>
/// <param name="folders">The folders in which films of unfinished parts are kept.</param>
public sealed class BackgroundRenders(SceneDocument document, PictureView view, JobList jobs, UserFolders folders)
{
    private const int MostFrames = 10_000_000;
    private readonly ViewJobs _jobs = new(document, view, jobs);

    /// <summary>Renders one of several equal shares of the samples into a film.</summary>
    /// <param name="number">The part, from 1.</param>
    /// <param name="count">The number of parts.</param>
    /// <param name="path">The film; relative to the document's folder.</param>
    /// <param name="overwrite">True if files that are there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">There is no such part, or there is such a file.</exception>
    public int Part(int number, int count, string path, bool overwrite)
    {
        string full = _jobs.Whole(path);
        if (!FilmFile.IsNamed(full))
        {
            throw new SessionException("Parts are written to .rtfilm files.");
        }

        ViewportScene shown = view.RequireShown();
        int total = shown.Scene.Render.SamplesPerPixel;
        if (number < 1 || number > count || count > total)
        {
            throw new SessionException($"{total} samples make at most {total} parts, numbered from 1.");
        }

        FilmScene scene = FilmScene.Of(shown, shown.Camera, document.Place, full);
        RenderJob job = _jobs.Shown(full) with { Scene = scene.File, Text = null, Part = (number, count) };
        if (job.Frames is not null)
        {
            // Parts of a frame are given by their samples.
            job = job with { Part = null, Samples = new((int)((number - 1L) * total / count), (int)((long)number * total / count)) };
        }

        ViewJobs.Check(job, overwrite, scene.Text is null ? [] : [scene.File]);
        return _jobs.Start($"part {number} of {count}: {Path.GetFileName(full)}", watch =>
        {
            scene.Write();

            // What was rendered until the session ends is offered by the next one.
            using KeptFilm kept = new(folders, Path.GetFileName(full));
            JobResult result = watch.Require(new JobRun(job with { Checkpoint = kept.Path }, watch).Run(watch.Cancellation));
            kept.Delete();
            return $"wrote {full}, samples {result.RangeText} of {total}";
        });
    }

    /// <summary>
    /// Renders frames of the animation, each to its own file, or all into an animated PNG; those that are there and the same stay.
    /// </summary>
    /// <param name="first">The first.</param>
    /// <param name="last">The last.</param>
    /// <param name="pattern">The files, with signs # for the number; relative to the document's folder.</param>
    /// <param name="overwrite">True if files that are there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">There are no such frames, or there is such a file.</exception>
    /// <exception cref="JobException">Frames do not go together with the file.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public int Frames(int first, int last, string pattern, bool overwrite)
    {
        if (first < 0 || last < first || last >= MostFrames)
        {
            throw new SessionException($"Frames are numbered from 0 to {MostFrames - 1}, and the last is not before the first.");
        }

        string full = _jobs.Whole(pattern);
        if (VideoFile.IsNamed(full))
        {
            return Video(new(first, last, 1), full, overwrite);
        }

        RenderJob job = _jobs.Shown(full) with { Frames = new(first, last, 1) };
        ViewJobs.Check(job, overwrite);
        return _jobs.Start($"frames {first} to {last}", watch => Frames(job, watch), job.Frames!.Count);
    }

    /// <summary>Adds films of different samples of a picture up, into a film or an image.</summary>
    /// <param name="parts">The films' files.</param>
    /// <param name="path">The file to write; relative to the document's folder.</param>
    /// <param name="overwrite">True if a file that is there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">There are too few films, or there is such a file.</exception>
    /// <exception cref="JobException">They do not go together.</exception>
    /// <exception cref="Textures.PictureException">One cannot be read.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public int Merge(IReadOnlyList<string> parts, string path, bool overwrite)
    {
        string full = _jobs.Whole(path);
        if (parts.Count == 0)
        {
            throw new SessionException("Choose the films to merge.");
        }

        ImageWriteOptions writing = _jobs.Saved(full).Writing;
        ViewJobs.Check(new() { Scene = "", Outputs = [full] }, overwrite);
        FilmMerge merge = FilmMerge.Of([.. parts.Select(_jobs.Whole)]);
        if (merge.Missing is { } missing && !FilmFile.IsNamed(full))
        {
            throw new SessionException($"The picture is incomplete: {missing}. A film (.rtfilm) may lack some.");
        }

        return jobs.Start($"merging {parts.Count} films", (progress, cancellation) =>
        {
            Film film = merge.Add(progress, cancellation);
            SessionWatch watch = new(progress, 1, cancellation);
            JobFiles.Write(
                [full], film, merge.Header, writing.With(merge.Header.Tone) with { Metadata = PictureTexts.Of(merge.Header, film.ComputeHash()) }, watch);
            watch.RequireWritten();
            return $"wrote {full}, samples {merge.Header.SamplesText}{(merge.Missing is { } gaps ? $"; {gaps}" : "")}";
        });
    }

    private int Video(FrameRange frames, string path, bool overwrite)
    {
        string program = VideoFile.Program ?? throw new SessionException("Videos are made by ffmpeg, which is not found on this computer: install it, or render the frames as files.");
        if (!overwrite && File.Exists(path))
        {
            throw new SessionException($"The file '{path}' exists already.", SessionFault.Exists);
        }

        double rate = view.RequireShown().Description.Render.FramesPerSecond;
        string folder = path + VideoFile.FramesEnding;
        RenderJob job = _jobs.Shown(Path.Combine(folder, "#######.png")) with { Frames = frames };
        return _jobs.Start($"video {Path.GetFileName(path)}", watch =>
        {
            Directory.CreateDirectory(folder);
            Frames(job, watch);
            VideoFile.Make(program, folder, frames.First, rate, path, watch.Cancellation);
            Directory.Delete(folder, recursive: true);
            return $"wrote {path}, {frames.Count} frames";
        }, frames.Count);
    }

    private static string Frames(RenderJob job, SessionWatch watch)
    {
        FrameRun frames = new(job, watch);
        frames.Run(
            (one, run) =>
            {
                watch.Cancellation.ThrowIfCancellationRequested();
                return (watch.Require(run.Run(watch.Cancellation), one.Frame), true);
            },
            _ => watch.Next());
        watch.RequireWritten();
        string pattern = job.Outputs[0];
        int kept = frames.Done.Count(f => f.Result is null);
        string files = frames.Animations.Count > 0 ? pattern
            : $"{FrameRange.Name(pattern, job.Frames!.First)} to {Path.GetFileName(FrameRange.Name(pattern, job.Frames.Last))}";
        return $"wrote {frames.Done.Count - kept} frames, {files}{(kept > 0 ? $"; {kept} were there already" : "")}";
    }
}
