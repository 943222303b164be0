using System.Text;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Extensions.Tests;

/// <summary>Portable pixmaps (Netpbm's binary PPM): eight bits a channel.</summary>
public sealed class PpmFormat : ImageFormat
{
    /// <inheritdoc/>
    public override string Name => "PPM";

    /// <inheritdoc/>
    public override IReadOnlyList<string> Extensions => [".ppm", ".pnm"];

    /// <inheritdoc/>
    public override ImageFeatures Features => ImageFeatures.Display;

    /// <inheritdoc/>
    public override int MaxSide => 9999;

    /// <inheritdoc/>
    public override string MediaType => "image/x-portable-pixmap";

    /// <inheritdoc/>
    public override bool Matches(ReadOnlySpan<byte> head) => head.StartsWith("P6\n"u8);

    /// <inheritdoc/>
    public override Picture Read(ReadOnlySpan<byte> file, bool raw)
    {
        string[] words = Encoding.ASCII.GetString(file[..Math.Min(file.Length, 32)]).Split(' ', '\n');
        Picture picture = new(int.Parse(words[1], null), int.Parse(words[2], null));
        ReadOnlySpan<byte> codes = file[^picture.Pixels.Length..];
        for (int i = 0; i < codes.Length; i++)
        {
            picture.Pixels[i] = raw ? codes[i] / 255f : (float)SrgbCurve.Decode(codes[i] / 255.0);
        }

        return picture;
    }

    /// <inheritdoc/>
    public override void Write(Stream output, IImageRows image, ImageWriteOptions options)
    {
        output.Write(Encoding.ASCII.GetBytes($"P6\n{image.Width} {image.Height}\n255\n"));
        float[] row = new float[3 * image.Width];
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, row);
            output.Write([.. row.Select(SrgbCurve.Encode8)]);
        }
    }
}
