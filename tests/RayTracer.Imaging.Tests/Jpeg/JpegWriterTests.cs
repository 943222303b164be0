using System.Security.Cryptography;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

public class JpegWriterTests
{
    // What is coded is near to what was there: at quality 100 within the rounding of coefficients and of colour differences.
    [Theory]
    [InlineData(100, JpegChroma.Full, 50)]
    [InlineData(90, JpegChroma.Full, 40)]
    [InlineData(90, JpegChroma.Half, 38)]
    [InlineData(1, JpegChroma.Half, 15)]
    public void Pictures_of_any_size_come_back_nearly_as_they_were(int quality, JpegChroma chroma, double leastDecibels)
    {
        foreach ((int width, int height) in new[] { (1, 1), (8, 8), (17, 5), (5, 33), (64, 31) })
        {
            Picture picture = Smooth(width, height);
            Picture read = JpegReader.Read(Write(picture, quality, chroma));
            Assert.Equal((width, height), (read.Width, read.Height));
            double meanSquare = picture.Pixels.Zip(read.Pixels, (a, b) => Math.Pow(SrgbCurve.Encode8(a) - SrgbCurve.Encode8(b), 2)).Average();
            double decibels = 10 * Math.Log10(255 * 255 / meanSquare);
            Assert.True(decibels >= leastDecibels, $"{width}×{height}: {decibels:F1} dB");
        }
    }

    [Fact]
    public void A_higher_quality_takes_more_bytes_and_full_colours_more_than_a_quarter()
    {
        Picture picture = TestPictures.Noise(48, 40);
        int[] sizes = [.. new[] { 1, 20, 50, 80, 89, 90, 100 }.Select(q => Write(picture, q, null).Length)];
        Assert.Equal(sizes.Order(), sizes);
        Assert.True(Write(picture, 90, JpegChroma.Half).Length < Write(picture, 90, null).Length);
    }

    [Fact]
    public void The_bytes_are_the_same_on_every_machine() => Assert.Equal(
        "a8e376bd739a1f8f6e17310b028334f679ae5b00c", Convert.ToHexStringLower(SHA256.HashData(Write(Smooth(100, 70), 90, JpegChroma.Half)))[..41]);

    [Fact]
    public void Codes_of_very_rare_symbols_have_16_bits_at_most()
    {
        // Each as rare as the two next ones together: the code with the fewest bits would have 40 lengths.
        long[] frequencies = new long[256];
        (frequencies[0], frequencies[1]) = (1, 1);
        for (int i = 2; i < 40; i++)
        {
            frequencies[i] = frequencies[i - 1] + frequencies[i - 2];
        }

        JpegHuffmanCode code = new(frequencies);
        JpegHuffmanTable table = new(code.Table.AsSpan(0, 16), code.Table.AsSpan(16));
        for (int symbol = 0; symbol < 40; symbol++)
        {
            (int bits, int length) = code[symbol];
            Assert.InRange(length, 1, 16);
            Assert.NotEqual((1 << length) - 1, bits);
            Assert.Equal((length << 8) | symbol, table.Find(bits << (16 - length)));
        }

        Assert.Equal(40, code.Table.Length - 16);
    }

    [Fact]
    public void Texts_are_comments_unless_they_are_too_long()
    {
        KeyValuePair<string, string>[] texts = [new("Command", "render λ: x"), new("Scene", "")];
        byte[] file = TestPictures.Bytes(s => JpegWriter.Write(s, new Picture(1, 1), metadata: [.. texts, new("long", $"{new string('x', 65_520)}ö{new string('y', 80_000)}ö"), new("last", "")]));
        Assert.Equal([.. texts, new("long", $"{new string('x', 65_520)}ö{new string('y', 80_000)}ö"), new("last", "")], JpegReader.ReadText(file));
        JpegReader.Read(file);
    }

    [Fact]
    public void A_comment_without_a_key_is_called_so()
    {
        byte[] file = [.. JpegReader.Signature[..2], 0xFF, 0xFE, 0, 7, .. "plain"u8, 0xFF, 0xD9];
        Assert.Equal([new KeyValuePair<string, string>("Comment", "plain")], JpegReader.ReadText(file));
    }

    [Theory]
    [InlineData(0, 1, "between 1 and 100, not 0")]
    [InlineData(101, 1, "between 1 and 100, not 101")]
    [InlineData(90, 65_536, "at most 65535 pixels a side")]
    public void What_a_JPEG_cannot_be_is_refused(int quality, int width, string message) =>
        Assert.Contains(message, Assert.ThrowsAny<ArgumentException>(() => Write(new Picture(width, 1), quality, null)).Message, StringComparison.Ordinal);

    private static byte[] Write(Picture picture, int quality, JpegChroma? chroma) => TestPictures.Bytes(s => JpegWriter.Write(s, picture, quality, chroma));

    private static Picture Smooth(int width, int height)
    {
        Picture picture = new(width, height);
        for (int i = 0; i < picture.Pixels.Length; i += 3)
        {
            (int x, int y) = (i / 3 % width, i / 3 / width);
            picture.Pixels[i] = SrgbCurve.Decode8((byte)(100 + (x % 64) + y));
            picture.Pixels[i + 1] = SrgbCurve.Decode8((byte)(200 - (2 * (y % 64))));
            picture.Pixels[i + 2] = SrgbCurve.Decode8((byte)(50 + (x % 64) + (y % 64)));
        }

        return picture;
    }
}
