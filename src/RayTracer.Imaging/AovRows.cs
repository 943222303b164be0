using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>An auxiliary image as numbers in three channels, in a separate PFM file: one number three times, or two and a zero.</summary>
/// <param name="film">The images.</param>
/// <param name="image">Which of them.</param>
public sealed class AovRows(AovFilm film, AuxiliaryImage image) : IImageRows
{
    private readonly double[] _values = new double[film.Width * image.Letters.Length];

    /// <inheritdoc/>
    public int Width => film.Width;

    /// <inheritdoc/>
    public int Height => film.Height;

    /// <inheritdoc/>
    public void ReadRow(int y, Span<float> rgb)
    {
        int channels = image.Letters.Length;
        film.ReadRow(image, y, _values);
        for (int i = 0; i < 3 * Width; i++)
        {
            int channel = i % 3;
            rgb[i] = channels == 1 ? (float)_values[i / 3] : channel < channels ? (float)_values[(i / 3 * channels) + channel] : 0;
        }
    }
}
