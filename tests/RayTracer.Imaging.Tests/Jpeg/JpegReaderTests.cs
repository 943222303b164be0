using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>JPEG files of an encoder of the tests' own, whose samples are known from the definition of the transform.</summary>
public class JpegReaderTests
{
    public static TheoryData<(int H, int V)[]> Layouts => new(
        [
            [(1, 1), (1, 1), (1, 1)], [(2, 1), (1, 1), (1, 1)], [(1, 2), (1, 1), (1, 1)], [(2, 2), (1, 1), (1, 1)], [(4, 1), (1, 1), (1, 1)],
            [(4, 2), (1, 1), (1, 1)], [(1, 4), (1, 1), (1, 1)], [(3, 1), (1, 1), (1, 1)], [(3, 2), (2, 1), (1, 2)], [(2, 2), (2, 1), (1, 2)],
            [(1, 1), (2, 2), (1, 2)], [(3, 3), (2, 2), (1, 1)], [(2, 2), (2, 2), (2, 2)],
        ]);

    [Theory]
    [MemberData(nameof(Layouts))]
    public void Every_subsampling_is_read_with_its_colours((int H, int V)[] factors)
    {
        foreach ((int width, int height, bool interleaved) in new[] { (1, 1, true), (19, 13, true), (33, 50, false), (64, 16, true) })
        {
            TestJpeg jpeg = new() { Width = width, Height = height, Factors = factors, Sample = Pattern, Interleaved = interleaved, RestartInterval = width % 4, Segments = TestJpeg.Jfif };
            AssertPixels(jpeg, OfLuminance);
        }
    }

    // The definition's samples, in double precision, differ by a thousandth at most: only those that lie so near a half may
    // be rounded the other way.
    [Theory]
    [InlineData(1, 8)]
    [InlineData(3, 9)]
    [InlineData(40, 10)]
    [InlineData(255, 16)]
    public void Grey_samples_are_the_nearest_to_those_of_the_transforms_definition(int step, int codeLength)
    {
        var noise = new Random(step);
        TestJpeg jpeg = new() { Width = 80, Height = 72, Factors = [(2, 3)], QuantizationStep = step, AcCodeLength = codeLength, Sample = (_, _, _) => noise.Next(256) };
        Picture picture = ImageFile.Decode(jpeg.Encode(), raw: true);
        for (int i = 0; i < 80 * 72; i++)
        {
            double expected = Math.Clamp(jpeg.Samples[0][i / 80, i % 80], 0, 255);
            Assert.InRange(Code(picture, i, 0) - expected, -0.501, 0.501);
            Assert.Equal((Code(picture, i, 0), Code(picture, i, 0)), (Code(picture, i, 1), Code(picture, i, 2)));
        }
    }

    [Fact]
    public void Samples_far_out_of_range_are_limited()
    {
        TestJpeg jpeg = new() { Width = 16, Height = 8, Factors = [(1, 1)], QuantizationStep = 255, Sample = (_, x, _) => x % 2 == 0 ? -400 : 700 };
        Picture picture = ImageFile.Decode(jpeg.Encode(), raw: true);
        Assert.Equal([0f, 1f, 0f, 1f], new[] { picture.Pixels[0], picture.Pixels[3], picture.Pixels[6], picture.Pixels[9] });
    }

    [Fact]
    public void Colours_are_decoded_from_sRGB_unless_raw()
    {
        byte[] file = new TestJpeg { Width = 9, Height = 7, Factors = [(1, 1), (1, 1), (1, 1)], Sample = Pattern }.Encode();
        (Picture linear, Picture raw) = (ImageFile.Decode(file), ImageFile.Decode(file, raw: true));
        Assert.Equal(raw.Pixels.Select(v => SrgbCurve.Decode8((byte)Math.Round(255 * v))), linear.Pixels);
    }

    [Theory]
    [InlineData("adobe 0", "\u0001\u0002\u0003", true)]
    [InlineData("adobe 1", "RGB", false)]
    [InlineData("none", "RGB", true)]
    [InlineData("none", "\u0001\u0002\u0003", false)]
    [InlineData("none", "abc", false)]
    [InlineData("jfif", "RGB", false)]
    [InlineData("jfif, adobe 0", "\u0001\u0002\u0003", false)]
    public void Three_components_are_RGB_or_YCbCr_as_the_markers_tell_and_then_the_names(string markers, string names, bool isRgb)
    {
        byte[] segments =
        [
            .. markers.Contains("jfif", StringComparison.Ordinal) ? TestJpeg.Jfif : [],
            .. markers.Contains("adobe", StringComparison.Ordinal) ? TestJpeg.Adobe((byte)(markers[^1] - '0')) : [],
        ];
        TestJpeg jpeg = new() { Width = 20, Height = 10, Factors = [(1, 1), (1, 1), (1, 1)], Names = names, Segments = segments, Sample = Pattern };
        AssertPixels(jpeg, isRgb ? c => (c[0], c[1], c[2]) : OfLuminance);
    }

