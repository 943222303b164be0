using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>The files that an image is written to.</summary>
public static class JobFiles
{
    // Between two writes to one file, on disks that know no locks.
    private static readonly TimeSpan LongestPause = TimeSpan.FromMinutes(1);

    /// <summary>Finds out before the work whether a file can be written after it.</summary>
    /// <exception cref="JobException">The extension is unknown.</exception>
    /// <exception cref="ImageWriteException">The folder is missing or closed to us, or has no room for another file.</exception>
    public static void Check(string path)
    {
        Check(path, isFilm: false);
        UnfinishedFilms.Check([path]);
    }

    /// <summary>As <see cref="Check(string)"/>, of a file that the film itself may be written to.</summary>
    /// <inheritdoc cref="Check(string)"/>
    public static void CheckFilm(string path) => Check(path, FilmFile.IsNamed(path), FilmFile.Extension);

    /// <summary>As <see cref="Check(string)"/>, whatever the extension.</summary>
    /// <inheritdoc cref="Check(string)"/>
    public static void CheckFolder(string path) => Check(path, isFilm: true);

    /// <summary>Finds out before the work whether a format has room for a picture.</summary>
    /// <exception cref="JobException">It has not.</exception>
    public static void CheckSize(IReadOnlyList<string> paths, ImageWriteOptions options, int width, int height)
    {
        if ((long)width * height > FilmExr.MaxPixels
            && paths.FirstOrDefault(p => !FilmFile.IsNamed(p) && options.TakesFilm(p)) is { } image)
        {
            throw new JobException(JobFault.Request, $"{image}: {FilmExr.TooLarge}, and the picture has {width}×{height}");
        }

        if (paths.FirstOrDefault(p => Math.Max(width, height) > ImageFormat.OfName(p)?.MaxSide) is { } small)
        {
            string limit = ImageFormat.OfName(small) is { } format ? $"{format.FileName} has at most {format.MaxSide} pixels a side" : "";
            throw new JobException(JobFault.Request, $"{small}: {limit}, and the picture has {width}×{height}");
        }
    }

    private static void Check(string path, bool isFilm, params string[] others)
    {
        AtomicFile.Check(path);
        try
        {
            if (!isFilm)
            {
                ImageFile.Check(path, others);
            }
        }
        catch (ImageWriteException e)
        {
            throw new JobException(JobFault.Request, e.Message.TrimEnd('.'));
        }

        AtomicFile.Sweep(path, DateTime.UtcNow - LongestPause);
        AtomicFile.Try(path);
    }

    /// <summary>Writes an image to several files; reports why those fail that cannot be written.</summary>
    /// <returns>Those that were written.</returns>
    public static IReadOnlyList<string> Write(IEnumerable<string> paths, IImageRows image, ImageWriteOptions options, IJobWatch watch) =>
        Each(paths, watch, path => ImageFile.Write(path, watch.Rows(image), options));

    /// <summary>Writes a film to a film file, or to an OpenEXR image that carries it.</summary>
    /// <param name="path">The file.</param>
    /// <param name="film">The film.</param>
    /// <param name="header">Its header in the file.</param>
    /// <param name="options">The details of writing an image; null for one with nothing but the film.</param>
    /// <exception cref="ImageWriteException">It cannot be written.</exception>
    public static void WriteFilm(string path, Film film, FilmHeader header, ImageWriteOptions? options = null)
    {
        if (FilmFile.IsNamed(path))
        {
            FilmFile.Write(path, film, header);
        }
        else
        {
            FilmExr.Write(path, film, header, options ?? new()
            {
                Metadata = PictureTexts.Of(header, film.ComputeHash()),
                Transparent = film.Planes.Contains(FilmPlane.Alpha),
            });
        }
    }

    /// <summary>
    /// Writes a film to the files that carry it, and its picture to the others; reports why those fail that cannot be written.
    /// </summary>
    /// <param name="paths">The files.</param>
    /// <param name="film">The film.</param>
    /// <param name="header">The header of the film; null where no file carries it.</param>
    /// <param name="options">The details of writing images.</param>
    /// <param name="watch">Takes failures.</param>
    /// <returns>Those that were written.</returns>
    public static IReadOnlyList<string> Write(IEnumerable<string> paths, Film film, FilmHeader? header, ImageWriteOptions options, IJobWatch watch) => Each(paths, watch, path =>
    {
        if (header is not null && options.TakesFilm(path))
        {
            WriteFilm(path, film, header, options);
        }
        else
        {
            (IImageRows image, ImageWriteOptions written) = TransparentRows.Of(watch.Rows(film), film, options);
            ImageFile.Write(path, image, written);
        }
    });

    private static List<string> Each(IEnumerable<string> paths, IJobWatch watch, Action<string> write)
    {
        List<string> written = [];
        foreach (string path in paths)
        {
            try
            {
                write(path);
                written.Add(path);
            }
            catch (ImageWriteException e)
            {
                watch.Fail(e.Message.TrimEnd('.'));
            }
        }

        return written;
    }
}
