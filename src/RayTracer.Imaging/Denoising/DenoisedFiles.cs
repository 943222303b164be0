using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Denoised pictures as files and layers of files.</summary>
internal static class DenoisedFiles
{
    private const string Name = "denoised";

    /// <summary>The file beside a picture, where its format holds no layers: <c>out.denoised.png</c> beside <c>out.png</c>.</summary>
    public static string Beside(string path) => Path.ChangeExtension(path, $".{Name}{Path.GetExtension(path)}");

    /// <summary>The layers of an OpenEXR file.</summary>
    public static IReadOnlyList<ExrLayerChannel> Layers(IImageRows denoised)
    {
        float[] row = new float[3 * denoised.Width];
        return [.. "RGB".Select((letter, channel) => new ExrLayerChannel($"{Name}.{letter}", ExrPixelType.Float, (y, values) =>
        {
            denoised.ReadRow(y, row);
            for (int x = 0; x < denoised.Width; x++)
            {
                values.Span[x] = row[(3 * x) + channel];
            }
        }))];
    }
}
