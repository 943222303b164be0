using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>Tells whether a file already holds the picture that a command would write, whole.</summary>
public static class FinishedPicture
{
    /// <summary>The key of an image's text that says how noisy it is, where a noise was wanted.</summary>
    public const string NoiseKey = "Noise";

    private const string NotReached = "not reached";

    /// <summary>What an image says of its noise.</summary>
    /// <param name="error">The estimated relative error.</param>
    /// <param name="wanted">The wanted one.</param>
    /// <param name="isReached">Whether it is good enough.</param>
    public static string NoiseText(double error, double wanted, bool isReached) =>
        string.Create(System.Globalization.CultureInfo.InvariantCulture, $"{100 * error:G3} % of {100 * wanted:G3} %: {(isReached ? "reached" : NotReached)}");

    /// <summary>Whether an image file holds it.</summary>
    /// <param name="file">The image file.</param>
    /// <param name="content">The picture's hash, by <see cref="ContentHash.OfPicture"/>.</param>
    /// <param name="command">A command that renders it, from whatever file to whatever files.</param>
    /// <returns>False also where there is no file, or something else or a damaged one.</returns>
    public static bool Is(string file, string content, string command) => Holds(file, f =>
    {
        IReadOnlyList<KeyValuePair<string, string>> texts = ImageFile.ReadText(f);
        bool same = texts.Contains(new("Content", content)) && texts.Any(t => t.Key == "Command" && PictureOptions.AreSame(t.Value, command));

        // Texts stand before the pixels, which may be missing.
        return same && ImageFile.Read(f).Width > 0;
    });

    /// <summary>Whether an image file says that the wanted noise was not reached.</summary>
    /// <param name="file">The image file.</param>
    public static bool IsNoisy(string file) => Holds(file, f => ImageFile.ReadText(f).Any(t => t.Key == NoiseKey && t.Value.EndsWith(NotReached, StringComparison.Ordinal)));

    /// <summary>Whether a film holds it.</summary>
    /// <param name="file">The film.</param>
    /// <param name="content">The samples' hash, by <see cref="ContentHash.Of"/>.</param>
    /// <param name="wanted">The samples; null for those that the film was to have.</param>
    /// <returns>False also where there is no file, or something else or a damaged one.</returns>
    public static bool IsFilm(string file, string content, SampleRange? wanted) =>
        Holds(file, f => FilmFile.ReadHeader(f) is { IsComplete: true } header && header.Content == content && (wanted is null || header.Wanted == wanted) && FilmFile.Read(f).Film.Width > 0);

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
