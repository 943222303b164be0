using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>PngSuite and other public PNG files, against ImageMagick and pngcheck.</summary>
[Trait("Category", "Thorough")]
public class PngCorpusTests
{
    private static readonly string[] s_damaged = ["x", "invalid-", "bad", "huge_"];

    [SkippableFact]
    public void Sound_files_have_the_same_samples_as_with_ImageMagick()
    {
        string[] files = [.. Corpora.Files(".png").Where(f => !IsDamaged(f))];
        ImageMagick.SkipUnlessThere();
        using TemporaryFolder folder = new();
        ImageMagick.Convert([.. files, "-strip", "-set", "colorspace", "sRGB", "-alpha", "off", "-depth", "16", "+adjoin", folder["%03d.ppm"]]);
        List<string> wrong = [];
        for (int i = 0; i < files.Length; i++)
        {
            (int width, int height, int[] expected) = ImageMagick.ReadPpm(folder[$"{i:D3}.ppm"]);
            Picture raw = ImageFile.Read(files[i], raw: true);
            int[] actual = [.. raw.Pixels.Select(v => (int)Math.Round(65535 * (double)v))];
            if ((width, height) != (raw.Width, raw.Height) || !expected.SequenceEqual(actual))
            {
                wrong.Add($"{Path.GetFileName(files[i])}: {width}×{height}, {expected.Zip(actual, (a, b) => Math.Abs(a - b)).Max()}");
            }
        }

        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    [SkippableFact]
    public void Damaged_files_are_refused_with_a_reason()
    {
        string[] files = [.. Corpora.Files(".png").Where(IsDamaged)];
        Assert.True(files.Length >= 5, "there are no damaged files");
        Assert.All(files, file => Assert.NotEmpty(TestPictures.Refusal(File.ReadAllBytes(file))));
    }

    [SkippableFact]
    public void Further_damage_to_any_file_gives_nothing_but_a_PictureException()
    {
        foreach (string file in Corpora.Files(".png"))
        {
            TestPictures.Fuzz(File.ReadAllBytes(file), f => ImageFile.Decode(f), TestPng.MendChecksums, TestSettings.Scale(15, 150));
        }
    }

    private static bool IsDamaged(string path) => s_damaged.Any(prefix => Path.GetFileName(path).StartsWith(prefix, StringComparison.Ordinal));
}
