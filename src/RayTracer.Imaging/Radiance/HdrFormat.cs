using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Radiance pictures (<see cref="HdrReader"/>, <see cref="HdrWriter"/>).</summary>
internal sealed class HdrFormat : ImageFormat
{
    public override string Name => "Radiance HDR";

    public override IReadOnlyList<string> Extensions => [".hdr"];

    public override ImageFeatures Features => ImageFeatures.Texts;

    public override bool Matches(ReadOnlySpan<byte> head) => head.StartsWith(HdrReader.Signature);

    public override Picture Read(ReadOnlySpan<byte> file, bool raw) => HdrReader.Read(file);

    public override ImageDescription Describe(ReadOnlySpan<byte> file) => HdrReader.Describe(file);

    public override IReadOnlyList<KeyValuePair<string, string>> ReadText(ReadOnlySpan<byte> file) => HdrReader.ReadText(file);

    public override void Write(Stream output, IImageRows image, ImageWriteOptions options) =>
        HdrWriter.Write(output, image, options.Metadata);
}
