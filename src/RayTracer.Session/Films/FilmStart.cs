using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>A film from a file, with whose samples a picture begins.</summary>
/// <param name="header">Its header in the file.</param>
/// <param name="film">The film.</param>
public sealed class FilmStart(FilmHeader header, Film film)
{
    private Film? _film = film;

    /// <summary>The film's header in the file.</summary>
    public FilmHeader Header => header;

    /// <summary>The samples that each pixel has.</summary>
    public SampleRange Held => header.Samples is [var held] ? held : new(header.Wanted.First, header.Wanted.First);

    /// <summary>Reads a film that can be resumed.</summary>
    /// <exception cref="SessionException">It cannot.</exception>
    public static FilmStart Read(string path)
    {
        try
        {
            (FilmHeader header, Film film) = CarriedFilm.Read(path);
            bool isWhole = header.Samples is [] || (header.Samples is [var held] && held.First == header.Wanted.First);
            return isWhole ? new(header with { Scene = Path.GetFullPath(JobOrigin.ScenePath(header.Scene, path)) }, film)
                : throw new SessionException(
                    $"samples are missing within {Path.GetFileName(path)}, which has {header.SamplesText}: render them and merge");
        }
        catch (PictureException e)
        {
            throw new SessionException(e.Message.TrimEnd('.'), e);
        }
    }

    /// <summary>Returns the film, to add samples to it; null where it has been taken already.</summary>
    public Film? Take() => Interlocked.Exchange(ref _film, null);
}