    // Adobe's programs write 255 for no ink.
    [Theory]
    [InlineData(-1)]
    [InlineData(0)]
    [InlineData(2)]
    public void Four_components_are_inks_and_inverted_where_Adobe_wrote_them(int transform)
    {
        TestJpeg jpeg = new()
        {
            Width = 24,
            Height = 17,
            Factors = [(2, 2), (1, 1), (1, 1), (2, 2)],
            Sample = Pattern,
            Segments = transform < 0 ? [] : TestJpeg.Adobe((byte)transform),
        };
        AssertPixels(jpeg, c =>
        {
            (double r, double g, double b) = transform == 2 ? OfLuminance(c) : (c[0], c[1], c[2]);
            double[] paper = transform switch
            {
                -1 => [255 - r, 255 - g, 255 - b, 255 - c[3]],
                0 => [r, g, b, c[3]],
                _ => [255 - Math.Clamp(r, 0, 255), 255 - Math.Clamp(g, 0, 255), 255 - Math.Clamp(b, 0, 255), c[3]],
            };
            return (paper[0] * paper[3] / 255, paper[1] * paper[3] / 255, paper[2] * paper[3] / 255);
        });
    }

    [Fact]
    public void What_stands_between_segments_and_behind_the_picture_changes_nothing()
    {
        byte[] plain = Small().Encode();
        byte[] exif = [0xFF, 0xE1, 0, 34, .. "Exif\0\0MM\0*\0\0\0\u0008\0\u0001\u0001\u0012\0\u0003\0\0\0\u0001\0\u0006\0\0\0\0\0\0"u8];
        byte[] comment = [0xFF, 0xFF, 0xFF, 0xFE, 0, 5, 1, 2, 3];
        byte[] full = [.. plain[..2], .. exif, .. comment, .. plain[2..], 1, 2, 3, 0xFF, 0xD8];
        TestPictures.AssertSameBits(ImageFile.Decode(plain), ImageFile.Decode(full));
        TestPictures.AssertSameBits(ImageFile.Decode(plain), ImageFile.Decode(plain.AsSpan(0, plain.Length - 2)));
    }

    public static TheoryData<string, byte[]> BadFiles()
    {
        byte[] good = Small().Encode();
        byte[] restarts = new TestJpeg { Width = 40, Height = 8, Factors = [(1, 1)], Sample = Pattern, RestartInterval = 1 }.Encode();
        byte[] separate = new TestJpeg { Width = 8, Height = 8, Factors = [(1, 1), (1, 1), (1, 1)], Interleaved = false, Sample = Pattern }.Encode();
        int secondRestart = restarts.AsSpan().IndexOf((byte[])[0xFF, 0xD1]);
        int frame = good.AsSpan().IndexOf((byte[])[0xFF, 0xC0]);
        int scan = good.AsSpan().IndexOf((byte[])[0xFF, 0xDA]);
        int huffman = good.AsSpan().IndexOf((byte[])[0xFF, 0xC4]);
        return new()
        {
            { "has 12 bits per sample, and only JPEG files of 8 bits", With(good, frame + 4, 12) },
            { "arithmetically coded, which is not read", With(good, frame + 1, 0xC9) },
            { "arithmetically coded, which is not read", With(good, frame + 1, 0xCA) },
            { "compressed losslessly", With(good, frame + 1, 0xC3) },
            { "hierarchical", With(good, frame + 1, 0xC5) },
            { "marker DNL", With(With(good, frame + 5, 0), frame + 6, 0) },
            { "size of 0×", With(With(good, frame + 7, 0), frame + 8, 0) },
            { "cannot hold its 8208×16400 pixels", With(With(good, frame + 7, 0x20), frame + 5, 0x40) },
            { "sampling factors 0×1", With(good, frame + 11, 0x01) },
            { "quantization table 3 is missing", With(good, frame + 12, 3) },
            { "two of its components have the same name", With(good, frame + 13, 1) },
            { "names component 9", With(good, scan + 5, 9) },
            { "names a component twice", With(good, scan + 7, 1) },
            { "DC coefficients is missing", With(good, scan + 6, 0x10) },
            { "AC coefficients is missing", With(good, scan + 6, 0x01) },
            { "too many codes of 2 bits", With(With(good, huffman + 8, 0), huffman + 6, 12) },
            { "ends before its last block (at byte", good[..^5] },
            { "file is cut off", good[..(scan + 6)] },
            { "no frame header", [.. good[..frame], .. good[(scan + 14)..]] },
            { "scan before its frame header", [.. good[..frame], .. good[scan..]] },
            { "two frame headers", [.. good[..(frame + 19)], .. good[frame..]] },
            { "restart marker 1 is missing at byte", With(restarts, secondRestart + 1, 0xD2) },
            { "repeats what", [.. good[..^2], .. good[scan..]] },
            { "only a part of its components", separate[..separate.AsSpan().LastIndexOf((byte[])[0xFF, 0xDA])] },
        };
    }

