using System.Text;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>Radiance pictures: in each of their codings, as their format says; as ImageMagick writes them; and damaged.</summary>
public class HdrTests
{
    private const string Head = "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n\n";

    // Eleven pixels of all sorts: runs, none, black, very bright and very dark.
    private static readonly byte[][] s_row =
        [[128, 64, 32, 129], [128, 64, 32, 129], [128, 64, 32, 129], [128, 64, 32, 129], [9, 200, 7, 128], [1, 2, 255, 130], [5, 5, 5, 0], [255, 255, 255, 255], [200, 3, 9, 20], [1, 1, 2, 128], [7, 8, 9, 140]];

    public static TheoryData<string> Codings => ["flat", "runs", "old runs"];

    [Theory]
    [MemberData(nameof(Codings))]
    public void A_value_is_its_mantissa_times_a_power_of_two(string coding)
    {
        Picture picture = HdrReader.Read([.. Encoding.ASCII.GetBytes($"{Head}-Y 2 +X {s_row.Length}\n"), .. Row(coding), .. Row(coding)]);
        Assert.Equal((s_row.Length, 2), (picture.Width, picture.Height));
        float[] expected = [.. s_row.SelectMany(p => p[..3].Select(m => (float)(p[3] == 0 ? 0 : m * Math.Pow(2, p[3] - 136))))];
        Assert.Equal([.. expected, .. expected], picture.Pixels);
    }

    [Theory]
    [InlineData("-Y 2 +X 2", new float[] { 1, 2, 3, 4 })]
    [InlineData("+Y 2 +X 2", new float[] { 3, 4, 1, 2 })]
    [InlineData("-Y 2 -X 2", new float[] { 2, 1, 4, 3 })]
    [InlineData("+Y 2 -X 2", new float[] { 4, 3, 2, 1 })]
    public void Rows_and_columns_stand_as_the_size_says(string size, float[] reds)
    {
        byte[] file = [.. Encoding.ASCII.GetBytes($"{Head}{size}\n"), 1, 0, 0, 136, 2, 0, 0, 136, 3, 0, 0, 136, 4, 0, 0, 136];
        Assert.Equal(reds, HdrReader.Read(file).Pixels.Where((_, i) => i % 3 == 0));
    }

    [Fact]
    public void Exposures_are_undone()
    {
        byte[] file = [.. Encoding.ASCII.GetBytes("#?RGBE\nEXPOSURE=4\nEXPOSURE= 0.5\n\n-Y 1 +X 1\n"), 8, 16, 32, 136];
        Assert.Equal([4, 8, 16], HdrReader.Read(file).Pixels);
    }

    [ImageMagickFact]
    public void What_ImageMagick_writes_is_read()
    {
        using TemporaryFolder folder = new();
        Picture picture = TestPictures.Noise(37, 23);
        ImageFile.Write(folder["a.png"], picture, new() { BitDepth = 16 });
        (int exitCode, string output) = ProgramFactAttribute.Run(ImageMagickFactAttribute.Program!, folder["a.png"], "-set", "colorspace", "RGB", folder["a.hdr"]);
        Assert.True(exitCode == 0, output);
        Picture read = ImageFile.Read(folder["a.hdr"]);
        Picture codes = ImageFile.Read(folder["a.png"], raw: true);
        Assert.Equal((37, 23), (read.Width, read.Height));
        for (int i = 0; i < read.Pixels.Length; i++)
        {
            // A step of a mantissa, of the brightest channel.
            float largest = codes.Pixels.AsSpan(3 * (i / 3), 3).ToArray().Max();
            Assert.Equal(codes.Pixels[i], read.Pixels[i], (largest / 64) + 1e-4f);
        }
    }

    [Theory]
    [InlineData("-Y 4 +X 4\n", "cut off")]
    [InlineData("-Y 100000 +X 100000\n", "at most")]
    [InlineData("-Y 0 +X 4\n", "at least 1")]
    [InlineData("+X 4 -Y 4\n", "'+X 4 -Y 4'")]
    [InlineData("-Y four +X 4\n", "'-Y four +X 4'")]
    [InlineData("-Y 1 +X 8\n\u0002\u0002\0\u0008\u0009abcdefghijklmnop", "a run of 9 at byte")]
    [InlineData("-Y 1 +X 8\n\u0002\u0002\0\u0008\0abcdefghijklmnop", "a run of 0 at byte")]
    [InlineData("-Y 1 +X 2\n\u0001\u0001\u0001\u0001abcd", "a run at byte")]
    [InlineData("-Y 1 +X 2\nabcd\u0001\u0001\u0001\u0009", "a run at byte")]
    [InlineData("-Y 1 +X 2\nabcdabc", "cut off after")]
    public void Bad_files_are_refused(string rest, string message) => Assert.Contains(message, TestPictures.Refusal(Encoding.Latin1.GetBytes(Head + rest)));

    [Theory]
    [InlineData("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n", "'32-bit_rle_xyze'")]
    [InlineData("#?RADIANCE\nEXPOSURE=0\n\n", "exposure '0'")]
    [InlineData("#?RADIANCE\nEXPOSURE=1e30\nEXPOSURE=1e30\n\n", "too large or too small")]
    [InlineData("#?RADIANCE\nFORMAT", "header is cut off")]
    public void Bad_headers_are_refused(string file, string message) => Assert.Contains(message, TestPictures.Refusal(Encoding.Latin1.GetBytes(file)));

    [Theory]
    [MemberData(nameof(Codings))]
    public void Damage_gives_nothing_but_a_PictureException(string coding) => TestPictures.Fuzz(
        [.. Encoding.ASCII.GetBytes($"{Head}-Y 2 +X {s_row.Length}\n"), .. Row(coding), .. Row(coding)], file => HdrReader.Read(file));

    private static IEnumerable<byte> Row(string coding)
    {
        switch (coding)
        {
            case "flat":
                return s_row.SelectMany(p => p);
            case "old runs":
                return [.. s_row[0], 1, 1, 1, 3, .. s_row.Skip(4).SelectMany(p => p)];
            default:
                List<byte> bytes = [2, 2, 0, (byte)s_row.Length];
                for (int channel = 0; channel < 4; channel++)
                {
                    bytes.AddRange([128 + 4, s_row[0][channel], (byte)(s_row.Length - 4), .. s_row.Skip(4).Select(p => p[channel])]);
                }

                return bytes;
        }
    }
}
