using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>The options of <see cref="ImageFile.Write"/>; what does not apply to the format of the file is ignored.</summary>
public sealed record ImageWriteOptions
{
    /// <summary>PNG: bits a channel, 8 (the default) or 16.</summary>
    public int BitDepth { get; init; } = 8;

    /// <summary>
    /// PNG and JPEG: the tone map; null for none, <see cref="RayTracer.Description.ToneMap.Clamp"/>. PFM and OpenEXR hold the linear light as it
    /// is.
    /// </summary>
    public ToneMap? ToneMap { get; init; }

    /// <summary>PNG and JPEG: the exposure, −100 to 100 stops, each of which doubles the light, or automatic; null for 0.</summary>
    public Exposure? Exposure { get; init; }

    /// <summary>JPEG: the quality, 1 to 100; 90 by default.</summary>
    public int JpegQuality { get; init; } = JpegWriter.StandardQuality;

    /// <summary>JPEG: how many differences of colour are kept; by default all from quality 90 on, below it a quarter.</summary>
    public JpegChroma? JpegChroma { get; init; }

    /// <summary>OpenEXR: half (the default) or float.</summary>
    public ExrPixelType ExrPixelType { get; init; } = ExrPixelType.Half;

    /// <summary>OpenEXR: the compression; ZIP by default.</summary>
    public ExrCompression ExrCompression { get; init; } = ExrCompression.Zip;

    /// <summary>
    /// PNG, JPEG and OpenEXR: texts to keep in the file, such as the command that made it; see <see cref="PngWriter"/> for what a key may
    /// be. PFM has no place for them.
    /// </summary>
    public IReadOnlyList<KeyValuePair<string, string>> Metadata { get; init; } = [];

    /// <summary>OpenEXR: further texts, which say what its layers mean.</summary>
    public IReadOnlyList<KeyValuePair<string, string>> ExrTexts { get; init; } = [];

    /// <summary>OpenEXR: whether the film itself goes along, as <see cref="FilmExr"/> writes it.</summary>
    public bool ExrFilm { get; init; }

    /// <summary>
    /// PNG and OpenEXR: whether pictures of films lack what is behind everything, and say how opaque they are. Such a film was rendered for that.
    /// </summary>
    public bool Transparent { get; init; }

    /// <summary>
    /// PNG and OpenEXR: writes how opaque the pixels of a row are, 0 to 1, where the image is premultiplied with that; null where it is opaque.
    /// </summary>
    internal Action<int, Span<float>>? Alpha { get; init; }

    /// <summary>The options with the exposure and the tone map of a scene, where none are given.</summary>
    public ImageWriteOptions For(RenderDescription render)
    {
        ToneMap map = ToneMap ?? render.ShownToneMap;
        return this with { ToneMap = map, Exposure = Exposure ?? render.ExposureUnder(map) };
    }

    /// <summary>The options with the exposure in stops, where an image decides on it.</summary>
    public ImageWriteOptions Exposed(IImageRows image) => this with { Exposure = (Exposure ?? default).StopsFor(image) };

    /// <summary>An image as a display shows it.</summary>
    public ToneMappedRows Shown(IImageRows image) =>
        new(image, ToneMap ?? Description.ToneMap.Clamp, (Exposure ?? default).StopsFor(image));

    /// <summary>Returns whether a file of some name shall carry the film.</summary>
    public bool TakesFilm(string path) => FilmFile.IsNamed(path) || (ExrFilm && FilmExr.IsNamed(path));

    /// <summary>OpenEXR: channels to write beside those of the image.</summary>
    public IReadOnlyList<ExrLayerChannel> ExrLayers { get; init; } = [];
}
