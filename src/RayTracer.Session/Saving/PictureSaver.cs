using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>Writes the picture as the command would write it, samples so far included.</summary>
/// <param name="document">What the picture is of.</param>
/// <param name="view">The picture.</param>
/// <param name="jobs">Where the writing goes on.</param>
public sealed class PictureSaver(SceneDocument document, PictureView view, JobList jobs)
{
    /// <summary>The formats of the files that are written: pictures, and the film itself.</summary>
    public static IReadOnlyList<PictureFormat> Formats => [.. ImageFormat.Written().Select(PictureFormat.Of), PictureFormat.Film];

    /// <summary>Writes the picture, or the film itself (.rtfilm), to a file, as a job.</summary>
    /// <param name="path">The file; relative to the document's folder.</param>
    /// <param name="request">How.</param>
    /// <param name="overwrite">Whether a file that is there already may be replaced.</param>
    /// <returns>The job's number.</returns>
    /// <exception cref="SessionException">There is no picture, or there is such a file.</exception>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public async Task<int> Save(string path, PictureRequest request, bool overwrite)
    {
        if (string.IsNullOrWhiteSpace(path) || path.Contains('\0', StringComparison.Ordinal))
        {
            throw new SessionException("A picture needs a file name.");
        }

        string full = Path.GetFullPath(path, Path.GetFullPath(document.Place.Folder is "" ? "." : document.Place.Folder));
        if (FilmFile.IsNamed(full))
        {
            return await SaveFilm(full, overwrite).ConfigureAwait(false);
        }

        bool hasLayers = ImageFormat.Has(full, ImageFeatures.Layers);
        string[] beside = hasLayers ? [] : [.. request.Layers.Select(image => AovFiles.Beside(full, image.Name))];
        foreach (string file in beside.Prepend(full))
        {
            ImageFile.Check(file);
            CheckFree(file, overwrite);
        }

        Taken taken = await Take(full).ConfigureAwait(false);
        return jobs.Start($"writing {Path.GetFileName(full)}", (progress, cancellation) =>
        {
            AovFilm images = TraceLayers(taken, request, cancellation);
            ImageWriteOptions options = Options(taken, request);
            ReportedRows rows = new(taken.Film, progress, cancellation);
            ImageFile.Write(full, rows, hasLayers ? options with { ExrLayers = AovFiles.Layers(images) } : options);
            foreach (AuxiliaryImage kind in hasLayers ? [] : request.Layers)
            {
                (IImageRows image, string range) = AovFiles.Rows(full, images, kind);
                KeyValuePair<string, string>[] texts = [.. options.Metadata, new("Aov", kind.Name), new("Range", range)];
                ImageWriteOptions plain = options with { Metadata = texts, ToneMap = ToneMap.Clamp, Exposure = 0 };
                ImageFile.Write(AovFiles.Beside(full, kind.Name), image, plain);
            }

            return $"wrote {full}";
        });
    }

    /// <summary>The picture as the bytes of a file.</summary>
    /// <param name="extension">The ending, with its dot, of one of the pictures' <see cref="Formats"/>.</param>
    /// <param name="request">How; layers go into formats that hold them only.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="SessionException">There is no picture.</exception>
    public async Task<byte[]> Encode(string extension, PictureRequest request, CancellationToken cancellation)
    {
        Taken taken = await Take(Path.ChangeExtension(document.Place.Name, extension)).ConfigureAwait(false);
        return await Task.Run(() =>
        {
            ImageWriteOptions options = Options(taken, request);
            bool hasLayers = ImageFormat.Has(extension, ImageFeatures.Layers) && request.Layers.Count > 0;
            ReportedRows rows = new(taken.Film, new Progress<double>(), cancellation);
            return ImageFile.Encode(extension, rows, hasLayers ? options with { ExrLayers = AovFiles.Layers(TraceLayers(taken, request, cancellation)) } : options);
        }, cancellation).ConfigureAwait(false);
    }

    private static void CheckFree(string file, bool overwrite)
    {
        if (!overwrite && File.Exists(file))
        {
            throw new SessionException($"The file '{file}' exists already.", SessionFault.Conflict);
        }
    }

    private async Task<int> SaveFilm(string full, bool overwrite)
    {
        CheckFree(full, overwrite);
        TakenFilm taken = await view.Loop.Look((film, order, samples) => TakenFilm.Of(film, order, samples, view.Loop.Rest)).ConfigureAwait(false);
        (FilmHeader header, string? scene) = FilmHeaders.Of(taken.Order, view.RequireShown(), document.Place, full);
        string sceneFile = header.Scene;
        if (scene is not null)
        {
            CheckFree(sceneFile, overwrite);
        }

        return jobs.Start($"writing {Path.GetFileName(full)}", (_, cancellation) =>
        {
            SampleRange held = taken.Complete(cancellation);
            if (scene is not null)
            {
                SceneTextFile.Write(sceneFile, scene, "\n");
            }

            FilmFile.Write(full, taken.Film, header with { Samples = [held] });
            return $"wrote {full}{(scene is null ? "" : $", and its scene beside it, {Path.GetFileName(sceneFile)}")}";
        });
    }

    /// <summary>The command that would render the picture.</summary>
    public string Command(string? output = null) => Job(output).Command;

    private RenderJob Job(string? output) => ViewJob.Of(document.Place, document.Read.Description, view.Settings, view.Tone, output);

    // A copy, so that rendering goes on meanwhile.
    private async Task<Taken> Take(string output)
    {
        RenderJob job = Job(output);
        return await view.Loop.Look((film, order, samples) =>
        {
            Film copy = FilmBudget.Create(film.Width, film.Height);
            copy.Merge(film);
            return new Taken(copy, order, samples, job);
        }).ConfigureAwait(false);
    }

    private static AovFilm TraceLayers(Taken taken, PictureRequest request, CancellationToken cancellation)
    {
        AovFilm images = new(taken.Film, request.Layers);
        RenderOptions options = new() { Threads = taken.Order.Threads, Crop = taken.Order.Region };
        new FirstHitPass(taken.Order.Scene, options).Render(images, cancellation);
        return images;
    }

    private static ImageWriteOptions Options(Taken taken, PictureRequest request)
    {
        bool isWhole = taken.Samples >= taken.Order.Samples;
        string samples = $"{taken.Order.Samples}{(isWhole ? "" : $", unfinished: {taken.Film.TotalSamples} paths")}";
        return taken.Job.Writing with { BitDepth = request.BitDepth, Metadata = PictureTexts.Of(taken.Job, taken.Film.ComputeHash(), samples, null) };
    }

    private sealed record Taken(Film Film, RenderOrder Order, int Samples, RenderJob Job);
}
