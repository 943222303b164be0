using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>The reference implementation's own test pictures: what is read has the values that the reference implementation finds.</summary>
public class ExrCorpusTests
{
    // One picture in every lossless compression.
    private static readonly string[] s_lossless = ["comp_none", "comp_piz", "comp_rle", "comp_zip", "comp_zips"];

    // Files of these, and none other, are within what is read: RGB or Y, of rows or tiles, in any compression but DWAA and DWAB.
    private static readonly string[] s_readable =
    [
        .. s_lossless, "comp_b44_piz", "comp_dwaa_piz", "comp_dwab_piz", "lineOrder_decreasing", "lineOrder_increasing", "scanline_with_deepscanline_type",
        "scanline_with_deeptiled_type", "scanline_with_tiledimage_type", "test_native1",
        "tiled_with_deepscanline_type", "tiled_with_deeptile_type", "tiled_with_scanlineimage_type", "test_native2", "v1.7.test.1", "v1.7.test.planar",
    ];

    [SkippableFact]
    public void Files_within_what_is_read_have_the_values_of_the_reference_implementation()
    {
        string[] files = [.. Corpora.Files(".exr").Where(IsReadable)];
        ImageMagick.SkipUnlessThere();
        Assert.Equal(s_readable.Length, files.Length);
        using TemporaryFolder folder = new();
        foreach (string file in files)
        {
            // We read the data window, and ImageMagick puts it into the display window; in two files they differ, and it begins at 20,20.
            Picture picture = ImageFile.Read(file);
            ImageMagick.Convert(file, "-crop", $"{picture.Width}x{picture.Height}+{(Path.GetFileName(file).StartsWith("v1.7", StringComparison.Ordinal) ? "20+20" : "0+0")}", "+repage", folder["a.pfm"]);
            Picture expected = ImageFile.Read(folder["a.pfm"]);
            ImageAssert.Matches(picture, expected, ImageMagickTests.FloatRounding, $"corpus {Path.GetFileName(file)}");
        }
    }

    [SkippableFact]
    public void Lossless_compressions_of_one_picture_have_the_same_bits()
    {
        Picture[] pictures = [.. Corpora.Files(".exr").Where(f => s_lossless.Contains(Path.GetFileNameWithoutExtension(f))).Select(f => ImageFile.Read(f))];
        Assert.Equal(s_lossless.Length, pictures.Length);
        Assert.All(pictures, picture => TestPictures.AssertSameBits(pictures[0], picture));
    }

    [SkippableTheory]
    [InlineData("comp_b44.exr", "channels BY, RY, Y")]
    [InlineData("comp_dwaa_v2.exr", "compression is DWAA")]
    [InlineData("comp_dwab_v1.exr", "compression is DWAB")]
    [InlineData("invalid_shared_attrs_multipart.exr", "channels FLOAT")]
    [InlineData("tiled.exr", "a tile of a smaller copy")]
    [InlineData("v1.7.test.tiled.exr", "channels G, Z")]
    [InlineData("v1.7.test.interleaved.exr", "channels R, Z")]
    public void Files_beyond_what_is_read_are_refused_by_the_name_of_the_feature(string name, string reason)
    {
        string file = Assert.Single(Corpora.Files(".exr"), f => Path.GetFileName(f) == name);
        Assert.Contains(reason, TestPictures.Refusal(File.ReadAllBytes(file)), StringComparison.Ordinal);
    }

    [SkippableFact]
    public void All_others_are_refused_with_a_reason() => Assert.All(
        Corpora.Files(".exr").Where(f => !IsReadable(f)),
        file => Assert.NotEmpty(TestPictures.Refusal(File.ReadAllBytes(file))));

    private static bool IsReadable(string path) => s_readable.Contains(Path.GetFileNameWithoutExtension(path));
}
