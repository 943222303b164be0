using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>The pictures of a glTF file: within it, embedded as URIs, or beside it; each is decoded once.</summary>
internal sealed class GltfImages(GltfDocument document, GltfBuffers buffers, GltfFiles files)
{
    private readonly Dictionary<int, Picture> _pictures = [];
    private readonly Dictionary<int, float[]> _means = [];
    private long _pixels;

    /// <summary>A picture, decoded from sRGB.</summary>
    /// <param name="index">Which of the file's images: an index that has been checked.</param>
    public Picture Picture(int index)
    {
        if (!_pictures.TryGetValue(index, out Picture? picture))
        {
            picture = Decode(index, raw: false);
            _pixels += (long)picture.Width * picture.Height;
            if (_pixels > PictureLimits.MaxPixels)
            {
                throw document.List("images")[index].Error($"the pictures have more than {PictureLimits.MaxPixels} pixels together");
            }

            _pictures.Add(index, picture);
        }

        return picture;
    }

    /// <summary>The mean of each channel of a picture whose numbers are data, 0 to 1.</summary>
    /// <param name="index">Which of the file's images: an index that has been checked.</param>
    public IReadOnlyList<float> RawMean(int index)
    {
        if (!_means.TryGetValue(index, out float[]? mean))
        {
            mean = Mean(Decode(index, raw: true));
            _means.Add(index, mean);
        }

        return mean;
    }

    /// <summary>The mean colour of a picture that is decoded from sRGB.</summary>
    /// <param name="index">Which of the file's images: an index that has been checked.</param>
    public Rgb Mean(int index) => Mean(Picture(index)) is [var r, var g, var b] ? new(r, g, b) : default;

    private static float[] Mean(Picture picture)
    {
        double[] sums = new double[3];
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            sums[i % 3] += picture.Pixels[i];
        }

        return [.. sums.Select(s => (float)(3 * s / picture.Pixels.Length))];
    }

    private Picture Decode(int index, bool raw)
    {
        GltfObject image = document.List("images")[index];
        try
        {
            return ImageFile.Decode(Content(image).Span, raw);
        }
        catch (PictureException e)
        {
            throw image.Error($"the picture cannot be read: {e.Message.TrimEnd('.')}");
        }
    }

    private ReadOnlyMemory<byte> Content(GltfObject image) =>
        document.Reference(image, "bufferView", "bufferViews") is { } view ? buffers.View(view).Bytes
        : image.Text("uri") is { } uri ? files.Read(image, uri)
        : throw image.Error("it has neither \"uri\" nor \"bufferView\"");
}
