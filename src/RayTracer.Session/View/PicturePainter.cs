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
