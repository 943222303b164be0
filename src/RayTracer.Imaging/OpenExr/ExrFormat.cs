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
