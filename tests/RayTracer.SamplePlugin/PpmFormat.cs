using System.Text;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.SamplePlugin;

/// <summary>The plain form of portable pixel maps: numbers as text. It is only written.</summary>
public sealed class PpmFormat : ImageFormat
{
    /// <inheritdoc/>
    public override string Name => "PPM";

    /// <inheritdoc/>
    public override IReadOnlyList<string> Extensions => [".ppm"];

    /// <inheritdoc/>
    public override ImageFeatures Features => ImageFeatures.Display;

    /// <inheritdoc/>
    public override bool Matches(ReadOnlySpan<byte> head) => head.StartsWith("P3"u8);

    /// <inheritdoc/>
    public override Picture Read(ReadOnlySpan<byte> file, bool raw) => throw new PictureException("pixel maps as text are only written");

    /// <inheritdoc/>
    public override void Write(Stream output, IImageRows image, ImageWriteOptions options)
    {
        StringBuilder text = new($"P3\n{image.Width} {image.Height}\n255\n");
        float[] row = new float[3 * image.Width];
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, row);
            text.AppendJoin(' ', row.Select(v => (int)float.Round(float.Clamp(v, 0, 1) * 255))).Append('\n');
        }

        output.Write(Encoding.ASCII.GetBytes(text.ToString()));
    }
}
