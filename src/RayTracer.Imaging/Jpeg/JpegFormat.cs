using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>JPEG (<see cref="JpegReader"/>, <see cref="JpegWriter"/>).</summary>
internal sealed class JpegFormat : ImageFormat
{
    public override string Name => "JPEG";

    public override IReadOnlyList<string> Extensions => [".jpg", ".jpeg"];

    public override ImageFeatures Features => ImageFeatures.Display | ImageFeatures.Quality | ImageFeatures.Chroma | ImageFeatures.Texts;

    public override int MaxSide => JpegWriter.MaxSide;

    public override string MediaType => "image/jpeg";

    public override bool Matches(ReadOnlySpan<byte> head) => head.StartsWith(JpegReader.Signature);

    public override Picture Read(ReadOnlySpan<byte> file, bool raw) => JpegReader.Read(file, raw);

    public override ImageDescription Describe(ReadOnlySpan<byte> file) => JpegReader.Describe(file);

    public override IReadOnlyList<KeyValuePair<string, string>> ReadText(ReadOnlySpan<byte> file) => JpegReader.ReadText(file);

    public override void Write(Stream output, IImageRows image, ImageWriteOptions options) =>
        JpegWriter.Write(output, image, options.JpegQuality, options.JpegChroma, options.Metadata);
}
