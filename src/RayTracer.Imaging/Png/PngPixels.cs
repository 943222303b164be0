using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Turns the packed samples of PNG rows into the floats of a picture.</summary>
internal sealed class PngPixels
{
    private readonly PngHeader _header;
    private readonly byte[]? _palette;
    private readonly float[] _values;

    private readonly bool _ofAlpha;

    public PngPixels(PngHeader header, byte[]? palette, bool raw, bool ofAlpha)
    {
        _ofAlpha = ofAlpha;
        _header = header;
        _palette = header.ColourType == PngColourType.Palette ? palette : null;
        int max = header.BitDepth == 16 ? 65535 : 255;
        _values = raw ? RawValues(max) : SrgbCurve.CodesOf(header.BitDepth == 16 ? 16 : 8).Linear;
    }

    /// <summary>Puts the pixels of an unfiltered row where they belong.</summary>
    public void Expand(ReadOnlySpan<byte> row, PngPass pass, int y, Picture picture)
    {
        bool grey = _header.ColourType is PngColourType.Grey or PngColourType.GreyAlpha;
        long at = 3 * (((long)(pass.Y + (y * pass.StepY)) * picture.Width) + pass.X);
        float[] pixels = picture.Pixels;
        for (int x = 0; x < pass.Width; x++, at += 3L * pass.StepX)
        {
            int sample = x * _header.Samples;
            if (_palette is not null)
            {
                ReadOnlySpan<byte> colour = Colour(Sample(row, sample));
                pixels[at] = _values[colour[0]];
                pixels[at + 1] = _values[colour[1]];
                pixels[at + 2] = _values[colour[2]];
            }
            else if (_ofAlpha)
            {
                pixels[at] = pixels[at + 1] = pixels[at + 2] = _values[Sample(row, sample + _header.Samples - 1)];
            }
            else
            {
                pixels[at] = _values[Sample(row, sample)];
                pixels[at + 1] = _values[Sample(row, grey ? sample : sample + 1)];
                pixels[at + 2] = _values[Sample(row, grey ? sample : sample + 2)];
            }
        }
    }

    private static float[] RawValues(int max)
    {
        var values = new float[max + 1];
        for (int code = 0; code <= max; code++)
        {
            values[code] = (float)(code / (double)max);
        }

        return values;
    }

    // The n-th sample of a row: a palette index as it is, anything else scaled to 8 bits if it has fewer.
    private int Sample(ReadOnlySpan<byte> row, int n)
    {
        int depth = _header.BitDepth;
        if (depth == 8)
        {
            return row[n];
        }

        if (depth == 16)
        {
            return (row[2 * n] << 8) | row[(2 * n) + 1];
        }

        int bit = n * depth;
        int max = (1 << depth) - 1;
        int value = (row[bit >> 3] >> (8 - depth - (bit & 7))) & max;
        return _palette is null ? value * 255 / max : value;
    }

    private ReadOnlySpan<byte> Colour(int index)
    {
        if (3 * index >= _palette!.Length)
        {
            throw new PictureException($"a pixel has colour {index} of a palette of {_palette.Length / 3}");
        }

        return _palette.AsSpan(3 * index, 3);
    }
}

/// <summary>
/// A part of the pixels, on a regular grid, that is stored as a separate image: all of them, or one of Adam7's seven passes.
/// </summary>
internal readonly record struct PngPass(int X, int Y, int StepX, int StepY, int Width, int Height)
{
    /// <summary>The passes of a file that have pixels, in their order (W3C PNG specification, section 8).</summary>
    public static IEnumerable<PngPass> Of(PngHeader header)
    {
        PngPass[] all = header.Interlaced
            ? [Make(header, 0, 0, 8, 8), Make(header, 4, 0, 8, 8), Make(header, 0, 4, 4, 8), Make(header, 2, 0, 4, 4),
               Make(header, 0, 2, 2, 4), Make(header, 1, 0, 2, 2), Make(header, 0, 1, 1, 2)]
            : [Make(header, 0, 0, 1, 1)];
        return all.Where(pass => pass.Width > 0 && pass.Height > 0);
    }

    private static PngPass Make(PngHeader header, int x, int y, int stepX, int stepY) =>
        new(x, y, stepX, stepY, (header.Width - x + stepX - 1) / stepX, (header.Height - y + stepY - 1) / stepY);
}
