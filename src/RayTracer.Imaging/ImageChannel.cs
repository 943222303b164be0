namespace RayTracer.Imaging;

/// <summary>A channel of a picture file.</summary>
/// <param name="Name">Its name; in OpenEXR, behind that of its layer and a dot.</param>
/// <param name="Type">What its numbers are.</param>
/// <param name="Bits">How many bits each has.</param>
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
