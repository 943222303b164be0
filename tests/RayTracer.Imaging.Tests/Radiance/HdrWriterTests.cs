using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>Radiance pictures as they are written: read by the own reader, and by ImageMagick.</summary>
public sealed class HdrWriterTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(1, 1)]
    [InlineData(7, 3)]
    [InlineData(8, 3)]
    [InlineData(300, 5)]
    [InlineData(33000, 1)]
    public void Values_are_off_by_less_than_their_pixels_largest_over_255(int width, int height)
    {
        Random random = new(width);
        Picture picture = new(width, height, [.. Enumerable.Range(0, 3 * width * height).Select(i => i % 40 < 25 ? i / 60 : (float)(random.NextDouble() * Math.Pow(2, random.Next(-60, 60))))]);
        ImageFile.Write(_folder["a.hdr"], picture);
        AssertClose(picture, ImageFile.Read(_folder["a.hdr"]));
    }

    [Fact]
    public void Numbers_that_the_format_lacks_are_the_nearest_that_it_has()
    {
        Picture picture = new(2, 2, [float.NaN, -1, 0.5f, float.PositiveInfinity, 0, 1, 1e-44f, 0, 0, 255.7f, 1, 254.4f]);
        ImageFile.Write(_folder["a.hdr"], picture);
        Picture read = ImageFile.Read(_folder["a.hdr"]);
        Assert.Equal([0, 0, 0.5f, 255 * MathF.Pow(2, 119), 0, 0, 0, 0, 0, 256, 0, 254], read.Pixels.Select(v => v == 0 ? 0 : v));
    }

    [Fact]
    public void Texts_are_comments_that_are_read_again()
    {
        string longest = new('x', 65_000);
        KeyValuePair<string, string>[] texts = [new("Command", "raytracer render 'a b.json'"), new("Key", "λ: μ"), new("Long", longest), new("Lines", "1\n\n2"), new("TooLong", longest + longest), new("Last", "")];
        Picture picture = TestPictures.Noise(9, 4);
        ImageFile.Write(_folder["plain.hdr"], picture);
        ImageFile.Write(_folder["a.hdr"], picture, new() { Metadata = texts });
        Assert.Equal(texts.Where(t => t.Key is not ("Lines" or "TooLong")), ImageFile.ReadText(_folder["a.hdr"]));
        TestPictures.AssertSameBits(ImageFile.Read(_folder["plain.hdr"]), ImageFile.Read(_folder["a.hdr"]));
        File.WriteAllText(_folder["b.hdr"], "#?RADIANCE\n#by hand\nSOFTWARE=pfilt\npfilt -x 2\nFORMAT=32-bit_rle_rgbe\n\n");
        Assert.Equal([new("Comment", "by hand"), new("SOFTWARE", "pfilt")], ImageFile.ReadText(_folder["b.hdr"]));
    }

    [SkippableFact]
    public void ImageMagick_reads_what_is_written()
    {
        ImageMagick.SkipUnlessThere();
        Picture picture = TestPictures.Noise(40, 30);

        // There are no numbers below zero in the format.
        picture = new(picture.Width, picture.Height, [.. picture.Pixels.Select(v => MathF.Max(v, 0))]);
        ImageFile.Write(_folder["a.hdr"], picture, new() { Metadata = [new("Command", new string('x', 300)), new("Scene", "λ")] });
        ImageMagick.Convert(_folder["a.hdr"], "-strip", "+set", "comment", _folder["a.pfm"]);
        AssertClose(picture, ImageFile.Read(_folder["a.pfm"]));
    }

    private static void AssertClose(Picture expected, Picture actual)
    {
        Assert.Equal((expected.Width, expected.Height), (actual.Width, actual.Height));
        for (int i = 0; i < expected.Pixels.Length; i += 3)
        {
            float largest = expected.Pixels.AsSpan(i, 3).ToArray().Max();
            for (int k = 0; k < 3; k++)
            {
                Assert.Equal(expected.Pixels[i + k], actual.Pixels[i + k], largest / 250);
            }
        }
    }
}
