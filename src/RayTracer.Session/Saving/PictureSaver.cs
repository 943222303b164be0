using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>Writes the picture as the command would write it, samples so far included.</summary>
/// <param name="document">The document that the picture shows.</param>
/// <param name="view">The picture.</param>
/// <param name="jobs">The list of what is being done.</param>
public sealed class PictureSaver(SceneDocument document, PictureView view, JobList jobs)
{
    private readonly ViewJobs _jobs = new(document, view, jobs);

    /// <summary>The picture whose file was written last, and its samples then.</summary>
    internal (long Picture, int Samples) Written { get; private set; } = (-1, 0);

    /// <summary>The formats of the files that are written: pictures, and the film itself.</summary>
    public static IReadOnlyList<PictureFormat> Formats => [.. ImageFormat.Written().Select(PictureFormat.Of), PictureFormat.Film];

    /// <summary>Returns the job whose file holds the picture, or the film itself (.rtfilm).</summary>
    /// <param name="output">The file; relative to the document's folder.</param>
    /// <param name="bitDepth">PNG: bits a channel; null for 8.</param>
    /// <param name="layers">The names of auxiliary images to write too: as layers of an OpenEXR file, else in files beside it.</param>
    /// <exception cref="SessionException">There are no such images or depths.</exception>
    public RenderJob Job(string output, int? bitDepth = null, params IEnumerable<string> layers) => Job(output, bitDepth, isTransparent: false, layers);

    /// <summary>The same, perhaps without what is behind everything, as <c>--transparent</c> writes it.</summary>
    public RenderJob Job(string output, int? bitDepth, bool isTransparent, IEnumerable<string> layers)
    {
        if (bitDepth is not (null or 8 or 16))
        {
            throw new SessionException("A PNG is written with 8 or 16 bits per channel.");
        }

        if (isTransparent && !ImageFormat.Has(Path.GetExtension(output), ImageFeatures.Alpha))
        {
            throw new SessionException($"A picture has its background in a file of that kind: write {ImageFormat.Names(ImageFeatures.Alpha)}.");
        }

        RenderJob job = _jobs.Saved(output);
        return job with
        {
            Outputs = [output],
            Aovs = [.. layers.Select(name => AuxiliaryImage.Known.Find(name) ?? throw new SessionException($"There is no layer {name}."))],
            Writing = job.Writing with { BitDepth = bitDepth ?? 8, Transparent = isTransparent },
        };
    }

    /// <summary>
    /// Writes the picture so far to the file of its job, beside the user's work. Where another camera than the scene's is looked through, or
    /// something is hidden, the job is rendered, with the scene's camera and all things; so it is where the background is
    /// left out.
    /// </summary>
    /// <param name="job">The job.</param>
    /// <param name="overwrite">True if a file that is there already may be replaced.</param>
    /// <param name="asSeen">True to write what is seen all the same.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">There is no picture, or there is such a file.</exception>
    /// <exception cref="JobException">What is requested does not go together with the file.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public async Task<int> Save(RenderJob job, bool overwrite, bool asSeen = false)
    {
        string full = _jobs.Whole(job.Outputs[0]);
        bool isFilm = FilmFile.IsNamed(full);
        job = job with { Outputs = [full] };
        ViewJobs.Check(job, overwrite);
        bool isWhole = view.IsSceneCamera && view.IsWhole;
        if (asSeen && !isWhole && job.Writing.Transparent)
        {
            throw new SessionException("Your view is written with its background: set the scene's camera to it, or write what that sees.");
        }

        // The film on the screen does not know what of its light is from behind everything.
        if (job.Writing.Transparent || !(asSeen || isWhole))
        {
            RenderJob shown = _jobs.Shown(full);
            return _jobs.Render($"rendering {Path.GetFileName(full)}", job with { Scene = shown.Scene, Text = shown.Text, IsOfSequence = shown.IsOfSequence }, $"wrote {full}");
        }

        TakenFilm taken = await Take(isFilm).ConfigureAwait(false);
        FilmScene? scene = isFilm ? SceneOf(taken.Shown, full) : null;
        FilmHeader? header = scene is null ? null : Header(taken.Shown, scene);
        ViewJobs.Check(job, overwrite, scene is { Text: not null } ? [scene.File] : []);
        return _jobs.Start($"writing {Path.GetFileName(full)}", watch =>
        {
            JobResult result = Result(taken, job, watch.Cancellation);
            result = header is null ? result
                : result with { Header = header with { Samples = [taken.Complete(watch.Cancellation)], Planes = taken.Film.KeptPlanes } };
            scene?.Write();
            new PictureFiles(job).Write(result, watch);
            watch.RequireWritten();
            Written = (taken.Shown.Picture, taken.Samples);
            return $"wrote {full}{(scene?.Text is null ? "" : $", and its scene beside it, {Path.GetFileName(scene.File)}")}";
        });
    }

