using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>An auxiliary image as colours that can be looked at, in a PNG file beside the picture's.</summary>
public sealed class AovPicture : IImageRows
{
    private const double BrightShare = 0.99;
    private readonly AovFilm _film;
    private readonly AuxiliaryImage _image;
    private readonly NumberRange _range;
    private readonly double[] _values;

    /// <summary>Looks for the range of the numbers.</summary>
    /// <param name="film">The images.</param>
    /// <param name="image">The image among them.</param>
    public AovPicture(AovFilm film, AuxiliaryImage image)
    {
        (_film, _image) = (film, image);
        _values = new double[film.Width * image.Letters.Length];
        (double least, double most) = (double.PositiveInfinity, double.NegativeInfinity);
        float[] all = new float[image.IsSkewed ? (long)film.Height * _values.Length : 0];
        for (int y = 0; y < Height; y++)
        {
            film.ReadRow(image, y, _values);
            for (int i = 0; i < _values.Length && all.Length > 0; i++)
            {
                all[((long)y * _values.Length) + i] = (float)_values[i];
            }

            foreach (double value in _values.Where(double.IsFinite))
            {
                (least, most) = (Math.Min(least, value), Math.Max(most, value));
            }
        }

        Array.Sort(all);
        double top = all.Length > 0 ? all[(long)(BrightShare * (all.Length - 1))] : 0;
        _range = new(least, most, top > 0 ? top : most);
    }

    /// <inheritdoc/>
    public int Width => _film.Width;

    /// <inheritdoc/>
    public int Height => _film.Height;

    /// <summary>The meaning of the colours, for the reader of the picture.</summary>
    public string Legend => _image.Legend(_range);

    /// <inheritdoc/>
    public void ReadRow(int y, Span<float> rgb)
    {
        int letters = _image.Letters.Length;
        _film.ReadRow(_image, y, _values);
        for (int x = 0; x < Width; x++)
        {
            (double r, double g, double b) = _image.Show(_values.AsSpan(x * letters, letters), _range);
            (rgb[3 * x], rgb[(3 * x) + 1], rgb[(3 * x) + 2]) = (Light(r), Light(g), Light(b));
        }
    }

    // From display values, so that what is written to the file is the number itself.
    private float Light(double shown) => (float)(_image.ShowsLight ? shown : SrgbCurve.Decode(Math.Clamp(shown, 0, 1)));
}
