using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// A format of picture files: all that anybody knows of it. <see cref="ImageFile"/> reads and writes the formats of <see cref="Known"/>,
/// to which other assemblies add theirs, and so do the command and the Studio. Objects hold no state.
/// </summary>
public abstract class ImageFormat
{
    /// <summary>The length of a file's beginning by which its format is recognized.</summary>
    public const int HeadLength = 16;

    /// <summary>The formats, in the order in which they are listed and tried.</summary>
    public static Registry<ImageFormat> Known { get; } = new(
        "image format",
        f => [f.Name, .. f.Extensions],
        new PngFormat(), new JpegFormat(), new PfmFormat(), new OpenExrFormat(), new HdrFormat(), new FilmFormat());

    /// <summary>The format's name, such as "OpenEXR".</summary>
    public abstract string Name { get; }

    /// <summary>The name of a file of the format in a sentence, such as "an OpenEXR picture".</summary>
    public virtual string FileName => $"a {Name} picture";

    /// <summary>The extensions of files that are written, with their dots, the usual one first; none for one that is only read.</summary>
    public abstract IReadOnlyList<string> Extensions { get; }

    /// <summary>The features of the format.</summary>
    public virtual ImageFeatures Features => ImageFeatures.None;

    /// <summary>The largest width and height that the format has room for.</summary>
    public virtual int MaxSide => int.MaxValue;

    /// <summary>The media type, by which browsers know the format.</summary>
    public virtual string MediaType => "application/octet-stream";

    /// <summary>Returns the format that is written to files of a name, by its extension; null where it is of none.</summary>
    public static ImageFormat? OfName(string path) => Path.GetExtension(path) is { Length: > 0 } extension ? Known.Find(extension) : null;

    /// <summary>Returns the format of a file.</summary>
    /// <param name="file">The file, or its first <see cref="HeadLength"/> bytes.</param>
    public static ImageFormat? Of(ReadOnlySpan<byte> file)
    {
        foreach (ImageFormat format in Known.All)
        {
            if (format.Matches(file))
            {
                return format;
            }
        }

        return null;
    }

    /// <summary>Returns whether files of a name are written in a format with a feature.</summary>
    public static bool Has(string path, ImageFeatures feature) => OfName(path)?.Features.HasFlag(feature) == true;

    /// <summary>Returns the formats that are written and have all of some features.</summary>
    public static IEnumerable<ImageFormat> Written(ImageFeatures features = ImageFeatures.None) =>
        Known.All.Where(f => f.Extensions.Count > 0 && f.Features.HasFlag(features));

    /// <summary>Returns the usual extensions of the formats with some features, as words of a sentence: ".png, .jpg or .exr".</summary>
    public static string Endings(ImageFeatures features = ImageFeatures.None) =>
        Listed([.. Written(features).Select(f => f.Extensions[0])], "or");

    /// <summary>Returns the names of the formats with some features, as words of a sentence: "PNG and JPEG".</summary>
    public static string Names(ImageFeatures features = ImageFeatures.None) => Listed([.. Written(features).Select(f => f.Name)], "and");

    /// <summary>Returns whether a file of the format begins in some way.</summary>
    /// <param name="head">The file, or its first <see cref="HeadLength"/> bytes.</param>
    public abstract bool Matches(ReadOnlySpan<byte> head);

    /// <summary>Reads a picture.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="raw">With <see cref="ImageFeatures.Display"/>: whether the values are data (0 to 1) rather than sRGB codes.</param>
    /// <returns>Linear RGB.</returns>
    /// <exception cref="PictureException">It is damaged or too large; the message is a clause to follow its name and a colon.</exception>
    public abstract Picture Read(ReadOnlySpan<byte> file, bool raw);

    /// <summary>Reads how opaque the pixels are, 0 to 1 in all three channels; null where the file has no channel for it.</summary>
    /// <inheritdoc cref="Read"/>
    public virtual Picture? ReadAlpha(ReadOnlySpan<byte> file) => null;

    /// <summary>Reads what a file says of itself; by default, what its picture shows.</summary>
    /// <inheritdoc cref="Read"/>
    public virtual ImageDescription Describe(ReadOnlySpan<byte> file)
    {
        Picture picture = Read(file, raw: true);
        return new(Name, picture.Width, picture.Height, "unknown", ImageChannel.Of("float", 32, "R", "G", "B"), ReadText(file));
    }

    /// <summary>Reads the texts that a file carries, in their order.</summary>
    /// <inheritdoc cref="Read"/>
    public virtual IReadOnlyList<KeyValuePair<string, string>> ReadText(ReadOnlySpan<byte> file) => [];

    /// <summary>Reads the channels that are not of the picture.</summary>
    /// <inheritdoc cref="Read"/>
    public virtual IReadOnlyList<ExrLayerChannel> ReadLayers(ReadOnlySpan<byte> file) => [];

    /// <summary>Writes a picture, row by row.</summary>
    /// <param name="output">The stream to write to; it can seek.</param>
    /// <param name="image">Linear RGB; for formats of <see cref="ImageFeatures.Display"/> it is exposed and tone-mapped already.</param>
    /// <param name="options">The options, of which those of the format's features count.</param>
    /// <exception cref="ArgumentException">The options cannot be met.</exception>
    public virtual void Write(Stream output, IImageRows image, ImageWriteOptions options) =>
        throw new NotSupportedException($"{Name} is not written.");

    private static string Listed(string[] words, string last) =>
        words.Length < 2 ? string.Concat(words) : $"{string.Join(", ", words[..^1])} {last} {words[^1]}";
}

/// <summary>The features of a format: what its files hold, and which of <see cref="ImageWriteOptions"/> count for them.</summary>
[Flags]
public enum ImageFeatures
{
    /// <summary>None: linear light, and nothing beside it.</summary>
    None = 0,

    /// <summary>Colours to look at, encoded with the sRGB curve, rather than numbers; exposure and tone map count.</summary>
    Display = 1,

    /// <summary>8 or 16 bits a channel, as is chosen.</summary>
    BitDepth = 2,

    /// <summary>A quality that is chosen, for a smaller file.</summary>
    Quality = 4,

    /// <summary>Colours of every pixel or of every four, as is chosen.</summary>
    Chroma = 8,

    /// <summary>Half or float, as is chosen.</summary>
    PixelType = 16,

    /// <summary>Texts, such as the command that made the picture.</summary>
    Texts = 32,

    /// <summary>Channels beside those of the picture.</summary>
    Layers = 64,

    /// <summary>How opaque each pixel is.</summary>
    Alpha = 128,
}
