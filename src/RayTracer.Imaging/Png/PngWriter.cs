using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Writes PNG files (W3C PNG specification, third edition): RGB with 8 or 16 bits a channel, sRGB-encoded, and alpha beside them where it is
/// known.
/// </summary>
internal static class PngWriter
{
    /// <summary>Writes an image, row by row: no more than a few rows are in memory.</summary>
    /// <param name="output">The destination.</param>
    /// <param name="image">Linear RGB; what lies outside [0, 1] is cut off, NaN becomes 0.</param>
    /// <param name="bitDepth">Bits a channel: 8 or 16.</param>
    /// <param name="metadata">
    /// Text to keep with the image: keys of 1 to 79 printable Latin-1 characters, without spaces at the ends or side by side; values
    /// without NUL.
    /// </param>
    /// <param name="readAlpha">Writes how opaque the pixels of a row are, 0 to 1; null for a file without alpha.</param>
    /// <exception cref="ArgumentException">A bit depth that is neither 8 nor 16, or metadata that PNG cannot hold.</exception>
    public static void Write(
        Stream output, IImageRows image, int bitDepth = 8, IEnumerable<KeyValuePair<string, string>>? metadata = null, Action<int, Span<float>>? readAlpha = null)
    {
        if (bitDepth is not (8 or 16))
        {
            throw new ArgumentException($"A PNG is written with 8 or 16 bits per channel, not {bitDepth}.", nameof(bitDepth));
        }

        WriteStart(output, image.Width, image.Height, bitDepth, hasAlpha: readAlpha is not null);
        WriteTexts(output, metadata ?? []);
        using (var chunks = new PngChunkStream(output))
        using (var zlib = new ZLibStream(chunks, CompressionLevel.Optimal))
        {
            WriteRows(zlib, image, bitDepth, readAlpha);
        }

        PngChunkStream.WriteChunk(output, "IEND"u8, []);
    }

    /// <summary>Writes what stands before texts and pixels.</summary>
    internal static void WriteStart(Stream output, int width, int height, int bitDepth, bool hasAlpha = false)
    {
        const byte Rgb = 2;
        const byte Rgba = 6;
        output.Write(PngReader.Signature);
        Span<byte> header = stackalloc byte[13];
        header.Clear();
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header[4..], height);
        header[8] = (byte)bitDepth;
        header[9] = hasAlpha ? Rgba : Rgb;
        PngChunkStream.WriteChunk(output, "IHDR"u8, header);

        // Intent 0 (perceptual); gAMA is the value prescribed beside sRGB: 1/2.2 in units of 1/100000.
        PngChunkStream.WriteChunk(output, "sRGB"u8, [0]);
        BinaryPrimitives.WriteInt32BigEndian(header, 45455);
        PngChunkStream.WriteChunk(output, "gAMA"u8, header[..4]);
    }

    /// <summary>Writes texts.</summary>
    internal static void WriteTexts(Stream output, IEnumerable<KeyValuePair<string, string>> texts)
    {
        foreach ((string key, string value) in texts)
        {
            WriteText(output, key, value);
        }
    }

    private static void WriteText(Stream output, string key, string value)
    {
        bool validKey = key.Length is >= 1 and <= 79 && key.All(c => c is >= ' ' and <= '~' or > '\u00A0' and <= '\u00FF')
            && key.Trim() == key && !key.Contains("  ", StringComparison.Ordinal);
        if (!validKey || value.Contains('\0'))
        {
            throw new ArgumentException($"PNG cannot hold the text '{key}': a key has 1 to 79 Latin-1 characters and single spaces inside, a value no NUL.", nameof(key));
        }

        bool latin1 = value.All(c => c is '\n' or >= ' ' and <= '~' or >= '\u00A0' and <= '\u00FF');
        byte[] keyBytes = Encoding.Latin1.GetBytes(key);
        if (latin1)
        {
            PngChunkStream.WriteChunk(output, "tEXt"u8, [.. keyBytes, 0, .. Encoding.Latin1.GetBytes(value)]);
        }
        else
        {
            // After the key's end: no compression (two bytes), no language, no translated key.
            PngChunkStream.WriteChunk(output, "iTXt"u8, [.. keyBytes, 0, 0, 0, 0, 0, .. Encoding.UTF8.GetBytes(value)]);
        }
    }

    /// <summary>Writes the filtered rows, which are then compressed.</summary>
    internal static void WriteRows(Stream output, IImageRows image, int bitDepth, Action<int, Span<float>>? readAlpha = null)
    {
        SrgbCodes codes = SrgbCurve.CodesOf(bitDepth);
        int channels = readAlpha is null ? 3 : 4;
        int pixelBytes = channels * bitDepth / 8;
        var linear = new float[3 * image.Width];
        var alpha = new float[image.Width];
        var row = new byte[image.Width * pixelBytes];
        var above = new byte[row.Length];
        var candidate = new byte[1 + row.Length];
        var best = new byte[1 + row.Length];
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, linear);
            for (int i = 0; i < linear.Length; i++)
            {
                Put(row, (i / 3 * channels) + (i % 3), codes.Encode(linear[i]), bitDepth);
            }

            readAlpha?.Invoke(y, alpha);
            for (int x = 0; x < alpha.Length && readAlpha is not null; x++)
            {
                Put(row, (x * channels) + 3, (int)((alpha[x] * ((1 << bitDepth) - 1)) + 0.5f), bitDepth);
            }

            ChooseFilter(row, above, pixelBytes, ref candidate, ref best);
            output.Write(best);
            (row, above) = (above, row);
        }
    }

    private static void Put(byte[] row, int value, int code, int bitDepth)
    {
        if (bitDepth == 8)
        {
            row[value] = (byte)code;
        }
        else
        {
            BinaryPrimitives.WriteUInt16BigEndian(row.AsSpan(2 * value), (ushort)code);
        }
    }

    // The heuristic of the PNG specification, section 12.7: the filter with the smallest sum of absolute differences.
    private static void ChooseFilter(byte[] row, byte[] above, int pixelBytes, ref byte[] candidate, ref byte[] best)
    {
        long smallest = long.MaxValue;
        for (int type = 0; type < PngFilter.Count; type++)
        {
            candidate[0] = (byte)type;
            long sum = PngFilter.Apply(type, row, above, pixelBytes, candidate.AsSpan(1));
            if (sum < smallest)
            {
                smallest = sum;
                (candidate, best) = (best, candidate);
            }
        }
    }
}
