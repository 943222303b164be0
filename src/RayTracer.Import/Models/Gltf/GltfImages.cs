using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>The pictures of a glTF file: within it, embedded as URIs, or beside it; each is decoded once.</summary>
internal sealed class GltfImages(GltfDocument document, GltfBuffers buffers, GltfFiles files)
{
    private readonly Dictionary<(int Image, GltfChannel Channel), Picture?> _pictures = [];
    private long _pixels;

    /// <summary>A picture, or what one of its channels says.</summary>
    /// <param name="index">Which of the file's images: an index that has been checked.</param>
    /// <param name="channel">The channel wanted: colours are decoded from sRGB, all else is taken as it is.</param>
    /// <returns>The picture; null for the opacity of one that has none.</returns>
    public Picture? Picture(int index, GltfChannel channel = GltfChannel.Color)
    {
        if (!_pictures.TryGetValue((index, channel), out Picture? picture))
        {
            picture = Decode(index, channel);
            _pixels += (long)(picture?.Width ?? 0) * (picture?.Height ?? 0);
            if (_pixels > PictureLimits.MaxPixels)
            {
                throw document.List("images")[index].Error($"the pictures have more than {PictureLimits.MaxPixels} pixels together");
            }

            _pictures.Add((index, channel), picture);
        }

        return picture;
    }

    /// <summary>The mean of a picture's pixels.</summary>
    public static Rgb Mean(Picture picture)
    {
        double[] sums = new double[3];
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            sums[i % 3] += picture.Pixels[i];
        }

        float[] means = [.. sums.Select(s => (float)(3 * s / picture.Pixels.Length))];
        return new(means[0], means[1], means[2]);
    }

    private Picture? Decode(int index, GltfChannel channel)
    {
        GltfObject image = document.List("images")[index];
        if (!StandIn.IsError && image.Text("uri") is { } uri && files.IsMissing(uri))
        {
            document.Notes.Add($"the picture {Quotation.Of(uri)} is not there: {StandIn.Words}");
            return channel switch { GltfChannel.Alpha => null, GltfChannel.Color => StandIn.Checks, _ => StandIn.Numbers };
        }

        try
        {
            ReadOnlySpan<byte> file = Content(image).Span;
            return channel switch
            {
                GltfChannel.Alpha => ImageFile.DecodeAlpha(file),
                GltfChannel.Color or GltfChannel.All => ImageFile.Decode(file, raw: channel == GltfChannel.All),
                _ => Alone(ImageFile.Decode(file, raw: true), (int)channel),
            };
        }
        catch (PictureException e)
        {
            throw image.Error($"the picture cannot be read: {e.Message.TrimEnd('.')}");
        }
    }

    // One channel in place of all three.
    private static Picture Alone(Picture picture, int channel)
    {
        float[] pixels = picture.Pixels;
        for (int i = 0; i < pixels.Length; i += 3)
        {
            pixels.AsSpan(i, 3).Fill(pixels[i + channel]);
        }

        return picture;
    }

    private ReadOnlyMemory<byte> Content(GltfObject image) =>
        document.Reference(image, "bufferView", "bufferViews") is { } view ? buffers.View(view).Bytes
        : image.Text("uri") is { } uri ? files.Read(image, uri)
        : throw image.Error("it has neither \"uri\" nor \"bufferView\"");
}
