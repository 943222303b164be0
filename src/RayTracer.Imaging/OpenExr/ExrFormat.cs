namespace RayTracer.Imaging;

/// <summary>
/// The facts that reader and writer of OpenEXR share ("Technical Introduction to OpenEXR" and "OpenEXR File Layout", openexr.com).
/// </summary>
internal static class ExrFormat
{
    public const int Version = 2;
    public const int TiledFlag = 0x200;
    public const int LongNamesFlag = 0x400;
    public const int DeepFlag = 0x800;
    public const int MultiPartFlag = 0x1000;
    public const int ShortName = 31;
    public const int LongName = 255;

    /// <summary>The channel of how opaque the pixels are; the picture is premultiplied with it.</summary>
    public const string Alpha = "A";

    /// <summary>A compression that is read, but not written.</summary>
    public const ExrCompression Piz = (ExrCompression)4;

    /// <inheritdoc cref="Piz"/>
    public const ExrCompression Pxr24 = (ExrCompression)5;

    /// <inheritdoc cref="Piz"/>
    public const ExrCompression B44 = (ExrCompression)6;

    /// <inheritdoc cref="Piz"/>
    public const ExrCompression B44A = (ExrCompression)7;

    /// <summary>Names to which the format itself gives a meaning: no texts of a user.</summary>
    public static readonly string[] Attributes =
    [
        "channels", "compression", "dataWindow", "displayWindow", "lineOrder", "pixelAspectRatio", "screenWindowCenter",
        "screenWindowWidth", "name", "type", "version", "chunkCount", "tiles", "view", "maxSamplesPerPixel", "chromaticities",
        "whiteLuminance", "preview", "multiView",
    ];

    /// <summary>The four bytes that an OpenEXR file begins with.</summary>
    public static ReadOnlySpan<byte> Magic => [0x76, 0x2F, 0x31, 0x01];

    /// <summary>A compression's name in the format's own documents.</summary>
    public static string NameOf(ExrCompression compression) => compression switch
    {
        Piz => "PIZ",
        Pxr24 => "PXR24",
        B44 => "B44",
        B44A => "B44A",
        _ => compression.ToString().ToUpperInvariant(),
    };

    /// <summary>Rows that are compressed together.</summary>
    public static int RowsOfBlock(ExrCompression compression) => compression switch
    {
        ExrCompression.Zip or Pxr24 => 16,
        Piz or B44 or B44A => 32,
        _ => 1,
    };

    /// <summary>The largest ratio of bytes to compressed bytes; of four bytes, PXR24 packs three.</summary>
    public static long MaxRatio(ExrCompression compression) => PictureLimits.MaxDeflateRatio * (compression == Pxr24 ? 2 : 1);
}

/// <summary>A channel beside R, G and B in an OpenEXR file.</summary>
/// <param name="Name">
/// Its name, such as <c>depth.Z</c>: the layer, a point, and the channel of the layer; 1 to 255 bytes of ASCII without NUL.
/// </param>
/// <param name="Type">The type of its values.</param>
/// <param name="ReadRow">Writes the values of a row (0 is the top), one a pixel.</param>
public sealed record ExrLayerChannel(string Name, ExrPixelType Type, Action<int, Memory<double>> ReadRow);

/// <summary>The types of values of OpenEXR channels; the values are the file format's.</summary>
public enum ExrPixelType
{
    /// <summary>32-bit unsigned integer; written in layers only.</summary>
    Uint = 0,

    /// <summary>16-bit float: 11 bits of precision, up to 65504.</summary>
    Half = 1,

    /// <summary>32-bit float.</summary>
    Float = 2,
}

/// <summary>The compressions of pixels in OpenEXR files, all without loss; the values are the file format's.</summary>
public enum ExrCompression
{
    /// <summary>Not at all.</summary>
    None = 0,

    /// <summary>Run lengths, one row at a time.</summary>
    Rle = 1,

    /// <summary>Deflate, one row at a time.</summary>
    Zips = 2,

    /// <summary>Deflate, sixteen rows at a time: the smallest files of the four.</summary>
    Zip = 3,
}
