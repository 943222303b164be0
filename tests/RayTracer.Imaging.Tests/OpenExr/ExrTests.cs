using FsCheck;
using FsCheck.Fluent;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

[Trait("Category", "Thorough")]
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

    // The data window begins below zero and ends within a tile; values lie as rows do.
    [Theory]
    [InlineData(4, 4)]
    [InlineData(3, 5)]
    [InlineData(1, 1)]
    [InlineData(100, 2)]
    public void Tiles_are_put_together(int width, int height)
    {
        TestExr rows = new() { Channels = [("A", 0, 1, 1), ("B", 1, 1, 1), ("G", 2, 1, 1), ("R", 1, 1, 1), ("Z", 2, 2, 3)], DataWindow = [-5, -7, 4, 6], Value = (c, x, y) => (10 * (x + 5)) + (y + 7) + (1000 * c) };
        TestExr tiles = new() { Channels = rows.Channels, DataWindow = rows.DataWindow, Value = rows.Value, Version = 0x202, Tile = (width, height) };
        TestPictures.AssertSameBits(ExrReader.Read(rows.File()), ExrReader.Read(tiles.File()));
        Assert.Equal(ExrReader.ReadChannel(rows.File(), "A"), ExrReader.ReadChannel(tiles.File(), "A"));
        Dictionary<string, (int, float)> parts = new() { ["A"] = (0, 1), ["G"] = (2, 0.5f) };
        TestPictures.AssertSameBits(ExrReader.Sum(rows.File(), parts), ExrReader.Sum(tiles.File(), parts));
    }

    [Theory]
    [InlineData("View Layer.Combined.")]
    [InlineData("beauty.")]
    [InlineData("anything.")]
    public void Where_all_channels_belong_to_layers_the_picture_among_them_is_read(string layer)
    {
        string[] others = layer == "anything." ? ["depth.Z"] : ["z.B", "z.G", "z.R"];
        TestExr exr = new() { Channels = [.. new[] { $"{layer}B", $"{layer}G", $"{layer}R" }.Concat(others).Select(n => (n, 1, 1, 1))], Value = (c, _, _) => c };
        Assert.Equal([2, 1, 0], ExrReader.Read(exr.File()).Pixels[..3]);
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
        { "no (valid) attribute 'tiles'", new TestExr { Version = 0x202 }.File() },
        { "its tiles have 0×4 pixels", Patched(new TestExr { Version = 0x202, Tile = (77, 4) }.File(), [77, 0, 0, 0, 4], [0]) },
        { "too small for a picture of 65537×4095 pixels with 5 channels", Patched(new TestExr { Version = 0x202, Tile = (1, 1), Channels = [.. "ABGRZ".Select(c => ($"{c}", 2, 1, 1))] }.File(), [0, 0, 0, 0, 3, 0, 0, 0, 2, 0, 0, 0], [0, 0, 0, 0, 0, 0, 1, 0, 254, 15, 0, 0]) },
        { "a tile claims pixels that the picture does not have", Patched(new TestExr { Version = 0x202, Tile = (4, 3) }.File(), [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 144, 0, 0, 0], [1]) },
        { "a tile of a smaller copy", Patched(new TestExr { Version = 0x202, Tile = (4, 3) }.File(), [0, 0, 0, 0, 0, 0, 0, 0, 144, 0, 0, 0], [1]) },
        { "its first part is of the kind ''", new TestExr { Version = 0x1002 }.File() },
        { "channels a.B, a.G, a.R, b.B, b.G, b.R", new TestExr { Channels = [.. new[] { "a.B", "a.G", "a.R", "b.B", "b.G", "b.R" }.Select(n => (n, 1, 1, 1))] }.File() },
        { "of deep data", new TestExr { Version = 0x802 }.File() },
        { "version word is 3", new TestExr { Version = 3 }.File() },
        { "compression is DWAA", new TestExr { Compression = 8 }.File() },
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

    [Fact]
    public void Damage_to_tiles_gives_nothing_but_a_PictureException() =>
        TestPictures.Fuzz(new TestExr { Version = 0x202, Tile = (5, 4), DataWindow = [0, 0, 11, 9] }.File(), file => ExrReader.Read(file));

    public static TheoryData<string, string> TiledKinds => new()
    {
        { "-o", "none" }, { "-m", "rle" }, { "-r", "zip" }, { "-m", "piz" }, { "-r", "pxr24" }, { "-o", "b44" }, { "-m", "b44a" },
    };

    // The reference implementation undoes the compression of its own file: what it then stores plainly is what we must read.
    [SkippableTheory]
    [MemberData(nameof(TiledKinds))]
    public void Tiles_of_the_reference_implementation_are_read_and_their_damage_is_found(string levels, string compression)
    {
        Skip.IfNot(ProgramFactAttribute.IsThere("exrmaketiled") && ProgramFactAttribute.IsThere("exrmultipart"), "OpenEXR's programs are not installed");
        using var folder = new TemporaryFolder();
        foreach (ExrPixelType type in (ExrPixelType[])[ExrPixelType.Half, ExrPixelType.Float])
        {
            ImageFile.Write(folder["a.exr"], Tilted(61, 47), new() { ExrPixelType = type });
            AssertRuns("exrmaketiled", levels, "-t", "24", "17", "-z", compression, folder["a.exr"], folder["b.exr"]);
            AssertRuns("exrmaketiled", "-o", "-z", "none", folder["b.exr"], folder["c.exr"]);
            Picture expected = ImageFile.Read(folder["c.exr"]);
            TestPictures.AssertSameBits(expected, ImageFile.Read(folder["b.exr"]));
            AssertRuns("exrmultipart", "-combine", "-i", folder["b.exr"] + ":0::first", folder["a.exr"] + ":0::second", "-o", folder["d.exr"]);
            TestPictures.AssertSameBits(expected, ImageFile.Read(folder["d.exr"]));
            TestPictures.Fuzz(File.ReadAllBytes(folder["d.exr"]), file => ExrReader.Read(file), rounds: TestSettings.Scale(60, 1000));
        }
    }

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

            // Its exit status is any number in OpenEXR 3.1.
            Assert.Contains("displayWindow", ProgramFactAttribute.Run("exrinfo", "-s", folder["a.exr"]).Output, StringComparison.Ordinal);
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

    // Slopes and even parts, in which blocks have exponents of all sizes.
    private static Picture Tilted(int width, int height) => new(width, height, [.. Enumerable.Range(0, 3 * width * height).Select(i => i / 3 % width < 20 ? 0.5f : ((i / 3 % width) - 40) * (i / 3 / width) * 0.01f * (1 + (i % 3)))]);

    private static byte[] Patched(byte[] file, byte[] from, byte[] to)
    {
        int at = file.AsSpan().IndexOf(from);
        to.CopyTo(file, at);
        return file;
    }

    private static byte[] Write(Picture picture, ExrPixelType type, ExrCompression compression) =>
        TestPictures.Bytes(stream => ExrWriter.Write(stream, picture, type, compression));
}
