using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>Writes the picture as the command would write it, samples so far included.</summary>
/// <param name="document">What the picture is of.</param>
/// <param name="view">The picture.</param>
/// <param name="jobs">The list of what is being done.</param>
public sealed class PictureSaver(SceneDocument document, PictureView view, JobList jobs)
{
    private readonly ViewJobs _jobs = new(document, view, jobs);

    /// <summary>The formats of the files that are written: pictures, and the film itself.</summary>
    public static IReadOnlyList<PictureFormat> Formats => [.. ImageFormat.Written().Select(PictureFormat.Of), PictureFormat.Film];

    /// <summary>Writes the picture, or the film itself (.rtfilm), to a file, as a job.</summary>
    /// <param name="path">The file; relative to the document's folder.</param>
    /// <param name="request">The depth and the layers.</param>
    /// <param name="overwrite">True if a file that is there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">There is no picture, or there is such a file.</exception>
    /// <exception cref="JobException">What is requested does not go together with the file.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public async Task<int> Save(string path, PictureRequest request, bool overwrite)
    {
        string full = _jobs.Whole(path);
        bool isFilm = FilmFile.IsNamed(full);
        RenderJob job = Job(full, request);
        ViewJobs.Check(job, overwrite);
        TakenFilm taken = await Take(isFilm).ConfigureAwait(false);
        FilmScene? scene = isFilm ? SceneOf(taken.Order, full) : null;
        FilmHeader? header = scene is null ? null : Header(taken.Order, scene);
        ViewJobs.Check(job, overwrite, scene is { Text: not null } ? [scene.File] : []);
        return _jobs.Start($"writing {Path.GetFileName(full)}", watch =>
        {
            JobResult result = Result(taken, job, watch.Cancellation);
            result = header is null ? result
                : result with { Header = header with { Samples = [taken.Complete(watch.Cancellation)], Planes = taken.Film.Planes } };
            scene?.Write();
            new PictureFiles(job).Write(result, watch);
            watch.RequireWritten();
            return $"wrote {full}{(scene?.Text is null ? "" : $", and its scene beside it, {Path.GetFileName(scene.File)}")}";
        });
    }

    /// <summary>The picture as the bytes of a file.</summary>
    /// <param name="extension">The ending, with its dot, of one of the pictures' <see cref="Formats"/>.</param>
    /// <param name="request">The depth, and the layers of formats that hold them.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="SessionException">There is no picture.</exception>
    public async Task<byte[]> Encode(string extension, PictureRequest request, CancellationToken cancellation)
    {
        IReadOnlyList<AuxiliaryImage> layers = ImageFormat.Has(extension, ImageFeatures.Layers) ? request.Layers : [];
        RenderJob job = Job(Path.ChangeExtension(document.Place.Name, extension), request with { Layers = layers });
        TakenFilm taken = await Take(isFilm: false).ConfigureAwait(false);
        return await Task.Run(() =>
        {
            SessionWatch watch = new(new Progress<double>(), 1, cancellation);
            ImageWriteOptions options = new PictureFiles(job).Options(Result(taken, job, cancellation));
            return ImageFile.Encode(extension, watch.Rows(taken.Film), options);
        }, cancellation).ConfigureAwait(false);
    }

    /// <summary>The command that would render the picture.</summary>
    public string Command(string? output = null) => (_jobs.Saved(output) with { Denoise = view.Settings.Map == ViewMap.Denoised }).Command;

    private RenderJob Job(string output, PictureRequest request)
    {
        RenderJob job = _jobs.Saved(output);
        return job with { Aovs = request.Layers, Writing = job.Writing with { BitDepth = request.BitDepth } };
    }

    private Task<TakenFilm> Take(bool isFilm) =>
        view.Loop.ReadFilm((film, order, samples) => isFilm && samples == order.First && view.Loop.Rest is null
        ? throw new SessionException("The film holds no samples yet.", SessionFault.Missing)
        : TakenFilm.Of(film, order, samples, view.Loop.Rest));

    private static JobResult Result(TakenFilm taken, RenderJob job, CancellationToken cancellation)
    {
        RenderOrder order = taken.Order;
        AovFilm images = new(taken.Film, job.Aovs);
        new FirstHitPass(order.Scene, new() { Threads = order.Threads, Crop = order.Region }).Render(images, cancellation);
        RenderStatistics statistics = new() { Paths = taken.Film.TotalSamples, Cancelled = taken.Samples < order.Samples };
        return new(order.Scene, taken.Film, statistics, order.Threads, 0) { Samples = new(order.First, order.Samples), Auxiliary = images };
    }

    // What it was rendered from when it was begun, it is rendered from now.
    private FilmScene SceneOf(RenderOrder order, string path)
    {
        ViewportScene shown = view.RequireShown();
        return shown.Picture != order.Picture ? throw FilmScene.Changing()
            : order.Start?.Header is { } begun ? new(begun.Scene, null)
            : FilmScene.Of(shown, order.Camera, document.Place, path);
    }

    private FilmHeader Header(RenderOrder order, FilmScene scene) => new()
    {
        Width = order.Scene.Render.Width,
        Height = order.Scene.Render.Height,
        Content = PictureView.ContentOf(view.RequireShown().Good, order, document.Place.Folder),
        Samples = [],
        Wanted = new(order.First, order.Samples),
        Total = order.Scene.Render.SamplesPerPixel,
        Crop = order.Region,
        Scene = scene.File,
        Tone = PictureTone.Text(new ImageWriteOptions().For(order.Scene.Render)),
        Settings = order.Start?.Header is { } begun ? OldFilms.Settings(begun) : [],
        Software = ProgramName.Text,
    };
}
