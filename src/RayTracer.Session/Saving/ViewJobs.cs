using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>
/// Jobs on what the view shows, which are carried out beside the user's work; their files are meant from the document's folder.
/// </summary>
/// <param name="document">The document that is rendered.</param>
/// <param name="view">The samples, the region, the threads and the tone that the user wants.</param>
/// <param name="jobs">The list of what is being done.</param>
internal sealed class ViewJobs(SceneDocument document, PictureView view, JobList jobs)
{
    /// <summary>Returns the whole path of a file.</summary>
    /// <exception cref="SessionException">It has no name.</exception>
    public string Whole(string path) => string.IsNullOrWhiteSpace(path) || path.Contains('\0', StringComparison.Ordinal)
        ? throw new SessionException("A file needs a name.")
        : Path.GetFullPath(path, Path.GetFullPath(document.Place.Folder is "" ? "." : document.Place.Folder));

    /// <summary>Returns the job that renders the document as it was saved last.</summary>
    /// <param name="output">The picture's file; null for one beside the scene's.</param>
    public RenderJob Saved(string? output)
    {
        string path = document.Place.Path ?? document.Place.Name;
        (ViewSettings settings, Tone? tone) = (view.Settings, view.GivenTone);
        bool hasOwnSamples = settings.Samples is { } samples && samples != document.Read.Description?.Render.SamplesPerPixel;
        return new()
        {
            Scene = path,
            Outputs = [output ?? Path.ChangeExtension(path, ".png")],
            Settings = hasOwnSamples ? [SceneSetting.Parse($"{RenderJob.SamplesPath}={settings.Samples}")] : [],
            Crop = settings.Region,
            Edition = settings.Edition,
            Threads = settings.Threads,
            Frames = view.Shown?.Good.Frame is { } frame ? new(frame, frame, 1) : null,
            Writing = tone?.Writing ?? new(),
        };
    }

    /// <summary>Returns the job that renders what is shown.</summary>
    public RenderJob Shown(string output) => Saved(output) with
    {
        Scene = Path.GetFullPath(document.Place.Path ?? Path.Combine(document.Place.Folder, document.Place.Name)),
        Text = view.RequireShown().Good.Text,
        IsOfSequence = true,
    };

    /// <summary>Finds out before the work whether a job makes sense, and whether its files can be written.</summary>
    /// <param name="job">The job.</param>
    /// <param name="overwrite">True if files that are there already may be replaced.</param>
    /// <param name="more">Other files that are written.</param>
    /// <exception cref="JobException">Its values do not go together, or a file has an unknown extension.</exception>
    /// <exception cref="SessionException">There is such a file.</exception>
    /// <exception cref="ImageWriteException">A file cannot be written there.</exception>
    public static void Check(RenderJob job, bool overwrite, params IEnumerable<string> more)
    {
        if (JobRules.Complaint(job) is { } complaint)
        {
            throw new JobException(JobFault.Request, complaint);
        }

        IReadOnlyList<string> files = job.Frames is { } frames
            ? [.. job.Outputs.SelectMany(o => frames.Numbers.Select(f => FrameRange.Name(o, f))).Distinct()]
            : new PictureFiles(job).All;
        foreach (string file in files.Where(f => !FrameFiles.IsAnimated(f, job.Frames)).DistinctBy(Path.GetExtension))
        {
            JobFiles.CheckFilm(file);
        }

        if (!overwrite && files.Concat(more).FirstOrDefault(File.Exists) is { } there)
        {
            throw new SessionException($"The file '{there}' exists already.", SessionFault.Exists);
        }
    }

    /// <summary>Starts to render a job of one picture.</summary>
    /// <param name="text">The action, in a few words.</param>
    /// <param name="job">The job.</param>
    /// <param name="report">Returns what is said at the end.</param>
    /// <returns>Its number in the list.</returns>
    public int Render(string text, RenderJob job, string report) => Start(text, watch =>
    {
        watch.Require(new JobRun(job, watch).Run(watch.Cancellation));
        return report;
    });

    /// <summary>Starts some work.</summary>
    /// <param name="text">The action, in a few words.</param>
    /// <param name="work">Does it, and returns what is said at the end.</param>
    /// <param name="pictures">The number of pictures that are rendered.</param>
    /// <returns>Its number in the list.</returns>
    public int Start(string text, Func<SessionWatch, string> work, int pictures = 1) =>
        jobs.Start(text, (progress, cancellation) => work(new(progress, pictures, cancellation)));
}
