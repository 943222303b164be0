using FsCheck;
using FsCheck.Fluent;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Tests.Imaging;

public class ExrTests
{
    public static TheoryData<ExrPixelType, ExrCompression> Kinds()
    {
        var kinds = new TheoryData<ExrPixelType, ExrCompression>();
        foreach (ExrCompression compression in Enum.GetValues<ExrCompression>())
        {
            kinds.Add(ExrPixelType.Half, compression);
            kinds.Add(ExrPixelType.Float, compression);
        }

        return kinds;
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Pixels_survive_writing_and_reading_at_any_size(ExrPixelType type, ExrCompression compression)
    {
        Prop.ForAll(Gen.Choose(1, 40).Two().ToArbitrary(), size =>
        {
            Picture picture = TestPictures.Noise(size.Item1, size.Item2, size.Item2);
            Picture read = ExrReader.Read(Write(picture, type, compression));
            float[] expected = type == ExrPixelType.Float ? picture.Pixels : [.. picture.Pixels.Select(value => (float)(Half)value)];
            return read.Width == size.Item1 && read.Pixels.SequenceEqual(expected);
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void Extreme_values_survive_as_far_as_the_type_allows()
    {
        float[] values = [float.NaN, float.PositiveInfinity, 1e30f, -1e30f, 65519, float.NegativeZero];
        var picture = new Picture(2, 1, values);
        TestPictures.AssertSameBits(picture, ExrReader.Read(Write(picture, ExrPixelType.Float, ExrCompression.Zip)));
        float[] halves = ExrReader.Read(Write(picture, ExrPixelType.Half, ExrCompression.Zip)).Pixels;
        Assert.Equal([float.NaN, float.PositiveInfinity, 65504, -65504, 65504, 0], halves);
    }

    [Theory]
    [InlineData(ExrCompression.Rle)]
    [InlineData(ExrCompression.Zips)]
    [InlineData(ExrCompression.Zip)]
    public void A_plain_image_becomes_small(ExrCompression compression) =>
        Assert.InRange(Write(new Picture(256, 64), ExrPixelType.Half, compression).Length, 1, 256 * 64 * 6 / 10);

    [Fact]
    public void Metadata_survives()
    {
        KeyValuePair<string, string>[] metadata = [new("owner", "λ"), new("scene", ""), new("a key of more than thirty-one bytes in all", "x\ny")];
        byte[] file = TestPictures.Bytes(stream => ExrWriter.Write(stream, new Picture(1, 1), metadata: metadata));
        Assert.Equal(metadata, ExrReader.ReadText(file));
    }

    [Theory]
    [InlineData("")]
    [InlineData("channels")]
    [InlineData("a\0b")]
    public void Metadata_that_OpenEXR_cannot_hold_is_refused(string key) => Assert.Throws<ArgumentException>(
        () => TestPictures.Bytes(stream => ExrWriter.Write(stream, new Picture(1, 1), metadata: [new(key, "x")])));

    [Fact]
    public void Other_channels_are_skipped_whatever_their_type_and_steps()
    {
        var exr = new TestExr
        {
            Channels = [("A", 1, 1, 1), ("B", 1, 1, 1), ("G", 2, 1, 1), ("R", 0, 1, 1), ("Z", 2, 3, 2), ("diffuse.R", 1, 2, 1)],
            DataWindow = [-4, -3, 3, 2],
            Value = (channel, x, y) => channel + (10 * (x + 4)) + (100 * (y + 3)),
        };
        Picture picture = ExrReader.Read(exr.File());
        Assert.Equal((8, 6), (picture.Width, picture.Height));
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            Assert.Equal(3 - (i % 3) + (10 * (i / 3 % 8)) + (100 * (i / 24)), picture.Pixels[i]);
        }
    }

    [Fact]
    public void Rows_may_stand_in_any_order()
    {
        Picture upwards = ExrReader.Read(new TestExr { RowOrder = [2, 1, 0] }.File());
        Picture mixed = ExrReader.Read(new TestExr { RowOrder = [1, 2, 0] }.File());
        Assert.All([upwards, mixed], picture => Assert.Equal([0, 10, 20], new[] { picture.Pixels[0], picture.Pixels[12], picture.Pixels[24] }));
    }

    [Fact]
    public void A_lone_Y_is_grey()
    {
        Picture picture = ExrReader.Read(new TestExr { Channels = [("Y", 1, 1, 1)] }.File());
        Assert.Equal([0, 0, 0, 1, 1, 1], picture.Pixels[..6]);
    }

    [Fact]
    public void Text_of_a_file_with_other_attributes_is_read() =>
        Assert.Equal([new KeyValuePair<string, string>("owner", "Zoë")], ExrReader.ReadText(new TestExr().File()));

    public static TheoryData<string, byte[]> BadFiles() => new()
    {
        { "of tiles", new TestExr { Version = 0x202 }.File() },
        { "of several parts", new TestExr { Version = 0x1002 }.File() },
        { "of deep data", new TestExr { Version = 0x802 }.File() },
        { "version word is 3", new TestExr { Version = 3 }.File() },
        { "compression is PXR24", new TestExr { Compression = 5 }.File() },
        { "compression is DWAB", new TestExr { Compression = 9 }.File() },
        { "compression is number 77", new TestExr { Compression = 77 }.File() },
        { "channels A, G, and only R, G and B", new TestExr { Channels = [("A", 1, 1, 1), ("G", 1, 1, 1)] }.File() },
        { "channels BY, RY, Y", new TestExr { Channels = [("BY", 1, 2, 2), ("RY", 1, 2, 2), ("Y", 1, 1, 1)] }.File() },
        { "channel R is not there once", new TestExr { Channels = [("B", 1, 1, 1), ("G", 1, 1, 1), ("R", 1, 2, 1)] }.File() },
        { "type 7", new TestExr { Channels = [("Y", 7, 1, 1)] }.File() },
        { "steps 0 and 1", new TestExr { Channels = [("Y", 1, 1, 1), ("Z", 1, 0, 1)], Value = (_, _, _) => 0, DataWindow = [0, 0, -1, 0] }.File() },
        { "0×1 pixels", new TestExr { DataWindow = [0, 0, -1, 0] }.File() },
        { "at most", new TestExr { DataWindow = [int.MinValue, 0, int.MaxValue, 0], RowOrder = [] }.File() },
        { "at most", new TestExr { DataWindow = [0, 0, 99_999, 99_999], RowOrder = [] }.File() },
        { "not where its table says", new TestExr { RowOrder = [0, 2] }.File() },
        { "cut off", new TestExr().File()[..^1] },
        { "within its header", new TestExr().File()[..6] },
        { "claims 55 bytes", new TestExr().File()[..30] },
        { "claims 37 bytes", new TestExr { Channels = [("Y", 1, 1, 1), ("Z", 1, 1, 1)] }.File()[..60] },
        { "no (valid) attribute 'channels'", [.. new TestExr().File()[..8], 0] },
    };

    [Theory]
    [MemberData(nameof(BadFiles), DisableDiscoveryEnumeration = true)]
    public void Bad_files_are_refused_with_the_reason(string reason, byte[] file) => Assert.Contains(reason, TestPictures.Refusal(file));

    [Fact]
    public void A_large_claim_costs_nothing_when_its_blocks_are_small()
    {
        byte[] file = new TestExr { Compression = (int)ExrCompression.Zips }.File();
        int window = file.AsSpan().IndexOf("dataWindow\0box2i\0"u8) + "dataWindow\0box2i\0".Length + 4;
        BitConverter.TryWriteBytes(file.AsSpan(window + 8), 999_999);
        Assert.Contains("12000000 bytes claims to be packed in 48", TestPictures.Refusal(file));
    }

    [Fact]
    public void A_table_that_leads_twice_to_one_block_is_refused()
    {
        byte[] file = new TestExr().File();
        int table = file.Length - (3 * (8 + 48)) - 24;
        file.AsSpan(table, 8).CopyTo(file.AsSpan(table + 8));
        Assert.Contains("twice", TestPictures.Refusal(file));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Damage_gives_nothing_but_a_PictureException(ExrPixelType type, ExrCompression compression) =>
        TestPictures.Fuzz(Write(TestPictures.Noise(9, 20), type, compression), file => ExrReader.Read(file));

    [ProgramFact("exrheader", "exrinfo")]
    public void The_reference_implementation_accepts_every_kind()
    {
        using var folder = new TemporaryFolder();
        foreach (object[] kind in Kinds().Cast<object[]>())
        {
            var options = new ImageWriteOptions
            {
                ExrPixelType = (ExrPixelType)kind[0],
                ExrCompression = (ExrCompression)kind[1],
                Metadata = [new("owner", "somebody"), new("a key of more than thirty-one bytes in all", "x")],
            };
            ImageFile.Write(folder["a.exr"], TestPictures.Noise(61, 37), options);
            Assert.Contains("somebody", AssertRuns("exrheader", folder["a.exr"]));
            AssertRuns("exrinfo", "-s", folder["a.exr"]);
        }
    }

    // One tile as large as the image, uncompressed, ends the file with the plain values: rows of B, then G, then R.
    [ProgramFact("exrmaketiled")]
    public void The_reference_implementation_reads_the_same_values()
    {
        using var folder = new TemporaryFolder();
        Picture picture = TestPictures.Noise(64, 64);
        foreach (object[] kind in Kinds().Cast<object[]>())
        {
            bool half = (ExrPixelType)kind[0] == ExrPixelType.Half;
            ImageFile.Write(folder["a.exr"], picture, new() { ExrPixelType = (ExrPixelType)kind[0], ExrCompression = (ExrCompression)kind[1] });
            AssertRuns("exrmaketiled", "-o", "-z", "none", "-t", "64", "64", folder["a.exr"], folder["tiled.exr"]);
            byte[] tiled = File.ReadAllBytes(folder["tiled.exr"]);
            Assert.Contains("of tiles", TestPictures.Refusal(tiled));
            int bytes = half ? 2 : 4;
            ReadOnlySpan<byte> values = tiled.AsSpan(tiled.Length - (bytes * picture.Pixels.Length));
            for (int i = 0; i < picture.Pixels.Length; i++)
            {
                int at = bytes * ((((i / 192 * 3) + 2 - (i % 3)) * 64) + (i / 3 % 64));
                float expected = half ? (float)(Half)picture.Pixels[i] : picture.Pixels[i];
                Assert.Equal(expected, half ? (float)BitConverter.ToHalf(values[at..]) : BitConverter.ToSingle(values[at..]));
            }
        }
    }

    [ProgramFact("exrstdattr")]
    public void A_file_of_the_reference_implementation_is_read()
    {
        using var folder = new TemporaryFolder();
        Picture picture = TestPictures.Noise(31, 40);
        ImageFile.Write(folder["a.exr"], picture, new() { ExrPixelType = ExrPixelType.Float });
        AssertRuns("exrstdattr", "-comments", "by hand", "-focus", "2.5", folder["a.exr"], folder["b.exr"]);
        Assert.Equal([new("comments", "by hand")], ImageFile.ReadText(folder["b.exr"]));
        TestPictures.AssertSameBits(picture, ImageFile.Read(folder["b.exr"]));
    }

    private static string AssertRuns(string program, params string[] arguments)
    {
        (int exitCode, string output) = ProgramFactAttribute.Run(program, arguments);
        Assert.True(exitCode == 0, output);
        return output;
    }

    private static byte[] Write(Picture picture, ExrPixelType type, ExrCompression compression) =>
        TestPictures.Bytes(stream => ExrWriter.Write(stream, picture, type, compression));
}
