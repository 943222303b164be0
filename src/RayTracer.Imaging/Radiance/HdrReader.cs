using System.Globalization;
using System.Text;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>
/// Reads Radiance pictures (.hdr, .pic; Ward 1991): red, green and blue of eight bits each with a common exponent, plain or run-length
/// coded in either way. A value is its mantissa · 2^(exponent − 136), as most programs read it; exposures in the header are undone.
/// </summary>
internal static class HdrReader
{
    /// <summary>Bytes of the longest line of a header, with its end.</summary>
    internal const int LongestLine = 1 << 16;

    private const int LongestHeader = 1 << 20;

    // A run of 127 equal bytes takes two; four bytes repeat a pixel 255 times.
    private const long MostPixelsPerByte = 64;

    /// <summary>The first bytes of a file.</summary>
    public static ReadOnlySpan<byte> Signature => "#?"u8;

    /// <summary>Reads a picture.</summary>
    /// <param name="file">The whole file.</param>
    /// <returns>Linear RGB.</returns>
    /// <exception cref="PictureException">
    /// The file is no Radiance picture, is cut off or damaged, or is beyond <see cref="PictureLimits"/>.
    /// </exception>
    public static Picture Read(ReadOnlySpan<byte> file)
    {
        ReadOnlySpan<byte> rest = file;
        float scale = 1 / Exposure(Header(ref rest));
        (int width, int height, bool isUpsideDown, bool isMirrored) = Size(Line(ref rest));
        PictureLimits.CheckSize(width, height);
        if ((long)width * height > rest.Length * MostPixelsPerByte)
        {
            throw new PictureException($"the file is cut off: {rest.Length} bytes are too few for {width}×{height} pixels");
        }

        Picture picture = PictureLimits.Allocate(width, height);
        byte[] row = new byte[4 * width];
        for (int i = 0; i < height; i++)
        {
            ReadRow(ref rest, row, file.Length);
            int y = isUpsideDown ? height - 1 - i : i;
            for (int x = 0; x < width; x++)
            {
                Decode(row.AsSpan(4 * x, 4), scale, picture.Pixels.AsSpan(3 * ((y * width) + (isMirrored ? width - 1 - x : x)), 3));
            }
        }

        return picture;
    }

    /// <summary>
    /// Reads the texts that a file carries: comments, <c># key: value</c> in UTF-8 or a text that is called "Comment", and variables,
    /// <c>KEY=value</c>.
    /// </summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">The header is damaged.</exception>
    public static IReadOnlyList<KeyValuePair<string, string>> ReadText(ReadOnlySpan<byte> file) =>
        [.. Header(ref file).Skip(1).Select(Text).OfType<KeyValuePair<string, string>>()];

    /// <summary>Reads what a file says of itself.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">The header is damaged.</exception>
    internal static ImageDescription Describe(ReadOnlySpan<byte> file)
    {
        ReadOnlySpan<byte> rest = file;
        Exposure(Header(ref rest));
        (int width, int height, _, _) = Size(Line(ref rest));
        PictureLimits.CheckSize(width, height);
        bool isCoded = width is >= 8 and < 32768 && rest is [2, 2, ..];
        return new("Radiance HDR", width, height, isCoded ? "run lengths" : "none, or old run lengths", ImageChannel.Of("mantissa, with a common exponent of 8 bits", 8, "R", "G", "B"), ReadText(file));
    }

    // The lines up to an empty one.
    private static List<string> Header(ref ReadOnlySpan<byte> rest)
    {
        Require(rest.StartsWith(Signature), "it does not begin as a Radiance picture does");

        List<string> lines = [];
        int before = rest.Length;
        for (string line = Line(ref rest); line.Length > 0; line = Line(ref rest))
        {
            lines.Add(before - rest.Length <= LongestHeader ? line : throw new PictureException("its header has no end"));
        }

        return lines;
    }

    private static KeyValuePair<string, string>? Text(string line)
    {
        // Lines are read byte for byte.
        line = Encoding.UTF8.GetString(Encoding.Latin1.GetBytes(line));
        bool isComment = line[0] == '#';
        line = isComment ? line[1..].TrimStart() : line;
        int end = line.IndexOf(isComment ? ": " : "=", StringComparison.Ordinal);
        return end > 0 && isComment ? new(line[..end], line[(end + 2)..])
            : isComment ? new("Comment", line)
            : end > 0 && line[..end] is not "FORMAT" and var key ? new(key, line[(end + 1)..]) : null;
    }