    [Theory]
    [MemberData(nameof(BadFiles), DisableDiscoveryEnumeration = true)]
    public void Bad_files_are_refused_with_the_reason(string reason, byte[] file) => Assert.Contains(reason, TestPictures.Refusal(file));

    [Fact]
    public void Damage_gives_nothing_but_a_PictureException()
    {
        TestPictures.Fuzz(Small().Encode(), f => ImageFile.Decode(f));
        TestPictures.Fuzz(new TestJpeg { Width = 24, Height = 17, Factors = [(2, 1), (1, 3), (1, 1), (2, 2)], RestartInterval = 1, Sample = Pattern }.Encode(), f => ImageFile.Decode(f), rounds: 500);
        TestPictures.Fuzz(Progressive.ToArray(), f => ImageFile.Decode(f));
    }

    // A 24 × 16 picture of 4:2:0 in ten scans, made by libjpeg-turbo's cjpeg.
    internal static ReadOnlySpan<byte> Progressive => System.Convert.FromBase64String(ProgressiveText);

    private const string ProgressiveText =
        "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAoHBwgHBgoICAgLCgoLDhgQDg0NDh0VFhEYIx8lJCIfIiEmKzcvJik0KSEiMEExNDk7Pj4+JS5ESUM8SDc9Pjv/2wBDAQoLCw4NDhwQEBw7KCIoOzs7Oz"
        + "s7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozv/wgARCAAQABgDASIAAhEBAxEB/8QAFwABAQEBAAAAAAAAAAAAAAAAAAECA//EABYBAQEBAAAAAAAAAAAAAAAAAAEA"
        + "Av/aAAwDAQACEAMQAAAB5rTWVT//xAAWEAEBAQAAAAAAAAAAAAAAAAAAAxH/2gAIAQEAAQUCjiOIopIv/8QAFREBAQAAAAAAAAAAAAAAAAAAABH/2gAIAQMBAT8Bqv/EABQRAQAAAAAAAAAAAAAAAA"
        + "AAABD/2gAIAQIBAT8BP//EABYQAQEBAAAAAAAAAAAAAAAAAAAxEP/aAAgBAQAGPwLIqq//xAAaEAADAQADAAAAAAAAAAAAAAAAAREhMVGR/9oACAEBAAE/IV6MSFj8NzReYLnAtzJ//9oADAMBAAIA"
        + "AwAAABC0L//EABsRAAEEAwAAAAAAAAAAAAAAAAEAESHRUaGx/9oACAEDAQE/EAQl9mk7PaX/xAAXEQADAQAAAAAAAAAAAAAAAAAAAREx/9oACAECAQE/ECpaf//EABwQAQADAQEAAwAAAAAAAAAAAA"
        + "EAESExQVGx8P/aAAgBAQABPxCsDxOhKgEd4z9kRgPuB9xVsBy83ZcQ8KaKIsAvxmT/2Q==";

    private static TestJpeg Small() => new() { Width = 16, Height = 16, Factors = [(2, 2), (1, 1), (1, 1)], Sample = Pattern };

    private static byte[] With(byte[] file, int at, byte value)
    {
        byte[] changed = [.. file];
        changed[at] = value;
        return changed;
    }

    private static double Pattern(int component, int x, int y) => 128 + (70 * Math.Sin((x * 0.5) + component)) + (50 * Math.Cos((y * 0.7) - (component * x * 0.1)));

    // ITU-T T.871, section 7.
    private static (double R, double G, double B) OfLuminance(double[] c) =>
        (c[0] + (1.402 * (c[2] - 128)), c[0] - (0.114 * 1.772 / 0.587 * (c[1] - 128)) - (0.299 * 1.402 / 0.587 * (c[2] - 128)), c[0] + (1.772 * (c[1] - 128)));

    // Where a sample of the transform is so near a half that it may be rounded the other way, the pixel may differ by that step.
    private static void AssertPixels(TestJpeg jpeg, Func<double[], (double R, double G, double B)> convert)
    {
        Picture picture = ImageFile.Decode(jpeg.Encode(), raw: true);
        Assert.Equal((jpeg.Width, jpeg.Height), (picture.Width, picture.Height));
        int differing = 0;
        for (int i = 0; i < jpeg.Width * jpeg.Height; i++)
        {
            double[] samples = [.. jpeg.Factors.Select((_, c) => jpeg.SampleAt(c, i % jpeg.Width, i / jpeg.Width))];
            (double r, double g, double b) = convert(samples);
            for (int channel = 0; channel < 3; channel++)
            {
                double error = Math.Abs(Code(picture, i, channel) - Math.Clamp(channel == 0 ? r : channel == 1 ? g : b, 0, 255));
                differing += error > 0.501 ? 1 : 0;
                Assert.InRange(error, 0, 2.5);
            }
        }

        Assert.InRange(differing, 0, 3 * jpeg.Width * jpeg.Height / 100);
    }

    private static int Code(Picture picture, int pixel, int channel) => (int)Math.Round(255 * picture.Pixels[(3 * pixel) + channel]);
}
