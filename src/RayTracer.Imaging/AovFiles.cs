using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>How auxiliary images are called and stored in files.</summary>
public static class AovFiles
{
    /// <summary>The name of an image, as users write it and files have it.</summary>
    public static string Name(Aov kind) => kind.ToString() is var name ? $"{char.ToLowerInvariant(name[0])}{name[1..]}" : "";

    /// <summary>The file beside a picture that an image is written to, where the picture's format holds no layers: <c>out.depth.png</c> beside <c>out.png</c>.</summary>
    public static string Beside(string path, Aov kind) => Beside(path, Name(kind));

    /// <summary>As for auxiliary images, of a layer of any name.</summary>
    /// <param name="path">The picture's file.</param>
    /// <param name="name">The image's name.</param>
    public static string Beside(string path, string name) => Path.ChangeExtension(path, $".{name}{Path.GetExtension(path)}");

    /// <summary>The image as it is written to a file of its own.</summary>
    /// <param name="path">The file: a PNG or JPEG holds colours to look at, any other the numbers.</param>
    /// <param name="film">The images.</param>
    /// <param name="kind">Which of them.</param>
    /// <returns>The image, and what its colours mean.</returns>
    public static (IImageRows Image, string Range) Rows(string path, AovFilm film, Aov kind)
    {
        if (!ImageFormat.Has(path, ImageFeatures.Display))
        {
            return (new AovRows(film, kind), "");
        }

        AovPicture picture = new(film, kind);
        return (picture, picture.Range);
    }

    /// <summary>The layers of an OpenEXR file: means as 32-bit floats, whole numbers as such.</summary>
    public static IReadOnlyList<ExrLayerChannel> Layers(AovFilm film)
    {
        List<ExrLayerChannel> layers = [];
        foreach (Aov kind in film.Kinds)
        {
            int channels = AovFilm.Channels(kind);
            double[] row = new double[film.Width * channels];
            for (int i = 0; i < channels; i++)
            {
                int channel = i;
                layers.Add(new($"{Name(kind)}.{Letters(kind)[i]}", AovFilm.IsWhole(kind) ? ExrPixelType.Uint : ExrPixelType.Float, (y, values) =>
                {
                    film.ReadRow(kind, y, row);
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
    public static IReadOnlyList<ExrLayerChannel> Layers(LightLayerFilm film)
    {
        List<ExrLayerChannel> layers = [];
        for (int i = 0; i < film.Names.Count; i++)
        {
            IImageRows image = film.Image(i);
            float[] row = new float[3 * image.Width];
            for (int c = 0; c < 3; c++)
            {
                int channel = c;
                layers.Add(new($"{film.Names[i]}.{"RGB"[c]}", ExrPixelType.Float, (y, values) =>
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

    private static string Letters(Aov kind) => kind switch
    {
        Aov.Depth => "Z",
        Aov.Normal => "XYZ",
        Aov.Albedo => "RGB",
        Aov.Uv => "UV",
        _ => "Y",
    };
}
