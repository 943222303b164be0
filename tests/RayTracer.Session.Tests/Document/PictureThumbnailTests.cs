using RayTracer.Imaging;
using RayTracer.Session;
using RayTracer.Textures;

namespace RayTracer.Session.Tests;

public sealed class PictureThumbnailTests : IDisposable
{
    private readonly SessionFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Pictures_become_small_and_keep_their_mean()
    {
        Picture picture = new(500, 330);
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            picture.Pixels[i] = i / 3 % 2;
        }

        ImageFile.Write(_folder["wide.exr"], picture);
        Picture small = ImageFile.Decode(PictureThumbnail.Png(_folder["wide.exr"]));
        Assert.Equal((166, 110), (small.Width, small.Height));
        Assert.InRange(small.Pixels.Average(), 0.48f, 0.52f);
        ImageFile.Write(_folder["line.png"], new Picture(1000, 2));
        Assert.Equal(1, ImageFile.Decode(PictureThumbnail.Png(_folder["line.png"])).Height);
    }

    [Fact]
    public void What_is_no_picture_is_refused()
    {
        Assert.Throws<SessionException>(() => PictureThumbnail.Png(_folder.Write("broken.png", "no picture")));
        Assert.Throws<SessionException>(() => PictureThumbnail.Png(_folder.Write("scene.json", "{}")));
        Assert.Throws<SessionException>(() => PictureThumbnail.Png(_folder["missing.png"]));
    }
}
