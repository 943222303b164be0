using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>Tells whether a file already holds the picture that a command would write.</summary>
public static class FinishedPicture
{
    /// <summary>Whether an image file holds it.</summary>
    /// <param name="file">The image file.</param>
    /// <param name="content">The picture's hash, by <see cref="ContentHash.OfPicture"/>.</param>
    /// <param name="command">The command that renders it.</param>
    /// <returns>False also where there is no file, or something else or a damaged one.</returns>
    public static bool Is(string file, string content, string command) =>
        Holds(file, f => ImageFile.ReadText(f) is var texts && texts.Contains(new("Content", content)) && texts.Contains(new("Command", command)));

    /// <summary>Whether a film holds it.</summary>
    /// <param name="file">The film.</param>
    /// <param name="content">The samples' hash, by <see cref="ContentHash.Of"/>.</param>
    /// <param name="wanted">The samples; null for those that the film was to have.</param>
    /// <returns>False also where there is no file, or something else or a damaged one.</returns>
    public static bool IsFilm(string file, string content, SampleRange? wanted) =>
        Holds(file, f => FilmFile.ReadHeader(f) is { IsComplete: true } header && header.Content == content && (wanted is null || header.Wanted == wanted));

    private static bool Holds(string file, Predicate<string> read)
    {
        try
        {
            return File.Exists(file) && read(file);
        }
        catch (PictureException)
        {
            return false;
        }
    }
}
