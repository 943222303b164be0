using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>A film from a file, to which samples are added.</summary>
/// <param name="Header">The header of the file.</param>
/// <param name="Film">The film.</param>
/// <param name="Path">The file.</param>
public sealed record HeldFilm(FilmHeader Header, Film Film, string Path)
{
    /// <summary>Reads one.</summary>
    /// <exception cref="Textures.PictureException">It cannot be read.</exception>
    public static HeldFilm Read(string path)
    {
        // It is brought up to date itself, so that it counts as no input.
        using InputFiles own = InputFiles.Begin();
        (FilmHeader header, Film film) = CarriedFilm.Read(path);
        return new(header, film, path);
    }

    /// <summary>Finds out whether a film holds samples of its picture.</summary>
    /// <exception cref="JobException">It holds none yet.</exception>
    public static void CheckPicture(FilmHeader header, string path)
    {
        if (header.Samples.Count == 0 || DecisionCheckpoint.Is(header))
        {
            throw header.Samples.Count == 0 ? new JobException($"'{path}' holds no samples yet") : DecisionCheckpoint.NoPicture(path);
        }
    }
}

/// <summary>Films in files whose rendering is not finished.</summary>
public static class UnfinishedFilms
{
    /// <summary>Keeps films of unfinished renderings from being written over.</summary>
    /// <param name="paths">The files to write.</param>
    /// <param name="own">A film that may be replaced, for it is resumed; null for none.</param>
    /// <param name="replacement">The header of the film that is written; null where that is not known yet. Films all of whose samples are in it may be
    /// replaced.</param>
    /// <exception cref="JobException">There is one; the message says what to do with it.</exception>
    public static void Check(IEnumerable<string> paths, string? own = null, FilmHeader? replacement = null)
    {
        foreach (string path in paths.Where(p => CarriedFilm.Is(p) && (own is null || Path.GetFullPath(p) != Path.GetFullPath(own))))
        {
            if (CarriedFilm.Unfinished(path) is { } unfinished && !IsWithin(unfinished, replacement))
            {
                string how = unfinished.Samples is [var held] && held.First == unfinished.Wanted.First
                    ? $"\"raytracer resume {path}\" continues" : "merge the missing samples in";
                throw new JobException(JobFault.File, $"'{path}' holds samples {unfinished.SamplesText} of an unfinished rendering: {how}; delete it to begin from scratch");
            }
        }
    }

    private static bool IsWithin(FilmHeader film, FilmHeader? other) =>
        other?.Content == film.Content && film.Samples.All(s => other.Samples.Any(r => r.First <= s.First && s.End <= r.End));
}
