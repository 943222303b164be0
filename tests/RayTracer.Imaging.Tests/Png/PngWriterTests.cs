using FsCheck;
using FsCheck.Fluent;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

public class PngWriterTests
{
    // An independent reader in a few lines: unpacks and unfilters, writes the samples as hexadecimal digits.
    private const string PythonReader = """
        import struct, sys, zlib
        f = open(sys.argv[1], 'rb').read()
        at, data = 8, b''
        while at < len(f):
            n, kind = struct.unpack('>I4s', f[at:at + 8])
            body = f[at + 8:at + 8 + n]
            assert zlib.crc32(kind + body) == struct.unpack('>I', f[at + 8 + n:at + 12 + n])[0]
            if kind == b'IHDR': w, h, depth = struct.unpack('>IIB', body[:9])
            if kind == b'IDAT': data += body
            at += 12 + n
        raw, px = zlib.decompress(data), 3 * depth // 8
        size, above, out = w * px, bytes(w * px), b''
        for y in range(h):
            t, line = raw[y * (size + 1)], bytearray(raw[y * (size + 1) + 1:(y + 1) * (size + 1)])
            for i in range(size):
                a = line[i - px] if i >= px else 0
                b, c = above[i], above[i - px] if i >= px else 0
                p = a + b - c
                paeth = min((abs(p - v), k, v) for k, v in enumerate((a, b, c)))[2]
                line[i] = (line[i] + (0, a, b, (a + b) // 2, paeth)[t]) & 255
            above, out = bytes(line), out + line
        print(out.hex())
        """;

    [Theory]
    [InlineData(8)]
    [InlineData(16)]
    public void Codes_survive_writing_and_reading_at_any_size(int bitDepth)
    {
        Prop.ForAll(Gen.Choose(1, 40).Two().ToArbitrary(), size =>
        {
            Picture picture = TestPictures.Noise(size.Item1, size.Item2, size.Item1);
            Picture read = PngReader.Read(TestPictures.Bytes(stream => PngWriter.Write(stream, picture, bitDepth)));
            return read.Pixels.SequenceEqual(picture.Pixels.Select(value => bitDepth == 8
                ? SrgbCurve.Decode8(SrgbCurve.Encode8(value))
                : SrgbCurve.Decode16(SrgbCurve.Encode16(value))));
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void Metadata_survives()
    {
        KeyValuePair<string, string>[] metadata =
        [
            new("Software", "Ray tracer 0.1"), new("Description", "café\nsecond line"), new("Comment", "λ → ∞ 光"), new("Empty", ""),
            new("Scène", "{ \"width\": 600 }"), new("Tab", "a\tb"),
        ];
        byte[] file = TestPictures.Bytes(stream => PngWriter.Write(stream, new Picture(1, 1), 8, metadata));
        Assert.Equal(metadata, PngReader.ReadText(file));
    }

    [Theory]
    [InlineData("", "x")]
    [InlineData(" a", "x")]
    [InlineData("a  b", "x")]
    [InlineData("λ", "x")]
    [InlineData("a", "x\0y")]
    public void Metadata_that_PNG_cannot_hold_is_refused(string key, string value) => Assert.Throws<ArgumentException>(
        () => PngWriter.Write(Stream.Null, new Picture(1, 1), 8, [new(key, value)]));

    [Fact]
    public void A_bit_depth_other_than_8_and_16_is_refused() =>
        Assert.Throws<ArgumentException>(() => PngWriter.Write(Stream.Null, new Picture(1, 1), 4));

    [Fact]
    public void A_large_image_is_written_without_being_in_memory()
    {
        var image = new Gradient(2000, 400);
        PngWriter.Write(Stream.Null, new Gradient(8, 8));
        long before = GC.GetAllocatedBytesForCurrentThread();
        PngWriter.Write(Stream.Null, image);
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1 << 20);
        Assert.Equal(Enumerable.Range(0, 400), image.RowsRead);
    }

    [Fact]
    public void The_filter_is_chosen_that_compresses_best()
    {
        // Each row is the first one, brighter by a small random amount: the filter that subtracts the row above leaves constants.
        var random = new Random(5);
        var row = new byte[3 * 256];
        random.NextBytes(row);
        var picture = new Picture(256, 256);
        for (int y = 0; y < 256; y++)
        {
            int brighter = random.Next(8);
            for (int i = 0; i < row.Length; i++)
            {
                picture.Pixels[(y * row.Length) + i] = SrgbCurve.Decode8((byte)(row[i] + brighter));
            }
        }

        byte[] file = TestPictures.Bytes(stream => PngWriter.Write(stream, picture));
        Assert.InRange(file.Length, 0, picture.Pixels.Length / 30);
    }

    [ProgramFact("pngcheck")]
    public void Pngcheck_finds_nothing_wrong()
    {
        using var folder = new TemporaryFolder();
        foreach (int bitDepth in new[] { 8, 16 })
        {
            ImageFile.Write(folder["a.png"], TestPictures.Noise(300, 211), new() { BitDepth = bitDepth, Metadata = [new("Title", "noise"), new("Greek", "λ")] });
            (int exitCode, string output) = ProgramFactAttribute.Run("pngcheck", "-v", folder["a.png"]);
            Assert.True(exitCode == 0, output);
            Assert.Contains("No errors detected", output);
            Assert.Contains("rendering intent = perceptual", output);
        }
    }

    [ProgramFact("python3")]
    public void An_independent_reader_finds_the_same_codes()
    {
        using var folder = new TemporaryFolder();
        Picture picture = TestPictures.Noise(53, 31);
        foreach (int bitDepth in new[] { 8, 16 })
        {
            ImageFile.Write(folder["a.png"], picture, new() { BitDepth = bitDepth });
            string expected = string.Concat(picture.Pixels.Select(value => bitDepth == 8 ? $"{SrgbCurve.Encode8(value):x2}" : $"{SrgbCurve.Encode16(value):x4}"));
            Assert.Equal(expected, ProgramFactAttribute.Run("python3", "-c", PythonReader, folder["a.png"]).Output.Trim());
        }
    }

    private sealed class Gradient(int width, int height) : IImageRows
    {
        public int Width => width;

        public int Height => height;

        public List<int> RowsRead { get; } = [];

        public void ReadRow(int y, Span<float> rgb)
        {
            RowsRead.Add(y);
            for (int i = 0; i < rgb.Length; i++)
            {
                rgb[i] = SrgbCurve.Decode8((byte)((i / 3) + (2 * y)));
            }
        }
    }
}
