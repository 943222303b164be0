namespace RayTracer.Imaging;

/// <summary>The contents of a picture file except for its pixels.</summary>
/// <param name="Format">Its format's name.</param>
/// <param name="Width">Columns of pixels.</param>
/// <param name="Height">Rows of pixels.</param>
/// <param name="Compression">How its pixels are packed.</param>
/// <param name="Channels">What each pixel has, in the file's order.</param>
/// <param name="Texts">The texts that it carries, in their order.</param>
public sealed record ImageDescription(
    string Format, int Width, int Height, string Compression, IReadOnlyList<ImageChannel> Channels, IReadOnlyList<KeyValuePair<string, string>> Texts)
{
    /// <summary>The number of pictures that it shows one after the other.</summary>
    public int Frames { get; init; } = 1;

    /// <summary>The size of the file in bytes.</summary>
    public long FileBytes { get; init; }
}
