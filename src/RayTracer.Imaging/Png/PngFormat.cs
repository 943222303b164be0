using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Portable Network Graphics (<see cref="PngReader"/>, <see cref="PngWriter"/>).</summary>
internal sealed class PngFormat : ImageFormat
{
    public override string Name => "PNG";

    public override IReadOnlyList<string> Extensions => [".png"];

    public override ImageFeatures Features => ImageFeatures.Display | ImageFeatures.BitDepth | ImageFeatures.Texts | ImageFeatures.Alpha;

    public override string MediaType => "image/png";

    public override bool Matches(ReadOnlySpan<byte> head) => head.StartsWith(PngReader.Signature);

    public override Picture Read(ReadOnlySpan<byte> file, bool raw) => PngReader.Read(file, raw);

    public override Picture? ReadAlpha(ReadOnlySpan<byte> file) => PngReader.ReadAlpha(file);

    public override ImageDescription Describe(ReadOnlySpan<byte> file) => PngReader.Describe(file);

    public override IReadOnlyList<KeyValuePair<string, string>> ReadText(ReadOnlySpan<byte> file) => PngReader.ReadText(file);

    public override void Write(Stream output, IImageRows image, ImageWriteOptions options) =>
        PngWriter.Write(output, image, options.BitDepth, options.Metadata, options.Alpha);
}
