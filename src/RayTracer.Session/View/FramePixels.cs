using RayTracer.Imaging;

namespace RayTracer.Session;

/// <summary>
/// Frames as bytes for a screen: those of a PNG of the same picture, unless the screen has less than half as many pixels.
/// </summary>
public static class FramePixels
{
    /// <summary>By how much a frame is made smaller for a screen: so that it is not much larger than that.</summary>
    /// <param name="picture">The frame.</param>
    /// <param name="width">Pixels of the screen across; 0 for as many as the frame has.</param>
    /// <param name="height">Pixels of the screen down.</param>
    public static int Reduction(LinearPicture picture, int width, int height) =>
        width < 1 || height < 1 ? 1 : Math.Max(1, Math.Min(picture.Width / width, picture.Height / height));

    /// <summary>Writes a frame, row by row.</summary>
    /// <param name="picture">The frame.</param>
    /// <param name="tone">The exposure and tone map.</param>
    /// <param name="reduction">The number of pixels across and down that become one.</param>
    /// <param name="rgba">Takes four bytes a pixel.</param>
    public static void Write(LinearPicture picture, Tone tone, int reduction, Memory<byte> rgba)
    {
        (int width, int height) = (picture.Width / reduction, picture.Height / reduction);
        float factor = DisplayPixels.Factor(tone.Exposure.StopsFor(picture));
        float[] row = new float[3 * width];
        for (int y = 0; y < height; y++)
        {
            Span<byte> to = rgba.Span.Slice(4 * width * y, 4 * width);
            if (reduction == 1)
            {
                DisplayPixels.Write(picture.Row(y), tone.ToneMap, factor, to);
            }
            else
            {
                Average(picture, y * reduction, reduction, row);
                DisplayPixels.Write(row, tone.ToneMap, factor, to);
            }
        }
    }

    /// <summary>A smaller picture.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="reduction">The number of pixels across and down that become one, if the picture has so many.</param>
    public static LinearPicture Reduced(LinearPicture picture, int reduction)
    {
        reduction = Math.Min(reduction, Math.Min(picture.Width, picture.Height));
        LinearPicture small = new();
        small.Resize(picture.Width / reduction, picture.Height / reduction);
        for (int y = 0; y < small.Height; y++)
        {
            Average(picture, y * reduction, reduction, small.Row(y));
        }

        return small;
    }

    private static void Average(LinearPicture picture, int top, int reduction, Span<float> row)
    {
        row.Clear();
        for (int y = top; y < top + reduction; y++)
        {
            ReadOnlySpan<float> from = picture.Row(y);
            for (int i = 0; i < row.Length; i++)
            {
                int at = (i / 3 * reduction * 3) + (i % 3);
                for (int x = 0; x < reduction; x++)
                {
                    row[i] += from[at + (3 * x)];
                }
            }
        }

        foreach (ref float value in row)
        {
            value /= reduction * reduction;
        }
    }
}
