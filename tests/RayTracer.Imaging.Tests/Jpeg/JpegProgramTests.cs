using System.Text;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>
/// JPEG files of every kind that libjpeg-turbo's cjpeg and ImageMagick write, compared with how djpeg and ImageMagick read them.
/// </summary>
/// <remarks>
/// A decoder's transform may differ by 1 from the exact one (as IEEE 1180 demands of it, and the limits of ISO/IEC 10918-2 are wider);
/// so two decoders' grey codes differ by 1 at most. libjpeg rounds interpolated colour differences too, by up to ½ on both sides: a colour may
/// differ by 1 + 1.772 · 1.5 + ½, rounded to whole codes 4, and on average by far less.
/// </remarks>
[Trait("Category", "Thorough")]
public class JpegProgramTests
{
    private const int GreyLimit = 1;
    private const int ColourLimit = 4;
    private const double LeastDecibels = 45;

    public static TheoryData<string> Kinds => new(
        "-quality 90", "-quality 30", "-quality 100", "-quality 75 -grayscale", "-quality 90 -rgb", "-quality 90 -sample 1x1", "-quality 90 -sample 2x1", "-quality 90 -sample 1x2",
        "-quality 90 -sample 2x2", "-quality 90 -sample 4x1", "-quality 90 -sample 4x2", "-quality 90 -sample 3x1", "-quality 85 -restart 3B", "-quality 85 -restart 1", "-progressive -quality 90",
        "-progressive -quality 40 -sample 2x1 -restart 2", "-progressive -grayscale", "-progressive -quality 100 -sample 1x1", "-optimize -quality 95 -sample 1x1", "-quality 5", "-quality 2 -progressive");

    [SkippableTheory]
    [MemberData(nameof(Kinds))]
    public void A_file_of_cjpeg_is_read_as_djpeg_reads_it(string kind)
    {
        SkipUnlessThere();
        using TemporaryFolder folder = new();
        foreach ((int width, int height) in new[] { (97, 61), (16, 16), (5, 130) })
        {
            WritePpm(folder["a.ppm"], width, height);
            Run("cjpeg", [.. kind.Split(' '), "-outfile", folder["a.jpg"], folder["a.ppm"]]);
            AssertReadAsDjpegDoes(folder["a.jpg"], folder);
        }
    }

    [SkippableFact]
    public void Arithmetic_coding_is_refused()
    {
        SkipUnlessThere();
        using TemporaryFolder folder = new();
        WritePpm(folder["a.ppm"], 40, 30);
        foreach (string kind in (string[])["-arithmetic", "-arithmetic -progressive"])
        {
            Run("cjpeg", [.. kind.Split(' '), "-outfile", folder["a.jpg"], folder["a.ppm"]]);
            Assert.Contains("arithmetically coded", TestPictures.Refusal(File.ReadAllBytes(folder["a.jpg"])), StringComparison.Ordinal);
        }
    }

    // ImageMagick writes inks as Adobe does, and makes RGB of them by (1 − ink)(1 − black), with more bits than ours.
    [SkippableTheory]
    [InlineData("90", "None")]
    [InlineData("80", "Plane")]
    public void Inks_of_ImageMagick_are_read_as_it_reads_them(string quality, string interlace)
    {
        ImageMagick.SkipUnlessThere();
        using TemporaryFolder folder = new();
        WritePpm(folder["a.ppm"], 60, 41);
        ImageMagick.Convert(folder["a.ppm"], "-colorspace", "CMYK", "-quality", quality, "-interlace", interlace, folder["a.jpg"]);
        ImageMagick.Convert(folder["a.jpg"], "-colorspace", "sRGB", "-depth", "16", folder["b.ppm"]);
        int[] expected = [.. ImageMagick.ReadPpm(folder["b.ppm"]).Samples.Select(s => (int)Math.Round(s / 257.0))];
        AssertNear(expected, Codes(ImageFile.Read(folder["a.jpg"], raw: true)), ColourLimit, $"CMYK {quality} {interlace}");
    }

    // With the best Huffman codes on both sides; sizes differ with how coefficients are rounded.
    [SkippableTheory]
    [InlineData(100, JpegChroma.Full)]
    [InlineData(90, JpegChroma.Full)]
    [InlineData(90, JpegChroma.Half)]
    [InlineData(50, JpegChroma.Full)]
    [InlineData(10, JpegChroma.Half)]
    public void Our_file_is_as_small_and_as_good_as_that_of_cjpeg(int quality, JpegChroma chroma)
    {
        SkipUnlessThere();
        using TemporaryFolder folder = new();
        WritePpm(folder["a.ppm"], 201, 140);
        (int width, int height, _, int[] samples) = ReadPnm(folder["a.ppm"]);
        Run("cjpeg", "-optimize", "-quality", $"{quality}", "-sample", chroma == JpegChroma.Full ? "1x1" : "2x2", "-dct", "int", "-outfile", folder["c.jpg"], folder["a.ppm"]);
        Picture picture = new(width, height, [.. samples.Select(s => SrgbCurve.Decode8((byte)s))]);
        ImageFile.Write(folder["a.jpg"], picture, new() { JpegQuality = quality, JpegChroma = chroma });
        AssertReadAsDjpegDoes(folder["a.jpg"], folder);
        double own = Decibels(samples, Decoded("a.jpg"));
        double peers = Decibels(samples, Decoded("c.jpg"));
        Assert.True(own >= peers - 0.05, $"{own:F2} dB, and cjpeg {peers:F2}");
        Assert.InRange(new FileInfo(folder["a.jpg"]).Length, 1, (1.03 * new FileInfo(folder["c.jpg"]).Length) + 100);

        int[] Decoded(string name)
        {
            Run("djpeg", "-pnm", "-outfile", folder["d.ppm"], folder[name]);
            return ReadPnm(folder["d.ppm"]).Samples;
        }
    }

