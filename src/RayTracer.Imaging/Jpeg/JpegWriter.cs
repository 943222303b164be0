using System.Text;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Writes JPEG files (ITU-T T.81, baseline, with the best Huffman codes for each image; ITU-T T.871, JFIF): sRGB-encoded, the same bytes on
/// every machine.
/// </summary>
internal static class JpegWriter
{
    /// <summary>The quality that is written where none is asked for.</summary>
    public const int StandardQuality = 90;

    /// <summary>The largest width and height of a JPEG file.</summary>
    public const int MaxSide = 65_535;

    /// <summary>The end of a text's key in segments that continue the text.</summary>
    internal const string Continued = " (continued)";

    // What a segment holds behind its own length.
    private const int MostBytes = 65_533;

    // From here on a file is wanted to be good rather than small.
    private const int FullChromaFrom = 90;

    /// <summary>Writes an image.</summary>
    /// <param name="output">The destination.</param>
    /// <param name="image">Linear RGB; what lies outside [0, 1] is cut off, NaN becomes 0.</param>
    /// <param name="quality">1 to 100, on libjpeg's scale.</param>
    /// <param name="chroma">The resolution of differences of colour; null for all of it from quality 90 on, and a quarter below.</param>
    /// <param name="metadata">
    /// Texts to keep as comments (COM), <c>key: value</c> in UTF-8. One that has more than 65,533 bytes continues in further ones, called
    /// <c>key (continued)</c>.
    /// </param>
    /// <exception cref="ArgumentException">A quality outside its range, or an image that is too large for the format.</exception>
    public static void Write(Stream output, IImageRows image, int quality = StandardQuality, JpegChroma? chroma = null, IEnumerable<KeyValuePair<string, string>>? metadata = null)
    {
        if (quality is < 1 or > 100)
        {
            throw new ArgumentOutOfRangeException(nameof(quality), $"The quality of a JPEG is between 1 and 100, not {quality}.");
        }

        if (image.Width > MaxSide || image.Height > MaxSide)
        {
            throw new ArgumentException($"A JPEG has at most {MaxSide} pixels a side, and the image has {image.Width}×{image.Height}.", nameof(image));
        }

        byte[][] steps = [JpegQuantization.Steps(quality, isLuminance: true), JpegQuantization.Steps(quality, isLuminance: false)];
        JpegPlanes planes = new(image, chroma ?? (quality >= FullChromaFrom ? JpegChroma.Full : JpegChroma.Half), steps);
        JpegCoder coder = new(planes);
        output.Write([0xFF, 0xD8]);
        WriteHeaders(output, image, planes, steps, metadata ?? []);
        WriteCodes(output, coder.MakeCodes());
        WriteSegment(output, 0xDA, [3, 1, 0x00, 2, 0x11, 3, 0x11, 0, 63, 0]);
        coder.Write(output);
        output.Write([0xFF, 0xD9]);
    }

    private static void WriteHeaders(Stream output, IImageRows image, JpegPlanes planes, byte[][] steps, IEnumerable<KeyValuePair<string, string>> metadata)
    {
        // Version 1.01; pixels are squares; no thumbnail.
        WriteSegment(output, 0xE0, [.. "JFIF\0"u8, 1, 1, 0, 0, 1, 0, 1, 0, 0]);
        foreach ((string key, string value) in metadata)
        {
            ReadOnlySpan<byte> rest = Encoding.UTF8.GetBytes(value);
            for (string name = key; ; name = key + Continued)
            {
                byte[] start = Encoding.UTF8.GetBytes($"{name}: ");
                int length = Math.Min(rest.Length, MostBytes - start.Length);
                while (length < rest.Length && (rest[length] & 0xC0) == 0x80)
                {
                    // Not within a character.
                    length--;
                }

                WriteSegment(output, 0xFE, [.. start, .. rest[..length]]);
                rest = rest[length..];
                if (rest.IsEmpty)
                {
                    break;
                }
            }
        }

        for (int table = 0; table < steps.Length; table++)
        {
            byte[] own = steps[table];
            WriteSegment(output, 0xDB, [(byte)table, .. Enumerable.Range(0, own.Length).Select(i => own[JpegScan.PlaceOf(i)])]);
        }

        WriteSegment(output, 0xC0, [8, (byte)(image.Height >> 8), (byte)image.Height, (byte)(image.Width >> 8), (byte)image.Width, 3,
            .. planes.Components.SelectMany(c => new[] { c.Id, (byte)((c.Horizontal << 4) | c.Vertical), (byte)c.Quantization })]);
    }

    private static void WriteCodes(Stream output, IReadOnlyList<JpegHuffmanCode> codes)
    {
        for (int i = 0; i < codes.Count; i++)
        {
            // The kind, DC or AC, is in the upper half of the byte.
            WriteSegment(output, 0xC4, [(byte)(((i & 1) << 4) | (i >> 1)), .. codes[i].Table]);
        }
    }

    private static void WriteSegment(Stream output, byte marker, byte[] data) =>
        output.Write([0xFF, marker, (byte)((data.Length + 2) >> 8), (byte)(data.Length + 2), .. data]);
}

/// <summary>The differences of colour that a JPEG file keeps.</summary>
public enum JpegChroma
{
    /// <summary>One of each for every pixel (4:4:4).</summary>
    Full,

    /// <summary>One of each for every square of four pixels, their mean (4:2:0): smaller files, blurred edges between colours.</summary>
    Half,
}

/// <summary>
/// Steps of coefficients (ITU-T T.81, annex K.1) for a quality from 1 to 100, scaled as libjpeg scales them, so that a number means what it
/// means elsewhere.
/// </summary>
internal static class JpegQuantization
{
    private static readonly byte[] s_luminance =
    [
        16, 11, 10, 16, 24, 40, 51, 61, 12, 12, 14, 19, 26, 58, 60, 55, 14, 13, 16, 24, 40, 57, 69, 56, 14, 17, 22, 29, 51, 87, 80, 62,
        18, 22, 37, 56, 68, 109, 103, 77, 24, 35, 55, 64, 81, 104, 113, 92, 49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99,
    ];

    private static readonly byte[] s_chrominance =
    [
        17, 18, 24, 47, 99, 99, 99, 99, 18, 21, 26, 66, 99, 99, 99, 99, 24, 26, 56, 99, 99, 99, 99, 99, 47, 66, 99, 99, 99, 99, 99, 99,
        99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
    ];

    /// <summary>The steps, row by row, from 1 to 255.</summary>
    /// <param name="quality">1 to 100.</param>
    /// <param name="isLuminance">True for luminance, not for differences of colour.</param>
    public static byte[] Steps(int quality, bool isLuminance)
    {
        int percent = quality < 50 ? 5000 / quality : 200 - (2 * quality);
        return [.. (isLuminance ? s_luminance : s_chrominance).Select(step => (byte)Math.Clamp(((step * percent) + 50) / 100, 1, 255))];
    }
}
