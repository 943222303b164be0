using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Portable float maps (<see cref="PfmReader"/>, <see cref="PfmWriter"/>).</summary>
internal sealed class PfmFormat : ImageFormat
{
    public override string Name => "PFM";

    public override IReadOnlyList<string> Extensions => [".pfm"];

    public override bool Matches(ReadOnlySpan<byte> head) => PfmReader.IsPfm(head);

    public override Picture Read(ReadOnlySpan<byte> file, bool raw) => PfmReader.Read(file);

    public override ImageDescription Describe(ReadOnlySpan<byte> file) => PfmReader.Describe(file);

    public override void Write(Stream output, IImageRows image, ImageWriteOptions options) => PfmWriter.Write(output, image);
}
