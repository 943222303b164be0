using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>Files that we write, read by ImageMagick; and files that it writes, read by us.</summary>
public class ImageMagickTests
{
    /// <summary>ImageMagick keeps 65535 times the value as a float, which rounds twice; its OpenEXR does so from halves, exactly.</summary>
    internal static readonly ImageRule FloatRounding = ImageRule.Within(1e-9, 3e-7);

    private static readonly Picture s_picture = TestPictures.Noise(37, 23);

    // Values of all sizes: the mean of the noise times powers of 16, some below zero.
    private static readonly Picture s_light = new(
        37, 23, [.. s_picture.Pixels.Select((v, i) => v * MathF.Pow(16, (i % 5) - 2))]);

    [SkippableTheory]
    [InlineData(8)]
    [InlineData(16)]
    public void Our_PNG_is_read_with_the_nearest_codes_of_the_sRGB_curve(int bitDepth)
    {
        ImageMagick.SkipUnlessThere();
        using TemporaryFolder folder = new();
        ImageFile.Write(folder["a.png"], s_picture, new() { BitDepth = bitDepth });
        ImageMagick.Convert(folder["a.png"], "-depth", "16", folder["a.ppm"]);
        (int width, int height, int[] samples) = ImageMagick.ReadPpm(folder["a.ppm"]);
        Assert.Equal((37, 23), (width, height));
        int step = bitDepth == 8 ? 257 : 1;
        Assert.Equal(s_picture.Pixels.Select(v => step * (int)Math.Round(Srgb(v) * 65535 / step)), samples);
    }

    [SkippableFact]
    public void Our_PFM_and_OpenEXR_are_read_with_their_values()
    {
        ImageMagick.SkipUnlessThere();
        using TemporaryFolder folder = new();
        Picture halves = new(37, 23, [.. s_light.Pixels.Select(v => (float)(Half)v)]);
        ImageFile.Write(folder["a.pfm"], s_light);
        ImageMagick.Convert(folder["a.pfm"], "-endian", "MSB", folder["b.pfm"]);
        ImageAssert.Matches(ImageFile.Read(folder["b.pfm"]), s_light, FloatRounding, "ImageMagick reads PFM");
        foreach (ExrCompression compression in Enum.GetValues<ExrCompression>())
        {
            ImageFile.Write(folder["a.exr"], s_light, new() { ExrCompression = compression });
            ImageMagick.Convert(folder["a.exr"], folder["b.pfm"]);
            ImageAssert.Matches(ImageFile.Read(folder["b.pfm"]), halves, FloatRounding, $"ImageMagick reads OpenEXR {compression}");
        }
    }

    // The values come as text of its own, so that no second reader of ours stands in for the first.
    [SkippableFact]
    public void The_first_rows_of_our_files_are_at_the_top()
    {
        ImageMagick.SkipUnlessThere();
        using TemporaryFolder folder = new();
        Picture picture = new(2, 3, [1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 1, 1, 1, 0, 1]);
        foreach (string file in (string[])["a.png", "a.pfm", "a.exr"])
        {
            ImageFile.Write(folder[file], picture);
            ImageMagick.Convert(folder[file], "-depth", "16", folder["a.ppm"]);
            Assert.Equal(picture.Pixels.Select(v => (int)(65535 * v)), ImageMagick.ReadPpm(folder["a.ppm"]).Samples);
        }
    }

    public static TheoryData<string[]> PngKinds => new(
        [
            ["png24"], ["png24", "-interlace", "PNG"], ["png32"], ["png48"], ["png48", "-interlace", "PNG"], ["png64"],
            ["png8", "-colors", "200", "-dither", "None"], ["png8", "-colors", "16", "-dither", "None"], ["png8", "-colors", "4", "-dither", "None", "-interlace", "PNG"],
            ["png", "-colorspace", "Gray", "-depth", "8"], ["png", "-colorspace", "Gray", "-depth", "16"], ["png", "-monochrome"],
            ["png24", "-quality", "10"], ["png24", "-quality", "91"], ["png24", "-quality", "92"], ["png24", "-quality", "93"], ["png24", "-quality", "94"], ["png24", "-quality", "95"],
            ["png", "-define", "png:color-type=4", "-colorspace", "Gray", "-alpha", "on"],
        ]);

    [SkippableTheory]
    [MemberData(nameof(PngKinds))]
    public void Its_PNG_of_every_kind_is_read_with_its_samples(string[] kind)
    {
        ImageMagick.SkipUnlessThere();
        using TemporaryFolder folder = new();
        ImageFile.Write(folder["source.png"], s_picture, new() { BitDepth = 16 });
        ImageMagick.Convert([folder["source.png"], .. kind[1..], $"{kind[0]}:{folder["a.png"]}"]);
        ImageMagick.Convert(folder["a.png"], "-alpha", "off", "-depth", "16", folder["a.ppm"]);
        Picture read = ImageFile.Read(folder["a.png"], raw: true);
        Assert.Equal(ImageMagick.ReadPpm(folder["a.ppm"]).Samples, read.Pixels.Select(v => (int)Math.Round(65535 * (double)v)));
    }

    [SkippableTheory]
    [InlineData("MSB", 3)]
    [InlineData("LSB", 3)]
    [InlineData("MSB", 1)]
    [InlineData("LSB", 1)]
    public void Its_PFM_of_both_byte_orders_and_colour_counts_is_read(string endian, int channels)
    {
        ImageMagick.SkipUnlessThere();
        using TemporaryFolder folder = new();
        ImageFile.Write(folder["source.pfm"], s_light);
        string[] grey = channels == 1 ? ["-set", "colorspace", "RGB", "-channel", "G", "-separate"] : [];
        ImageMagick.Convert([folder["source.pfm"], .. grey, "-endian", endian, folder["a.pfm"]]);
        Assert.Equal(channels == 1 ? "Pf" : "PF", System.Text.Encoding.ASCII.GetString(File.ReadAllBytes(folder["a.pfm"]), 0, 2));
        Picture expected = channels == 1 ? new(37, 23, [.. s_light.Pixels.Select((_, i) => s_light.Pixels[i - (i % 3) + 1])]) : s_light;
        ImageAssert.Matches(ImageFile.Read(folder["a.pfm"]), expected, FloatRounding, $"ImageMagick writes PFM {endian} {channels}");
    }

    // A half has 11 bits: the rounding of ImageMagick's floats does not reach them.
    [SkippableTheory]
    [InlineData("None")]
    [InlineData("ZipS")]
    [InlineData("Zip")]
    [InlineData("Piz")]
    [InlineData("Pxr24")]
    public void Its_OpenEXR_is_read_with_the_bits_of_its_halves(string compression)
    {
        ImageMagick.SkipUnlessThere();
        using TemporaryFolder folder = new();
        Picture halves = new(37, 23, [.. s_light.Pixels.Select(v => (float)(Half)v)]);
        ImageFile.Write(folder["source.pfm"], halves);
        ImageMagick.Convert(folder["source.pfm"], "-compress", compression, folder["a.exr"]);
        TestPictures.AssertSameBits(halves, ImageFile.Read(folder["a.exr"]));
    }

    // IEC 61966-2-1, written here a second time.
    private static double Srgb(double linear)
    {
        double light = Math.Clamp(linear, 0, 1);
        return light <= 0.0031308 ? 12.92 * light : (1.055 * Math.Pow(light, 1 / 2.4)) - 0.055;
    }
}
