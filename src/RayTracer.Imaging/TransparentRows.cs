using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// A picture without what is behind everything in it: its light where something is seen, times the share of the pixel that it is seen in
/// (premultiplied), and that share.
/// </summary>
internal sealed class TransparentRows : IImageRows
{
    private readonly IImageRows _image;
    private readonly Film _film;

    private TransparentRows(IImageRows image, Film film) => (_image, _film) = (image, film);

    /// <inheritdoc/>
    public int Width => _image.Width;

    /// <inheritdoc/>
    public int Height => _image.Height;

    /// <summary>Returns what is written of a film's picture, and how: without what is behind everything, where that is asked for.</summary>
    /// <param name="image">The film, or a picture that was made of it.</param>
    /// <param name="film">The film, with <see cref="FilmPlane.Alpha"/> where that is needed.</param>
    /// <param name="options">The options of its file.</param>
    public static (IImageRows Image, ImageWriteOptions Options) Of(IImageRows image, Film film, ImageWriteOptions options)
    {
        if (!options.Transparent)
        {
            return (image, options);
        }

        TransparentRows rows = new(image, film);
        return (rows, options with { Alpha = rows.ReadAlpha });
    }

    /// <inheritdoc/>
    public void ReadRow(int y, Span<float> rgb)
    {
        _image.ReadRow(y, rgb);
        for (int x = 0; x < Width; x++)
        {
            Rgb behind = _film.Backdrop(x, y);
            if (_image != _film && _film.Planes.Contains(FilmPlane.Matte))
            {
                behind = Share(behind, _film.Mean(x, y), new(rgb[3 * x], rgb[(3 * x) + 1], rgb[(3 * x) + 2]));
            }

            rgb[3 * x] -= behind.R;
            rgb[(3 * x) + 1] -= behind.G;
            rgb[(3 * x) + 2] -= behind.B;
        }
    }

    // What stands for a thing of a photograph is as noisy as the film: of a picture without noise, its share is taken.
    private static Rgb Share(Rgb behind, Rgb all, Rgb image) => new(
        all.R > 0 ? behind.R / all.R * image.R : 0, all.G > 0 ? behind.G / all.G * image.G : 0, all.B > 0 ? behind.B / all.B * image.B : 0);

    private void ReadAlpha(int y, Span<float> alpha)
    {
        for (int x = 0; x < Width; x++)
        {
            alpha[x] = float.Clamp(_film.Alpha(x, y), 0, 1);
        }
    }
}

/// <summary>A premultiplied picture as straight colours: the light of what is seen, wherever it is seen at all.</summary>
/// <param name="image">The picture.</param>
/// <param name="readAlpha">Writes how opaque the pixels of a row are, 0 to 1.</param>
internal sealed class StraightRows(IImageRows image, Action<int, Span<float>> readAlpha) : IImageRows
{
    private readonly float[] _alpha = new float[image.Width];

    /// <inheritdoc/>
    public int Width => image.Width;

    /// <inheritdoc/>
    public int Height => image.Height;

    /// <inheritdoc/>
    public void ReadRow(int y, Span<float> rgb)
    {
        image.ReadRow(y, rgb);
        readAlpha(y, _alpha);
        for (int i = 0; i < 3 * Width; i++)
        {
            rgb[i] = _alpha[i / 3] > 0 ? rgb[i] / _alpha[i / 3] : 0;
        }
    }
}
