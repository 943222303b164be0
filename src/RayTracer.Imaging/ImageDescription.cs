namespace RayTracer.Imaging;

/// <summary>The description of a picture file, but for the pixels.</summary>
/// <param name="Format">Its format's name.</param>
/// <param name="Width">Columns of pixels.</param>
/// <param name="Height">Rows of pixels.</param>
/// <param name="Compression">The compression of its pixels.</param>
/// <param name="Channels">The channels of each pixel, in the file's order.</param>
/// <param name="Texts">The texts that it carries, in their order.</param>
public sealed record ImageDescription(
    string Format, int Width, int Height, string Compression, IReadOnlyList<ImageChannel> Channels, IReadOnlyList<KeyValuePair<string, string>> Texts)
{
    /// <summary>The number of pictures that it shows one after the other.</summary>
    public int Frames { get; init; } = 1;

    /// <summary>The size of the file in bytes.</summary>
    public long FileBytes { get; init; }
}

/// <summary>A channel of a picture file.</summary>
/// <param name="Name">Its name; in OpenEXR, behind that of its layer and a dot.</param>
/// <param name="Type">The type of its numbers.</param>
/// <param name="Bits">The number of bits of each.</param>
public sealed record ImageChannel(string Name, string Type, int Bits)
{
    internal const string Integer = "integer";

    /// <summary>The layer that it belongs to; empty for the picture itself.</summary>
    public string Layer => Name.LastIndexOf('.') is > 0 and int dot ? Name[..dot] : "";

    /// <summary>Its name within the layer.</summary>
    public string ShortName => Name[(Layer.Length == 0 ? 0 : Layer.Length + 1)..];

    /// <summary>Channels of one type.</summary>
    internal static IReadOnlyList<ImageChannel> Of(string type, int bits, params IEnumerable<string> names) =>
        [.. names.Select(n => new ImageChannel(n, type, bits))];
}
