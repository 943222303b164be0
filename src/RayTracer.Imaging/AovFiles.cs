using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Auxiliary images as files and layers of files.</summary>
public static class AovFiles
{
    /// <summary>The file of an image beside a picture whose format holds no layers: <c>out.depth.png</c> beside <c>out.png</c>.</summary>
    /// <param name="path">The picture's file.</param>
    /// <param name="name">The image's name.</param>
    public static string Beside(string path, string name) => Path.ChangeExtension(path, $".{name}{Path.GetExtension(path)}");

    /// <summary>The image as it is written to a separate file.</summary>
    /// <param name="path">The file: a PNG or JPEG holds colours to look at, any other the numbers.</param>
    /// <param name="film">The images.</param>
    /// <param name="image">The image among them.</param>
    /// <returns>The image, and what its colours mean.</returns>
    public static (IImageRows Image, string Range) Rows(string path, AovFilm film, AuxiliaryImage image)
    {
        if (!ImageFormat.Has(path, ImageFeatures.Display))
        {
            return (new AovRows(film, image), "");
        }

        AovPicture picture = new(film, image);
        return (picture, picture.Legend);
    }

    /// <summary>The layers of an OpenEXR file: means as 32-bit floats, whole numbers as such.</summary>
    public static IReadOnlyList<ExrLayerChannel> Layers(AovFilm film)
    {
        List<ExrLayerChannel> layers = [];
        foreach (AuxiliaryImage image in film.Images)
        {
            if (image is CryptomatteImage matte)
            {
                layers.AddRange(CryptomatteLayers.Of(film, matte));
                continue;
            }

            int channels = image.Letters.Length;
            double[] row = new double[film.Width * channels];
            for (int i = 0; i < channels; i++)
            {
                int channel = i;
                layers.Add(new($"{image.Name}.{image.Letters[i]}", image.IsWhole ? ExrPixelType.Uint : ExrPixelType.Float, (y, values) =>
                {
                    film.ReadRow(image, y, row);
                    for (int x = 0; x < film.Width; x++)
                    {
                        values.Span[x] = row[(x * channels) + channel];
                    }
                }));
            }
        }

        return layers;
    }

    /// <summary>The layers of light of an OpenEXR file, as 32-bit floats: <c>direct.R</c>, <c>light.key.R</c>.</summary>
    public static IReadOnlyList<ExrLayerChannel> Layers(LightPathAovFilm film) => Layers(film.Names.Select((name, i) => (name, film.Image(i))));

    /// <summary>Layers of light of an OpenEXR file, by their names.</summary>
    internal static IReadOnlyList<ExrLayerChannel> Layers(IEnumerable<(string Name, IImageRows Image)> images)
    {
        List<ExrLayerChannel> layers = [];
        foreach ((string name, IImageRows image) in images)
        {
            float[] row = new float[3 * image.Width];
            for (int c = 0; c < 3; c++)
            {
                int channel = c;
                layers.Add(new($"{name}.{"RGB"[c]}", ExrPixelType.Float, (y, values) =>
                {
                    image.ReadRow(y, row);
                    for (int x = 0; x < image.Width; x++)
                    {
                        values.Span[x] = row[(3 * x) + channel];
                    }
                }));
            }
        }

        return layers;
    }
}

/// <summary>An auxiliary image as numbers in three channels, in a separate PFM file: one number three times, or two and a zero.</summary>
/// <param name="film">The images.</param>
/// <param name="image">The image among them.</param>
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
