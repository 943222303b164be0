using System.Text;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Writes Radiance pictures (.hdr; Ward 1991), run-length coded: red, green and blue of eight bits each with a common exponent, so that a
/// value is off by at most 1/256 of the pixel's largest. Rounded to the nearest; what is below 0 or no number is 0, and what is too bright
/// is the brightest there is.
/// </summary>
internal static class HdrWriter
{
    // Mantissas are whole numbers of eight bits, in units of 2^(exponent − 136).
    private const int Bias = 136;
    private const int ShortestRun = 4;
    private const int LongestRun = 127;
    private const int LongestPlain = 128;

    /// <summary>Writes an image.</summary>
    /// <param name="output">The destination.</param>
    /// <param name="image">Linear RGB.</param>
    /// <param name="metadata">
    /// Texts to keep as comments, <c># key: value</c> in UTF-8; may be null. One that has line ends, or some 65,000 bytes, is left out.
    /// </param>
    public static void Write(Stream output, IImageRows image, IReadOnlyList<KeyValuePair<string, string>>? metadata = null)
    {
        int width = image.Width;

        // Ward's own reader wants nothing between FORMAT and the empty line.
        IEnumerable<string> comments = (metadata ?? []).Select(t => $"# {t.Key}: {t.Value}\n").Where(c => !c.AsSpan(0, c.Length - 1).ContainsAny('\n', '\r') && Encoding.UTF8.GetByteCount(c) <= HdrReader.LongestLine);
        output.Write(Encoding.UTF8.GetBytes($"#?RADIANCE\n{string.Concat(comments)}FORMAT=32-bit_rle_rgbe\n\n-Y {image.Height} +X {width}\n"));
        float[] row = new float[3 * width];
        byte[] channels = new byte[4 * width];
        List<byte> coded = [];
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, row);
            for (int x = 0; x < width; x++)
            {
                Encode(row.AsSpan(3 * x, 3), channels, x, width);
            }

            coded.Clear();
            if (width is >= 8 and < 32768)
            {
                coded.AddRange([2, 2, (byte)(width >> 8), (byte)width]);
                for (int channel = 0; channel < 4; channel++)
                {
                    AddRuns(channels.AsSpan(channel * width, width), coded);
                }
            }
            else
            {
                // Shorter and longer rows are pixels one after the other.
                for (int i = 0; i < channels.Length; i++)
                {
                    coded.Add(channels[(i % 4 * width) + (i / 4)]);
                }
            }

            output.Write([.. coded]);
        }
    }

    private static void Encode(ReadOnlySpan<float> rgb, byte[] channels, int x, int width)
    {
        float largest = Math.Max(Light(rgb[0]), Math.Max(Light(rgb[1]), Light(rgb[2])));
        int exponent = largest > 0 ? Math.Max(Math.ILogB(largest) - 7, 1 - Bias) : 0;

        // Rounding may need one bit more.
        exponent += largest > 0 && Mantissa(largest, exponent) > 255 ? 1 : 0;
        exponent = Math.Min(exponent, 255 - Bias);
        bool isBlack = !(largest > 0) || Mantissa(largest, exponent) == 0;
        for (int i = 0; i < 3; i++)
        {
            channels[(i * width) + x] = (byte)(isBlack ? 0 : Math.Min(Mantissa(Light(rgb[i]), exponent), 255));
        }

        channels[(3 * width) + x] = (byte)(isBlack ? 0 : exponent + Bias);
    }

    private static float Light(float value) => value > 0 ? Math.Min(value, float.MaxValue) : 0;

    private static int Mantissa(float value, int exponent) => (int)Math.Min(Math.Round(Math.ScaleB((double)value, -exponent)), 1000);

    // A count above 128 is that of a run, whose byte follows; another, of bytes that follow as they are.
    private static void AddRuns(ReadOnlySpan<byte> values, List<byte> coded)
    {
        int plain = 0;
        for (int x = 0; x < values.Length;)
        {
            int run = 1;
            while (run < LongestRun && x + run < values.Length && values[x + run] == values[x])
            {
                run++;
            }

            if (run < ShortestRun)
            {
                x += run;
                continue;
            }

            AddPlain(values[plain..x], coded);
            coded.AddRange([(byte)(128 + run), values[x]]);
            x += run;
            plain = x;
        }

        AddPlain(values[plain..], coded);
    }

    private static void AddPlain(ReadOnlySpan<byte> values, List<byte> coded)
    {
        for (int at = 0; at < values.Length; at += LongestPlain)
        {
            ReadOnlySpan<byte> part = values.Slice(at, Math.Min(LongestPlain, values.Length - at));
            coded.Add((byte)part.Length);
            coded.AddRange(part);
        }
    }
}
