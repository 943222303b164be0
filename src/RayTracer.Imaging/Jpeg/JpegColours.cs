using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>The colours of the components of a JPEG picture.</summary>
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
    /// <param name="space">The meaning of its components.</param>
    /// <param name="inverted">True where 255 means no ink, as in Adobe's files.</param>
    /// <param name="raw">True where codes are to be divided by 255 instead of being decoded from sRGB.</param>
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
        byte[][] codes = [.. _frame.Components.Select(_ => new byte[width])];
        (int green, int blue) = _space == JpegColourSpace.Grey ? (0, 0) : (1, 2);
        float[] mixed = new float[_frame.Components.Max(c => c.Width)];
        for (int y = 0; y < _frame.Height; y++)
        {
            ToCodes(y, mixed, rows, codes);
            JpegRows.Decode(codes[0], codes[green], codes[blue], _values, picture.Pixels.AsSpan(3 * y * width, 3 * width));
        }
    }

    // One row of pixels of a component.
    private void Expand(JpegComponent c, int y, Span<float> mixed, Span<float> row)
    {
        bool isFull = c.Horizontal == _frame.MaxHorizontal;
        bool halfAcross = 2 * c.Horizontal == _frame.MaxHorizontal;
        bool halfDown = 2 * c.Vertical == _frame.MaxVertical;
        bool smooth = (halfAcross || isFull) && (halfDown || c.Vertical == _frame.MaxVertical);
        int near = smooth && halfDown ? y >> 1 : Nearest(y, c.Vertical, _frame.MaxVertical);
        int far = smooth && halfDown ? Math.Clamp(near + ((y & 1) == 0 ? -1 : 1), 0, c.Height - 1) : -1;
        Span<float> samples = isFull ? row : mixed[..c.Width];
        JpegRows.Mix(c.Samples.AsSpan(near * c.Stride, samples.Length), far < 0 ? [] : c.Samples.AsSpan(far * c.Stride, samples.Length), samples);
        if (smooth && halfAcross)
        {
            JpegRows.Double(samples, row);
        }

        for (int x = 0; x < row.Length && !isFull && !(smooth && halfAcross); x++)
        {
            row[x] = samples[Nearest(x, c.Horizontal, _frame.MaxHorizontal)];
        }
    }

    private static int Nearest(int pixel, int factor, int maxFactor) => ((2 * pixel) + 1) * factor / (2 * maxFactor);

    // One row, in codes.
    private void ToCodes(int y, float[] mixed, float[][] rows, byte[][] codes)
    {
        JpegComponent first = _frame.Components[0];
        bool isPlain = _space == JpegColourSpace.YCbCr && first.Horizontal == _frame.MaxHorizontal && first.Vertical == _frame.MaxVertical;
        for (int i = isPlain ? 1 : 0; i < rows.Length; i++)
        {
            Expand(_frame.Components[i], y, mixed, rows[i]);
        }

        if (isPlain)
        {
            JpegRows.ToRgb(first.Samples.AsSpan(y * first.Stride, codes[0].Length), rows[1], rows[2], codes);
            return;
        }

        ToRgb(rows);
        for (int i = 0; i < rows.Length; i++)
        {
            JpegRows.Round(rows[i], codes[i]);
        }
    }

    // What is rare, without rounding on the way.
    private void ToRgb(float[][] rows)
    {
        for (int x = 0; x < rows[0].Length && _space is (JpegColourSpace.YCbCr or JpegColourSpace.Ycck); x++)
        {
            (rows[0][x], rows[1][x], rows[2][x]) = JpegRows.ToRgb(rows[0][x], rows[1][x], rows[2][x]);
        }

        // The differences of YCCK stand for red, green and blue; the inks are their complements.
        for (int x = 0; x < rows[0].Length && _space is (JpegColourSpace.Cmyk or JpegColourSpace.Ycck); x++)
        {
            for (int i = 0; i < 3; i++)
            {
                float ink = _space == JpegColourSpace.Ycck ? 255 - Math.Clamp(rows[i][x], 0, 255) : rows[i][x];
                rows[i][x] = _inverted ? ink * rows[3][x] / 255 : (255 - ink) * (255 - rows[3][x]) / 255;
            }
        }
    }
}
