using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>Paints what there is of a picture: means where there are samples, the last preview where there are none.</summary>
public static class PicturePainter
{
    /// <summary>Paints.</summary>
    /// <param name="film">The samples.</param>
    /// <param name="preview">The picture that is shown where there are none.</param>
    /// <param name="to">Takes the picture.</param>
    public static void Paint(Film film, LinearPicture preview, LinearPicture to)
    {
        to.CopyFrom(film);
        if (preview.Width == 0)
        {
            return;
        }

        for (int y = 0; y < film.Height; y++)
        {
            Span<float> row = to.Row(y);
            ReadOnlySpan<float> coarse = preview.Row((int)((long)y * preview.Height / film.Height));
            for (int x = 0; x < film.Width; x++)
            {
                if (film.SampleCount(x, y) == 0)
                {
                    int from = 3 * (int)((long)x * preview.Width / film.Width);
                    coarse.Slice(from, 3).CopyTo(row[(3 * x)..]);
                }
            }
        }
    }

    /// <summary>Mixes in a picture of another size, smoothly enlarged.</summary>
    /// <param name="other">The other picture.</param>
    /// <param name="share">Its share, 0 to 1.</param>
    /// <param name="to">The picture.</param>
    public static void Blend(LinearPicture other, float share, LinearPicture to)
    {
        for (int y = 0; y < to.Height; y++)
        {
            (int y0, int y1, float fy) = Between(y, to.Height, other.Height);
            Span<float> row = to.Row(y);
            ReadOnlySpan<float> top = other.Row(y0);
            ReadOnlySpan<float> bottom = other.Row(y1);
            for (int x = 0; x < to.Width; x++)
            {
                (int x0, int x1, float fx) = Between(x, to.Width, other.Width);
                for (int i = 0; i < 3; i++)
                {
                    float above = float.Lerp(top[(3 * x0) + i], top[(3 * x1) + i], fx);
                    float below = float.Lerp(bottom[(3 * x0) + i], bottom[(3 * x1) + i], fx);
                    row[(3 * x) + i] = float.Lerp(row[(3 * x) + i], float.Lerp(above, below, fy), share);
                }
            }
        }
    }

    // The two pixels of the smaller picture around the middle of a pixel, and how far it is to the second.
    private static (int First, int Second, float Part) Between(int pixel, int size, int smaller)
    {
        float at = Math.Clamp(((pixel + 0.5f) * smaller / size) - 0.5f, 0, smaller - 1);
        int first = (int)at;
        return (first, Math.Min(first + 1, smaller - 1), at - first);
    }

    /// <summary>Paints a part over with another picture of the same size.</summary>
    /// <param name="picture">The other picture.</param>
    /// <param name="area">The part.</param>
    /// <param name="to">The picture that is painted over.</param>
    public static void Cover(IImageRows picture, Tile area, LinearPicture to)
    {
        float[] row = new float[3 * picture.Width];
        for (int y = area.Y; y < area.Y + area.Height; y++)
        {
            picture.ReadRow(y, row);
            row.AsSpan(3 * area.X, 3 * area.Width).CopyTo(to.Row(y)[(3 * area.X)..]);
        }
    }
}