    // The product of all exposures.
    private static float Exposure(List<string> lines)
    {
        float exposure = 1;
        foreach (string line in lines)
        {
            if (line.StartsWith("FORMAT=", StringComparison.Ordinal) && line.Trim() != "FORMAT=32-bit_rle_rgbe")
            {
                throw new PictureException($"its colours are '{Shown(line["FORMAT=".Length..])}', and only 32-bit_rle_rgbe is read");
            }

            if (line.StartsWith("EXPOSURE=", StringComparison.Ordinal))
            {
                string number = line["EXPOSURE=".Length..];
                bool isNumber = float.TryParse(number, NumberStyles.Float, CultureInfo.InvariantCulture, out float factor) && factor > 0 && float.IsFinite(factor);
                exposure *= isNumber ? factor : throw new PictureException($"its exposure '{Shown(number)}' is not a number above 0");
            }
        }

        return exposure > 0 && float.IsFinite(exposure) && float.IsFinite(1 / exposure) ? exposure : throw new PictureException("its exposures multiply to a number too large or too small to compute with");
    }

    private static (int Width, int Height, bool IsUpsideDown, bool IsMirrored) Size(string line)
    {
        string[] words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        if (words is ["-Y" or "+Y", var height, "+X" or "-X", var width]
            && int.TryParse(height, NumberStyles.None, CultureInfo.InvariantCulture, out int h) && int.TryParse(width, NumberStyles.None, CultureInfo.InvariantCulture, out int w))
        {
            return (w, h, words[0] == "+Y", words[2] == "-X");
        }

        throw new PictureException($"its size is '{Shown(line)}', and only rows are read: '-Y height +X width', with either sign");
    }

    private static void ReadRow(ref ReadOnlySpan<byte> rest, byte[] row, int fileLength)
    {
        int width = row.Length / 4;
        if (width is >= 8 and < 32768 && rest.Length >= 4 && rest[0] == 2 && rest[1] == 2 && ((rest[2] << 8) | rest[3]) == width)
        {
            rest = rest[4..];
            for (int channel = 0; channel < 4; channel++)
            {
                ReadChannel(ref rest, row, channel, fileLength);
            }

            return;
        }

        ReadPixels(ref rest, row, fileLength);
    }

    // A channel of a row: more than 128 is a run, other counts come before as many bytes.
    private static void ReadChannel(ref ReadOnlySpan<byte> rest, byte[] row, int channel, int fileLength)
    {
        int width = row.Length / 4;
        for (int x = 0; x < width;)
        {
            int code = Take(ref rest, fileLength);
            int count = code > 128 ? code - 128 : code;
            if (count == 0 || count > width - x)
            {
                throw new PictureException($"a run of {count} at byte {fileLength - rest.Length - 1} does not fit in its row");
            }

            byte value = code > 128 ? Take(ref rest, fileLength) : (byte)0;
            for (int i = 0; i < count; i++, x++)
            {
                row[(4 * x) + channel] = code > 128 ? value : Take(ref rest, fileLength);
            }
        }
    }

    // Pixels one after the other; (1, 1, 1, n) repeats the one before n times, and 256 times as often for each such code in a row.
    private static void ReadPixels(ref ReadOnlySpan<byte> rest, byte[] row, int fileLength)
    {
        int width = row.Length / 4;
        int shift = 0;
        for (int x = 0; x < width;)
        {
            for (int i = 0; i < 4; i++)
            {
                row[(4 * x) + i] = Take(ref rest, fileLength);
            }

            if (row[4 * x] != 1 || row[(4 * x) + 1] != 1 || row[(4 * x) + 2] != 1)
            {
                x++;
                shift = 0;
                continue;
            }

            long count = shift < 24 ? (long)row[(4 * x) + 3] << shift : long.MaxValue;
            if (x == 0 || count > width - x)
            {
                throw new PictureException($"a run at byte {fileLength - rest.Length - 4} does not fit in its row");
            }

            for (; count > 0; count--, x++)
            {
                row.AsSpan(4 * (x - 1), 4).CopyTo(row.AsSpan(4 * x));
            }

            shift += 8;
        }
    }

    private static byte Take(ref ReadOnlySpan<byte> rest, int fileLength)
    {
        if (rest.IsEmpty)
        {
            throw new PictureException($"the file is cut off after {fileLength} bytes, within its pixels");
        }

        byte value = rest[0];
        rest = rest[1..];
        return value;
    }

    private static void Decode(ReadOnlySpan<byte> rgbe, float scale, Span<float> rgb)
    {
        float unit = rgbe[3] == 0 ? 0 : float.ScaleB(scale, rgbe[3] - 136);
        for (int i = 0; i < 3; i++)
        {
            rgb[i] = rgbe[i] * unit;
        }
    }

    private static string Line(ref ReadOnlySpan<byte> rest)
    {
        int end = rest[..Math.Min(rest.Length, LongestLine)].IndexOf((byte)'\n');
        Require(end >= 0, "its header is cut off, or has a line without end");

        string line = Encoding.Latin1.GetString(rest[..end]).TrimEnd('\r');
        rest = rest[(end + 1)..];
        return line;
    }

    private static string Shown(string text) => string.Concat(text.Take(40).Select(c => c is >= ' ' and <= '~' ? c : '?'));
}
