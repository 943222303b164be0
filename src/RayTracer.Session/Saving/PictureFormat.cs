using RayTracer.Imaging;

namespace RayTracer.Session;

/// <summary>A format of files that pictures are written to.</summary>
/// <param name="Value">The ending of names, without its dot.</param>
/// <param name="Label">What it is called.</param>
/// <param name="HasDepth">Whether bits a channel can be chosen.</param>
/// <param name="HasLayers">Whether it takes auxiliary images.</param>
/// <param name="IsFilm">Whether it is the film itself, which is only written to files.</param>
public sealed record PictureFormat(string Value, string Label, bool HasDepth, bool HasLayers, bool IsFilm)
{
    /// <summary>The format of an ending.</summary>
    /// <param name="ending">With its dot.</param>
    public static PictureFormat Of(string ending)
    {
        string value = ending[1..];
        string label = SessionTexts.Keys("formats").Contains(value) ? SessionTexts.Of($"formats.{value}") : value.ToUpperInvariant();
        return new(value, label, ending == ".png", ending == ".exr", FilmFile.IsNamed(ending));
    }
}
