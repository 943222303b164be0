using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>
/// A picture whose lights are layers of their own, so that each can be made brighter, darker or coloured after rendering.
/// </summary>
public sealed class RelightableImage
{
    private const string Channels = "RGB";
    private readonly byte[] _file;

    private RelightableImage(byte[] file, IReadOnlyList<string> lights)
    {
        _file = file;
        Lights = lights;
    }

    /// <summary>The lights' names, in alphabetic order.</summary>
    public IReadOnlyList<string> Lights { get; }

    /// <summary>Opens a file.</summary>
    /// <param name="file">The whole OpenEXR file.</param>
    /// <exception cref="PictureException">It is no OpenEXR file that is read, or has no layers of lights.</exception>
    public static RelightableImage Open(byte[] file)
    {
        Require(file.AsSpan().StartsWith(ExrReader.Signature), "it is not an OpenEXR file, and only those have layers of lights");

        HashSet<string> channels = [.. ExrReader.ChannelNames(file)];
        string[] lights = [.. channels
            .Where(c => c.StartsWith(LightPathAovFilm.LightPrefix, StringComparison.Ordinal) && c.EndsWith(".R", StringComparison.Ordinal))
            .Select(c => c[LightPathAovFilm.LightPrefix.Length..^2])
            .Where(light => light.Length > 0 && Channels.All(c => channels.Contains(Channel(light, c))))
            .Order(StringComparer.Ordinal)];
        return lights.Length > 0 ? new(file, lights) : throw new PictureException("it has no layers of lights");
    }

    /// <summary>The sum of all lights, each times its factor.</summary>
    /// <param name="factor">The factor of a light of <see cref="Lights"/>.</param>
    /// <exception cref="PictureException">The file is damaged.</exception>
    public Picture Compose(Func<string, Rgb> factor)
    {
        Dictionary<string, (int, float)> parts = [];
        foreach (string light in Lights)
        {
            Rgb f = factor(light);
            float[] factors = [f.R, f.G, f.B];
            for (int i = 0; i < 3; i++)
            {
                parts.Add(Channel(light, Channels[i]), (i, factors[i]));
            }
        }

        return ExrReader.Sum(_file, parts);
    }

    /// <summary>
    /// The share of the file's picture that the lights lack, or have too much: the mean difference over the mean, both in absolute values.
    /// That picture may be rounded to halves, which costs at most 0.0005.
    /// </summary>
    /// <exception cref="PictureException">The file is damaged, or has no picture but the layers.</exception>
    public double Missing()
    {
        Picture picture = ExrReader.Read(_file);
        Picture sum = Compose(_ => Rgb.White);
        (double difference, double all) = (0, 0);
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            double off = (double)picture.Pixels[i] - sum.Pixels[i];
            if (double.IsFinite(off) && float.Abs(picture.Pixels[i]) < (float)Half.MaxValue)
            {
                difference += double.Abs(off);
                all += float.Abs(picture.Pixels[i]);
            }
        }

        return difference == 0 ? 0 : difference / all;
    }

    private static string Channel(string light, char channel) => $"{LightPathAovFilm.LightPrefix}{light}.{channel}";
}
