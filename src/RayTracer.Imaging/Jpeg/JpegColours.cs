using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>What the components of a JPEG picture mean.</summary>
internal enum JpegColourSpace
{
    /// <summary>One component.</summary>
    Grey,

    /// <summary>Luminance and two differences of colour.</summary>
    YCbCr,

    /// <summary>Red, green and blue themselves.</summary>
    Rgb,

    /// <summary>Cyan, magenta, yellow and black.</summary>
    Cmyk,

    /// <summary>Cyan, magenta and yellow as luminance and differences; and black.</summary>
    Ycck,
}

/// <summary>
/// Brings the components of a JPEG picture to one size and to RGB. Where a component has half the samples, they are interpolated
/// linearly between their centres, else each stands for all its pixels: as libjpeg does, so that pictures look as in other programs.
/// </summary>
internal sealed class JpegColours
{
    private readonly JpegFrame _frame;
    private readonly JpegColourSpace _space;
    private readonly bool _inverted;
    private readonly float[] _values;

    /// <summary>Prepares the conversion.</summary>
    /// <param name="frame">The picture, reconstructed.</param>
    /// <param name="space">What its components mean.</param>
    /// <param name="inverted">Whether 255 means no ink, as in Adobe's files.</param>
    /// <param name="raw">Whether codes are to be divided by 255 instead of being decoded from sRGB.</param>
    public JpegColours(JpegFrame frame, JpegColourSpace space, bool inverted, bool raw)
    {
        _frame = frame;
        _space = space;
        _inverted = inverted;
        _values = raw ? [.. Enumerable.Range(0, 256).Select(code => code / 255f)] : SrgbCurve.CodesOf(8).Linear;
    }

    /// <summary>Fills the picture.</summary>
    public void Convert(Picture picture)
    {
        int width = _frame.Width;
        float[][] rows = [.. _frame.Components.Select(_ => new float[width])];
        float[] mixed = new float[_frame.Components.Max(c => c.Width)];
        for (int y = 0; y < _frame.Height; y++)
        {
            for (int i = 0; i < rows.Length; i++)
            {
                Expand(_frame.Components[i], y, mixed, rows[i]);
            }

            ConvertRow(rows, picture.Pixels.AsSpan(3 * y * width, 3 * width));
        }
    }

    // One row of pixels of a component.
    private void Expand(JpegComponent c, int y, Span<float> mixed, Span<float> row)
    {
        bool halfAcross = 2 * c.Horizontal == _frame.MaxHorizontal;
        bool halfDown = 2 * c.Vertical == _frame.MaxVertical;
        bool smooth = (halfAcross || c.Horizontal == _frame.MaxHorizontal) && (halfDown || c.Vertical == _frame.MaxVertical);
        (int near, int far) = smooth && halfDown ? Neighbours(y, c.Height) : (Nearest(y, c.Vertical, _frame.MaxVertical), -1);
        ReadOnlySpan<byte> samples = c.Samples.AsSpan(near * c.Stride, c.Width);
        for (int x = 0; x < samples.Length; x++)
        {
            mixed[x] = far < 0 ? samples[x] : (samples[x] * 0.75f) + (c.Samples[(far * c.Stride) + x] * 0.25f);
        }

        for (int x = 0; x < row.Length; x++)
        {
            if (smooth && halfAcross)
            {
                (near, far) = Neighbours(x, c.Width);
                row[x] = (mixed[near] * 0.75f) + (mixed[far] * 0.25f);
            }
            else
            {
                row[x] = mixed[Nearest(x, c.Horizontal, _frame.MaxHorizontal)];
            }
        }
    }

    private static (int Near, int Far) Neighbours(int pixel, int samples) =>
        (pixel >> 1, Math.Clamp((pixel >> 1) + ((pixel & 1) == 0 ? -1 : 1), 0, samples - 1));

    private static int Nearest(int pixel, int factor, int maxFactor) => ((2 * pixel) + 1) * factor / (2 * maxFactor);

    private void ConvertRow(float[][] rows, Span<float> pixels)
    {
        for (int x = 0; x < rows[0].Length; x++)
        {
            float first = rows[0][x];
            (float r, float g, float b) = _space switch
            {
                JpegColourSpace.Grey => (first, first, first),
                JpegColourSpace.Rgb => (first, rows[1][x], rows[2][x]),
                JpegColourSpace.YCbCr => OfLuminance(first, rows[1][x], rows[2][x]),
                JpegColourSpace.Cmyk => OfInk(first, rows[1][x], rows[2][x], rows[3][x]),
                _ => OfInk(OfLuminance(first, rows[1][x], rows[2][x]), rows[3][x]),
            };
            pixels[3 * x] = _values[Code(r)];
            pixels[(3 * x) + 1] = _values[Code(g)];
            pixels[(3 * x) + 2] = _values[Code(b)];
        }
    }

    // ITU-T T.871 (JFIF), section 7: Rec. 601 luminance, all codes used.
    private static (float R, float G, float B) OfLuminance(float y, float cb, float cr)
    {
        cb -= 128;
        cr -= 128;
        return (y + (1.402f * cr), y - (0.344136286f * cb) - (0.714136286f * cr), y + (1.772f * cb));
    }

    // The differences stand for red, green and blue; the inks are their complements.
    private (float R, float G, float B) OfInk((float R, float G, float B) c, float black) =>
        OfInk(255 - Limited(c.R), 255 - Limited(c.G), 255 - Limited(c.B), black);

    private (float R, float G, float B) OfInk(float cyan, float magenta, float yellow, float black) => _inverted
        ? (cyan * black / 255, magenta * black / 255, yellow * black / 255)
        : ((255 - cyan) * (255 - black) / 255, (255 - magenta) * (255 - black) / 255, (255 - yellow) * (255 - black) / 255);

    private static float Limited(float value) => Math.Clamp(value, 0, 255);

    private static byte Code(float value) => (byte)Math.Clamp(value + 0.5f, 0, 255);
}
