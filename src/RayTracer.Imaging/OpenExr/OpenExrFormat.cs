using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>OpenEXR (<see cref="ExrReader"/>, <see cref="ExrWriter"/>).</summary>
internal sealed class OpenExrFormat : ImageFormat
{
    public override string Name => "OpenEXR";

    public override string FileName => "an OpenEXR picture";

    public override IReadOnlyList<string> Extensions => [".exr"];

    public override ImageFeatures Features => ImageFeatures.PixelType | ImageFeatures.Texts | ImageFeatures.Layers | ImageFeatures.Alpha;

    public override bool Matches(ReadOnlySpan<byte> head) => head.StartsWith(ExrReader.Signature);

    public override Picture Read(ReadOnlySpan<byte> file, bool raw) => ExrReader.Read(file);

    public override ImageDescription Describe(ReadOnlySpan<byte> file) => ExrReader.Describe(file);

    public override IReadOnlyList<KeyValuePair<string, string>> ReadText(ReadOnlySpan<byte> file) => ExrReader.ReadText(file);

    public override IReadOnlyList<ExrLayerChannel> ReadLayers(ReadOnlySpan<byte> file) => ExrReader.ReadLayers(file);

    public override void Write(Stream output, IImageRows image, ImageWriteOptions options) =>
        ExrWriter.Write(
            output, image, options.ExrPixelType, options.ExrCompression, options.Metadata.Concat(options.ExrTexts),
            options.Alpha is { } alpha ? [.. options.ExrLayers, Alpha(image.Width, options.ExrPixelType, alpha)] : options.ExrLayers);

    private static ExrLayerChannel Alpha(int width, ExrPixelType type, Action<int, Span<float>> read)
    {
        float[] row = new float[width];
        return new(ExrFormat.Alpha, type, (y, values) =>
        {
            read(y, row);
            for (int x = 0; x < width; x++)
            {
                values.Span[x] = row[x];
            }
        });
    }
}