    /// <summary>Writes the film so far, and its scene beside it where that is in no file.</summary>
    /// <param name="path">The film's whole path.</param>
    /// <exception cref="SessionException">There is no picture, or it is changing.</exception>
    internal async Task WriteFilm(string path)
    {
        TakenFilm taken = await Take(isFilm: true).ConfigureAwait(false);
        FilmScene scene = SceneOf(taken.Shown, path);
        FilmHeader header = Header(taken.Shown, scene) with { Samples = [taken.Complete(CancellationToken.None)], Planes = taken.Film.KeptPlanes };
        scene.Write();
        JobFiles.WriteFilm(path, taken.Film, header);
    }

    /// <summary>Returns the picture so far as the bytes of its job's file, with layers where that has them.</summary>
    /// <exception cref="SessionException">There is no picture.</exception>
    public async Task<byte[]> Encode(RenderJob job, CancellationToken cancellation)
    {
        string extension = Path.GetExtension(job.Outputs[0]);
        job = ImageFormat.Has(extension, ImageFeatures.Layers) ? job : job with { Aovs = [] };
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

    private Task<TakenFilm> Take(bool isFilm) =>
        view.Loop.ReadFilm((film, shown, samples) => isFilm && samples == shown.First && view.Loop.Rest is null
        ? throw new SessionException("The film holds no samples yet.", SessionFault.Missing)
        : TakenFilm.Of(film, shown, samples, view.Loop.Rest));

    private static JobResult Result(TakenFilm taken, RenderJob job, CancellationToken cancellation)
    {
        ViewportScene shown = taken.Shown;
        int threads = shown.Settings.Threads;
        AovFilm images = new(taken.Film, job.Aovs);
        new FirstHitPass(shown.Scene, new() { Threads = threads, Crop = shown.Settings.Region }).Render(images, cancellation);
        RenderStatistics statistics = new() { Paths = taken.Film.TotalSamples, Cancelled = taken.Samples < shown.Samples };
        return new(shown.Scene, taken.Film, statistics, threads, 0) { Samples = new(shown.First, shown.Samples), Auxiliary = images };
    }

    // What it was rendered from when it was begun, it is rendered from now.
    private FilmScene SceneOf(ViewportScene taken, string path)
    {
        ViewportScene shown = view.RequireShown();
        return taken.Good.Hidden.Count > 0 ? throw new SessionException("A film is of the whole scene: show all things, or write a picture.")
            : shown.Picture != taken.Picture ? throw FilmScene.Changing()
            : taken.Start?.Header is { } begun ? new(begun.Scene, null)
            : FilmScene.Of(shown, taken.Camera, document.Place, path);
    }

    private static RenderJob FrameOf(ViewportScene taken) =>
        new() { Scene = "", Edition = taken.Settings.Edition, Frames = taken.Good.Frame is { } frame ? new(frame, frame, 1) : null };

    private FilmHeader Header(ViewportScene taken, FilmScene scene) => new()
    {
        Width = taken.Scene.Render.Width,
        Height = taken.Scene.Render.Height,
        Content = PictureView.ContentOf(taken, document.Place.Folder),
        Samples = [],
        Wanted = new(taken.First, taken.Samples),
        Total = taken.Scene.Render.SamplesPerPixel,
        Crop = taken.Settings.Region,
        Scene = scene.File,
        Tone = PictureTone.Text(new ImageWriteOptions().For(taken.Scene.Render)),
        Settings = taken.Start?.Header is { } begun ? OldFilms.Settings(begun) : FrameOf(taken).FilmSettings,
        Software = ProgramName.Text + Edition.Software(taken.Settings.Edition, taken.Description),
    };
}

/// <summary>A format of files that pictures are written to.</summary>
/// <param name="Value">The ending of names, without its dot.</param>
/// <param name="Label">The name that is shown.</param>
/// <param name="HasDepth">True if bits a channel can be chosen.</param>
/// <param name="HasLayers">True if it takes auxiliary images.</param>
/// <param name="HasAlpha">True if what is behind everything can be left out.</param>
/// <param name="IsFilm">True if it is the film itself, which is only written to files.</param>
public sealed record PictureFormat(string Value, string Label, bool HasDepth, bool HasLayers, bool HasAlpha, bool IsFilm)
{
    /// <summary>The film itself.</summary>
    public static PictureFormat Film { get; } =
        new(FilmFile.Extension[1..], SessionTexts.Of("formats.rtfilm"), HasDepth: false, HasLayers: false, HasAlpha: false, IsFilm: true);

    /// <summary>Returns a format of pictures as it is offered.</summary>
    public static PictureFormat Of(ImageFormat format) => new(
        format.Extensions[0][1..],
        format.Name,
        format.Features.HasFlag(ImageFeatures.BitDepth),
        format.Features.HasFlag(ImageFeatures.Layers),
        format.Features.HasFlag(ImageFeatures.Alpha),
        IsFilm: false);
}
