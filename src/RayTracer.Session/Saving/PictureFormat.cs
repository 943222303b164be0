using RayTracer.Imaging;

namespace RayTracer.Session;

/// <summary>A format of files that pictures are written to.</summary>
/// <param name="Value">The ending of names, without its dot.</param>
/// <param name="Label">The name that is shown.</param>
/// <param name="HasDepth">True if bits a channel can be chosen.</param>
/// <param name="HasLayers">True if it takes auxiliary images.</param>
/// <param name="IsFilm">True if it is the film itself, which is only written to files.</param>
public sealed record PictureFormat(string Value, string Label, bool HasDepth, bool HasLayers, bool IsFilm)
{
    /// <summary>The film itself.</summary>
    public static PictureFormat Film { get; } =
        new(FilmFile.Extension[1..], SessionTexts.Of("formats.rtfilm"), HasDepth: false, HasLayers: false, IsFilm: true);

    /// <summary>Returns a format of pictures as it is offered.</summary>
    public static PictureFormat Of(ImageFormat format) => new(
        format.Extensions[0][1..],
        format.Name,
        format.Features.HasFlag(ImageFeatures.BitDepth),
        format.Features.HasFlag(ImageFeatures.Layers),
        IsFilm: false);
}
