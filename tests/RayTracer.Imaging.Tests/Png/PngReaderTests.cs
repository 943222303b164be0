using System.IO.Compression;
using System.Text;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

public class PngReaderTests
{
    private static readonly byte[] Palette = [.. Enumerable.Range(0, 3 * 256).Select(i => (byte)(i * 37))];

    public static TheoryData<int, int, bool> Kinds()
    {
        var kinds = new TheoryData<int, int, bool>();
        foreach ((int type, int[] depths) in new[] { (0, new[] { 1, 2, 4, 8, 16 }), (2, [8, 16]), (3, [1, 2, 4, 8]), (4, [8, 16]), (6, [8, 16]) })
        {
            foreach (int depth in depths)
            {
                kinds.Add(type, depth, false);
                kinds.Add(type, depth, true);
            }
        }

        return kinds;
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Every_kind_of_pixel_is_read(int type, int depth, bool interlaced)
    {
        int max = (1 << depth) - 1;
        int channels = type switch { 2 => 3, 4 => 2, 6 => 4, _ => 1 };
        foreach ((int width, int height) in new[] { (1, 1), (5, 3), (19, 13), (3, 9), (33, 2) })
        {
            int Sample(int x, int y, int channel) => ((x * 7919) + (y * 104729) + (channel * 1299709) + (x * y * 31)) & max;
            byte[] file = TestPng.File(
                TestPng.Header((uint)width, (uint)height, depth, type, interlaced ? 1 : 0),
                type == 3 ? TestPng.Chunk("PLTE", Palette[..(3 * (max + 1))]) : [],
                TestPng.Chunk("IDAT", TestPng.Zlib(TestPng.Rows(width, height, channels, depth, interlaced, Sample))),
                TestPng.End);
            Picture raw = PngReader.Read(file, raw: true);
            Picture linear = PngReader.Read(file);
            for (int i = 0; i < raw.Pixels.Length; i++)
            {
                int sample = Sample(i / 3 % width, i / 3 / width, type is 2 or 6 ? i % 3 : 0);
                double expected = type == 3 ? Palette[(3 * sample) + (i % 3)] / 255.0 : sample / (double)max;
                Assert.Equal((float)expected, raw.Pixels[i]);
                Assert.Equal((float)SrgbCurve.Decode(expected), linear.Pixels[i]);
            }
        }
    }

    [Theory]
    [InlineData(0, 8)]
    [InlineData(2, 16)]
    public void Every_filter_is_undone_when_the_bytes_are_noise(int type, int depth)
    {
        int channels = type == 2 ? 3 : 1;
        var noise = new int[150 * 40 * channels];
        var random = new Random(3);
        for (int i = 0; i < noise.Length; i++)
        {
            noise[i] = random.Next(1 << depth);
        }

        byte[] rows = TestPng.Rows(150, 40, channels, depth, false, (x, y, c) => noise[(((y * 150) + x) * channels) + c]);
        Picture picture = PngReader.Read(TestPng.File(TestPng.Header(150, 40, depth, type), TestPng.Chunk("IDAT", TestPng.Zlib(rows)), TestPng.End), raw: true);
        Assert.Equal(noise, picture.Pixels.Where((_, i) => channels == 3 || i % 3 == 0).Select(value => (int)Math.Round(value * ((1 << depth) - 1))));
    }

    [Fact]
    public void The_checksum_of_the_image_data_counts_when_it_comes_after_everything_else()
    {
        // Stored data of this length fills the first 8 KiB that the decompressor reads: the checksum comes with the next.
        using var packed = new MemoryStream();
        using (var zlib = new ZLibStream(packed, CompressionLevel.NoCompression, leaveOpen: true))
        {
            zlib.Write(new byte[8185]);
        }

        byte[] data = packed.ToArray();
        Assert.Equal(8196, data.Length);
        Assert.Equal(8184, PngReader.Read(TestPng.File(TestPng.Header(8184, 1, 8, 0), TestPng.Chunk("IDAT", data), TestPng.End)).Width);
        data[^1] ^= 1;
        Assert.Contains("damaged", TestPictures.Refusal(TestPng.File(TestPng.Header(8184, 1, 8, 0), TestPng.Chunk("IDAT", data), TestPng.End)));
    }

    [Fact]
    public void Image_data_may_be_cut_into_chunks_anywhere()
    {
        byte[] data = TestPng.Zlib(TestPng.Rows(9, 4, 3, 8, false, (x, y, c) => x + y + c));
        byte[] file = TestPng.File([TestPng.Header(9, 4), .. data.Select(b => TestPng.Chunk("IDAT", b)), TestPng.Chunk("IDAT"), TestPng.End]);
        Assert.Equal(1 / 255f, PngReader.Read(file, raw: true).Pixels[1]);
    }

    [Fact]
    public void Transparency_is_accepted_and_ignored()
    {
        byte[] grey = Small(0, TestPng.Chunk("tRNS", 0, 7));
        byte[] rgb = Small(2, TestPng.Chunk("tRNS", 0, 1, 0, 2, 0, 3));
        byte[] palette = Small(3, TestPng.Chunk("PLTE", Palette), TestPng.Chunk("tRNS", 9, 9));
        Assert.All([grey, rgb, palette], file => Assert.Equal((2, 2), (PngReader.Read(file).Width, PngReader.Read(file).Height)));
    }

    [Fact]
    public void Text_of_every_kind_is_read()
    {
        byte[] file = TestPng.File(
            TestPng.Header(1, 1),
            TestPng.Chunk("tEXt", [.. "Title\0caf"u8, 0xE9]),
            TestPng.Chunk("zTXt", [.. "Long\0\0"u8, .. TestPng.Zlib([.. "na"u8, 0xEF, .. "ve"u8])]),
            TestPng.Chunk("iTXt", [.. "Plain\0\0\0de\0Titel\0"u8, .. "λ = 1"u8]),
            TestPng.Chunk("iTXt", [.. "Packed\0\u0001\0\0\0"u8, .. TestPng.Zlib([.. "λ = 2"u8])]),
            TestPng.Chunk("IDAT", TestPng.Zlib([0, 1, 2, 3])),
            TestPng.End);
        KeyValuePair<string, string>[] expected = [new("Title", "café"), new("Long", "naïve"), new("Plain", "λ = 1"), new("Packed", "λ = 2")];
        Assert.Equal(expected, PngReader.ReadText(file));
        Assert.Equal(1, PngReader.Read(file).Width);
    }

    [Fact]
    public void A_text_that_unpacks_without_end_is_refused()
    {
        byte[] file = TestPng.File(TestPng.Header(1, 1), TestPng.Chunk("zTXt", [.. "Bomb\0\0"u8, .. TestPng.Zlib(new byte[PictureLimits.MaxTextBytes + 1])]));
        Assert.Contains("'Bomb' has more than", Assert.Throws<PictureException>(() => PngReader.ReadText(file)).Message);
    }

    public static TheoryData<string, byte[]> BadFiles()
    {
        byte[] data = TestPng.Chunk("IDAT", TestPng.Zlib(new byte[14]));
        byte[] head = TestPng.Header(2, 2);
        byte[] end = TestPng.End;
        byte[] good = TestPng.File(head, data, end);
        byte[] flipped = [.. good];
        flipped[16] ^= 1;
        byte[] afterAdler = TestPng.Zlib(new byte[14]);
        afterAdler[^1] ^= 1;
        return new()
        {
            { "IEND chunk is missing", good[..^12] },
            { "cut off", good[..60] },
            { "checksum of its IHDR chunk", flipped },
            { "first chunk is IDAT", TestPng.File(data, end) },
            { "at most 268435456", TestPng.File(TestPng.Header(100_000, 100_000), data, end) },
            { "at most", TestPng.File(TestPng.Header(uint.MaxValue, 1), data, end) },
            { "at least 1", TestPng.File(TestPng.Header(0, 2), data, end) },
            { "cannot hold its 16384×16384 pixels", TestPng.File(TestPng.Header(16384, 16384, 16), data, end) },
            { "colour type 2 with 4 bits", TestPng.File(TestPng.Header(2, 2, 4), data, end) },
            { "colour type 5", TestPng.File(TestPng.Header(2, 2, 8, 5), data, end) },
            { "interlacing 2", TestPng.File(TestPng.Header(2, 2, 8, 2, 2), data, end) },
            { "12 bytes instead of 13", TestPng.File(TestPng.Chunk("IHDR", new byte[12]), data, end) },
            { "no image data", TestPng.File(head, end) },
            { "chunk IHDR", TestPng.File(head, head, data, end) },
            { "chunk ABCD", TestPng.File(head, TestPng.Chunk("ABCD"), data, end) },
            { "between its IDAT chunks", TestPng.File(head, data, TestPng.Chunk("tEXt", 65, 0), data, end) },
            { "no PLTE chunk", TestPng.File(TestPng.Header(2, 2, 8, 3), data, end) },
            { "comes after the image data", TestPng.File(head, data, TestPng.Chunk("PLTE", 1, 2, 3), end) },
            { "4 bytes instead of 3 for each", TestPng.File(head, TestPng.Chunk("PLTE", 1, 2, 3, 4), data, end) },
            { "cannot have a palette", TestPng.File(TestPng.Header(2, 2, 8, 0), TestPng.Chunk("PLTE", 1, 2, 3), data, end) },
            { "tRNS chunk does not fit", TestPng.File(head, TestPng.Chunk("tRNS", 1), data, end) },
            { "four letters", TestPng.File(head, TestPng.Chunk("I\0AT"), end) },
            { "ends before its last row", TestPng.File(TestPng.Header(2, 3), data, end) },
            { "row filter", TestPng.File(head, TestPng.Chunk("IDAT", TestPng.Zlib([9, 0, 0, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0])), end) },
            { "compressed image data is damaged", TestPng.File(head, TestPng.Chunk("IDAT", 1, 2, 3, 4), end) },
            { "compressed image data is damaged", TestPng.File(head, TestPng.Chunk("IDAT", afterAdler), end) },
            { "colour 5 of a palette of 1", TestPng.File(TestPng.Header(1, 1, 8, 3), TestPng.Chunk("PLTE", 1, 2, 3), TestPng.Chunk("IDAT", TestPng.Zlib([0, 5])), end) },
            { "first bytes", Encoding.ASCII.GetBytes("GIF89a") },
            { "first bytes", [] },
        };
    }

    [Theory]
    [MemberData(nameof(BadFiles), DisableDiscoveryEnumeration = true)]
    public void Bad_files_are_refused_with_the_reason(string reason, byte[] file) => Assert.Contains(reason, TestPictures.Refusal(file));

    [Fact]
    public void A_large_claim_costs_nothing_when_its_data_is_rubbish()
    {
        var rubbish = new byte[40_000];
        byte[] file = TestPng.File(TestPng.Header(16384, 16384, 1, 0), TestPng.Chunk("IDAT", rubbish), TestPng.End);
        long before = GC.GetAllocatedBytesForCurrentThread();
        TestPictures.Refusal(file);
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1 << 20);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Damage_gives_nothing_but_a_PictureException(bool mendChecksums)
    {
        KeyValuePair<string, string>[] texts = [new("Title", "text"), new("Greek", "λ")];
        byte[] file = TestPictures.Bytes(stream => PngWriter.Write(stream, TestPictures.Noise(12, 9), 16, texts));
        TestPictures.Fuzz(file, ReadAll, mendChecksums ? TestPng.MendChecksums : null);
    }

    [Theory]
    [InlineData(0, 2)]
    [InlineData(3, 4)]
    [InlineData(6, 8)]
    public void Damage_to_interlaced_files_gives_nothing_but_a_PictureException(int type, int depth)
    {
        byte[] rows = TestPng.Rows(11, 9, type == 6 ? 4 : 1, depth, true, (x, y, c) => x + y + c);
        byte[] palette = type == 3 ? TestPng.Chunk("PLTE", Palette[..48]) : [];
        byte[] text = TestPng.Chunk("zTXt", [.. "Key\0\0"u8, .. TestPng.Zlib(new byte[99])]);
        byte[] file = TestPng.File(TestPng.Header(11, 9, depth, type, 1), palette, text, TestPng.Chunk("IDAT", TestPng.Zlib(rows)), TestPng.End);
        TestPictures.Fuzz(file, ReadAll, TestPng.MendChecksums);
    }

    private static void ReadAll(byte[] file)
    {
        PngReader.ReadText(file);
        PngReader.Read(file);
    }

    private static byte[] Small(int type, params byte[][] chunks) => TestPng.File(
        [TestPng.Header(2, 2, 8, type), .. chunks, TestPng.Chunk("IDAT", TestPng.Zlib(new byte[2 * (type == 2 ? 7 : 3)])), TestPng.End]);
}
