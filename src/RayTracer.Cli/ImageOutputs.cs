using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>The files that an image is written to.</summary>
internal static class ImageOutputs
{
    // Between two writes to one file, on disks that know no locks.
    private static readonly TimeSpan LongestPause = TimeSpan.FromMinutes(1);

    /// <summary>Finds out before the work whether a file can be written after it.</summary>
    /// <exception cref="CommandException">The extension is unknown.</exception>
    /// <exception cref="ImageWriteException">The folder is missing or closed to us, or has no room for another file.</exception>
    public static void Check(string path) => Check(path, isFilm: false);

    /// <summary>As <see cref="Check(string)"/>, of a file that the film itself may be written to.</summary>
    /// <inheritdoc cref="Check(string)"/>
    public static void CheckFilm(string path) => Check(path, FilmFile.IsNamed(path));

    /// <summary>As <see cref="Check(string)"/>, whatever the extension.</summary>
    /// <inheritdoc cref="Check(string)"/>
    public static void CheckFolder(string path) => Check(path, isFilm: true);

    /// <summary>Finds out before the work whether a format has room for a picture.</summary>
    /// <exception cref="CommandException">It has not.</exception>
    public static void CheckSize(IReadOnlyList<string> paths, ImageWriteOptions options, int width, int height)
    {
        if ((long)width * height > FilmExr.MaxPixels && paths.FirstOrDefault(p => !FilmFile.IsNamed(p) && options.TakesFilm(p)) is { } image)
        {
            throw new CommandException(ExitStatus.Usage, $"{image}: {FilmExr.TooLarge}, and the picture has {width}×{height}");
        }

        if (paths.FirstOrDefault(p => Math.Max(width, height) > ImageFormat.OfName(p)?.MaxSide) is { } small)
        {
            string limit = ImageFormat.OfName(small) is { } format ? $"{format.FileName} has at most {format.MaxSide} pixels a side" : "";
            throw new CommandException(ExitStatus.Usage, $"{small}: {limit}, and the picture has {width}×{height}");
        }
    }

    /// <summary>Keeps films of unfinished renderings from being written over.</summary>
    /// <param name="paths">The files to write.</param>
    /// <param name="own">A film that may be replaced, for it is gone on with; null for none.</param>
    /// <param name="replacement">What is going to be written; null where that is not known yet. Films all of whose samples are in it may be replaced.</param>
    /// <exception cref="CommandException">There is one; the message says what to do with it.</exception>
    public static void CheckUnfinished(IEnumerable<string> paths, string? own = null, FilmHeader? replacement = null)
    {
        foreach (string path in paths.Where(p => CarriedFilm.Is(p) && (own is null || Path.GetFullPath(p) != Path.GetFullPath(own))))
        {
            if (CarriedFilm.Unfinished(path) is { } unfinished && !IsWithin(unfinished, replacement))
            {
                string how = unfinished.Samples is [var held] && held.First == unfinished.Wanted.First ? $"\"raytracer resume {path}\" resumes it" : "merge the missing samples in";
                throw new CommandException(ExitStatus.InputOutput, $"'{path}' holds samples {unfinished.SamplesText} of an unfinished rendering: {how}; delete it to start from scratch");
            }
        }
    }

    private static bool IsWithin(FilmHeader film, FilmHeader? other) =>
        other?.Content == film.Content && film.Samples.All(s => other.Samples.Any(r => r.First <= s.First && s.End <= r.End));

    private static void Check(string path, bool isFilm)
    {
        AtomicFile.Check(path);
        try
        {
            if (!isFilm)
            {
                ImageFile.Check(path);
            }
        }
        catch (ImageWriteException e)
        {
            throw new CommandException(ExitStatus.Usage, e.Message.TrimEnd('.'));
        }

        AtomicFile.Sweep(path, DateTime.UtcNow - LongestPause);
        AtomicFile.Try(path);
    }

    /// <summary>Writes an image to several files; says of each that cannot be written why.</summary>
    /// <returns>Those that were written.</returns>
    public static IReadOnlyList<string> Write(IEnumerable<string> paths, IImageRows image, ImageWriteOptions options, Streams streams)
    {
        List<string> written = [];
        foreach (string path in paths)
        {
            try
            {
                ImageFile.Write(path, image, options);
                written.Add(path);
            }
            catch (ImageWriteException e)
            {
                streams.Fail(e.Message.TrimEnd('.'));
            }
        }

        return written;
    }

    /// <summary>Writes a film to a film file, or to an OpenEXR image that carries it.</summary>
    /// <param name="path">The file.</param>
    /// <param name="film">The film.</param>
    /// <param name="header">What the file says of it.</param>
    /// <param name="options">How an image is written; null for one with nothing but the film.</param>
    /// <exception cref="ImageWriteException">It cannot be written.</exception>
    public static void WriteFilm(string path, Film film, FilmHeader header, ImageWriteOptions? options = null)
    {
        if (FilmFile.IsNamed(path))
        {
            FilmFile.Write(path, film, header);
        }
        else
        {
            FilmExr.Write(path, film, header, options ?? new() { Metadata = FilmTexts.Of(header, film.ComputeHash()) });
        }
    }

    /// <summary>Writes a film to the files that carry it, and its picture to the others; says of each that cannot be written why.</summary>
    /// <returns>Those that were written.</returns>
    public static IReadOnlyList<string> Write(IEnumerable<string> paths, Film film, FilmHeader header, ImageWriteOptions options, Streams streams)
    {
        List<string> written = [];
        foreach (string path in paths)
        {
            if (!options.TakesFilm(path))
            {
                written.AddRange(Write([path], film, options, streams));
                continue;
            }

            try
            {
                WriteFilm(path, film, header, options);
                written.Add(path);
            }
            catch (ImageWriteException e)
            {
                streams.Fail(e.Message.TrimEnd('.'));
            }
        }

        return written;
    }
}