    [SkippableFact]
    public void Public_files_are_read_as_djpeg_reads_them_or_refused_for_their_kind()
    {
        string[] files = [.. Corpora.Files(".jpeg", 10), .. Corpora.Files(".jpg", 3)];
        SkipUnlessThere();
        using TemporaryFolder folder = new();
        foreach (string file in files)
        {
            try
            {
                AssertReadAsDjpegDoes(file, folder);
            }
            catch (PictureException e)
            {
                Assert.Matches("arithmetically coded|12 bits per sample|losslessly|cut off|restart marker|ends before|damaged", e.Message);
            }
        }
    }

    [SkippableFact]
    public void Damage_to_public_files_gives_nothing_but_a_PictureException()
    {
        foreach (string file in Corpora.Files(".jpeg", 10))
        {
            TestPictures.Fuzz(File.ReadAllBytes(file), f => ImageFile.Decode(f), rounds: TestSettings.Scale(20, 200));
        }
    }

    private static void AssertReadAsDjpegDoes(string file, TemporaryFolder folder)
    {
        Picture picture = ImageFile.Read(file, raw: true);
        Run("djpeg", "-dct", "int", "-pnm", "-outfile", folder["b.pnm"], file);
        (int width, int height, bool isGrey, int[] expected) = ReadPnm(folder["b.pnm"]);
        Assert.Equal((width, height), (picture.Width, picture.Height));
        AssertNear(expected, Codes(picture), isGrey ? GreyLimit : ColourLimit, Path.GetFileName(file));
    }

    private static void AssertNear(int[] expected, int[] actual, int limit, string what)
    {
        Assert.Equal(expected.Length, actual.Length);
        int largest = expected.Zip(actual, (a, b) => Math.Abs(a - b)).Max();
        double decibels = Decibels(expected, actual);
        Assert.True(largest <= limit && decibels >= LeastDecibels, $"{what}: {largest} codes, {decibels:F1} dB");
    }

    private static double Decibels(int[] expected, int[] actual)
    {
        double meanSquare = expected.Zip(actual, (a, b) => (double)(a - b) * (a - b)).Average();
        return meanSquare == 0 ? double.PositiveInfinity : 10 * Math.Log10(255 * 255 / meanSquare);
    }

    private static int[] Codes(Picture picture) => [.. picture.Pixels.Select(v => (int)Math.Round(255 * v))];

    private static void SkipUnlessThere() => Skip.IfNot(ProgramFactAttribute.IsThere("cjpeg") && ProgramFactAttribute.IsThere("djpeg"), "libjpeg-turbo's cjpeg and djpeg are not installed");

    private static void Run(string program, params string[] arguments)
    {
        (int exitCode, string output) = ProgramFactAttribute.Run(program, arguments);
        Assert.True(exitCode == 0, output);
    }

    // Smooth colours, an edge and some noise.
    private static void WritePpm(string path, int width, int height)
    {
        var random = new Random(width);
        List<byte> file = [.. Encoding.ASCII.GetBytes($"P6\n{width} {height}\n255\n")];
        for (int i = 0; i < width * height; i++)
        {
            (int x, int y) = (i % width, i / width);
            int edge = x + (2 * y) < width ? 90 : 0;
            file.AddRange([(byte)((x * 255 / width / 2) + edge), (byte)((y * 255 / height / 2) + random.Next(60)), (byte)((Math.Sin(x * 0.2) * 60) + 150 - edge)]);
        }

        File.WriteAllBytes(path, [.. file]);
    }

    // A binary PGM or PPM of 8 bits; grey is given thrice.
    private static (int Width, int Height, bool IsGrey, int[] Samples) ReadPnm(string path)
    {
        byte[] file = File.ReadAllBytes(path);
        string[] header = Encoding.Latin1.GetString(file, 0, Math.Min(40, file.Length)).Split((char[])[' ', '\n'], 5);
        Assert.Equal("255", header[3]);
        int start = header.Take(4).Sum(word => word.Length + 1);
        bool isGrey = header[0] == "P5";
        return (int.Parse(header[1]), int.Parse(header[2]), isGrey, [.. file.Skip(start).SelectMany(b => Enumerable.Repeat((int)b, isGrey ? 3 : 1))]);
    }
}
