using System.Text;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

/// <summary>OpenEXR images that carry their film.</summary>
public sealed class FilmExrTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;
    private readonly string _image;

    public FilmExrTests()
    {
        _scene = _folder["scene.json"];
        _image = _folder["a.exr"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void An_image_that_carries_an_unfinished_film_is_gone_on_with_to_the_bits_of_one_render()
    {
        string whole = CliRun.FilmHash("render", _scene, "--spp", "16", "-o", _folder["whole.exr"], "--json", "--quiet");
        CliRun.Fine("render", _scene, "--spp", "16", "--samples", "0..6", "--exr-film", "-o", _image, "--quiet");
        (FilmHeader header, Film film) = CarriedFilm.Read(_image);
        FilmExr.Write(_image, film, header with { Wanted = new(0, 16) }, new());

        CliRun.Refused(4, $"'{_image}' holds samples 0..6 of an unfinished rendering: \"raytracer resume {_image}\" continues", "render", _scene, "--spp", "1", "-o", _image);
        CliRun.Refused(4, $"'{_image}' holds samples 0..6 of an unfinished rendering", "convert", _folder["whole.exr"], _image);
        CliRun.Refused(4, $"'{_image}' holds samples 0..6 of an unfinished rendering", "denoise", _folder["whole.exr"], "-o", _image);
        CliRun.Fine("resume", _image, "--quiet");
        Assert.Equal(whole, CarriedFilm.Read(_image).Film.ComputeHash());
        Assert.True(CarriedFilm.ReadHeader(_image).IsComplete);
        Assert.Contains(new("FilmHash", whole), ImageFile.ReadText(_image));
        TestPictures.AssertSameBits(ImageFile.Read(_folder["whole.exr"]), ImageFile.Read(_image));

        // With more samples, and over itself as an image.
        string more = CliRun.FilmHash("render", _scene, "--spp", "20", "--json", "--quiet");
        CliRun.Fine("resume", _image, "--spp", "20", "-o", _image, "-o", _folder["b.png"], "--quiet");
        Assert.Equal(more, CarriedFilm.Read(_image).Film.ComputeHash());
        CliRun.Fine("verify", _image);
        CliRun.Fine("verify", _folder["b.png"]);
        CliRun.Fine("render", _scene, "--spp", "1", "-o", _image);
        Assert.False(CarriedFilm.Is(_image));
    }

    [Fact]
    public void Parts_in_files_of_either_kind_are_merged_to_the_single_render()
    {
        string whole = CliRun.FilmHash("render", _scene, "--spp", "16", "--json", "--quiet");
        string[] parts = [_image, _folder["b.rtfilm"], _folder["c.exr"], _folder["d.rtfilm"]];
        for (int i = 0; i < parts.Length; i++)
        {
            string[] carry = FilmExr.IsNamed(parts[i]) ? ["--exr-film"] : [];
            CliRun.Fine(["render", _scene, "--spp", "16", "--part", $"{i + 1}/4", "-o", parts[i], "--quiet", .. carry]);
        }

        Assert.Equal(whole, CliRun.FilmHash(["merge", .. parts.Reverse(), "--json", "--exr-film", "-o", _folder["whole.exr"]]));
        Assert.Equal(whole, CliRun.FilmHash("merge", _folder["whole.exr"], "--json"));
        CliRun.Refused(4, $"samples 8..11 are in both '{_folder["whole.exr"]}' and '{_folder["c.exr"]}'", "merge", _folder["whole.exr"], _folder["c.exr"], "--json");
    }

    [Fact]
    public void Films_are_converted_from_either_kind_of_file_to_the_other()
    {
        CliRun.Fine("render", _scene, "--samples", "1..2", "-o", _folder["a.rtfilm"], "--quiet");
        CliRun.Fine("convert", _folder["a.rtfilm"], _image, "--exr-film");
        CliRun.Fine("convert", _image, _folder["b.rtfilm"]);
        Assert.Equal(File.ReadAllBytes(_folder["a.rtfilm"]), File.ReadAllBytes(_folder["b.rtfilm"]));
        CliRun.Fine("convert", _image, _folder["plain.exr"]);
        Assert.False(CarriedFilm.Is(_folder["plain.exr"]));
        TestPictures.AssertSameBits(ImageFile.Read(_image), ImageFile.Read(_folder["plain.exr"]));
        CliRun.Refused(2, "--width is for images", "convert", _image, _folder["b.rtfilm"], "--width", "3");
        CliRun.Refused(4, "does not carry its film: only those written with --exr-film do", "convert", _folder["plain.exr"], _folder["b.rtfilm"]);
    }

    [Fact]
    public void What_cannot_go_with_a_film_in_an_image_is_refused()
    {
        CliRun.Fine("render", _scene, "-o", _image, "--aov", "depth,normal", "--exr-film", "--quiet");
        Assert.Contains("depth.Z", ExrReader.ChannelNames(File.ReadAllBytes(_image)));
        byte[] before = File.ReadAllBytes(_image);
        CliRun.Fine("convert", _image, _folder["plain.exr"]);
        Assert.Equal(["B", "G", "R", "depth.Z", "normal.X", "normal.Y", "normal.Z"], ExrReader.ChannelNames(File.ReadAllBytes(_folder["plain.exr"])));
        CliRun.Fine("convert", _image, _folder["b.exr"], "--exr-film", "--exr-type", "half");
        Assert.Equal(ExrReader.ChannelNames(before), ExrReader.ChannelNames(File.ReadAllBytes(_folder["b.exr"])));
        CliRun.Refused(2, $"'{_image}' has layers that are not updated when samples are added (depth, normal)", "resume", _image, "--spp", "8");
        CliRun.Fine("resume", _image, "--spp", "8", "--checkpoint", _folder["a.rtfilm"], "-o", _folder["b.exr"], "--quiet");
        Assert.Equal(before, File.ReadAllBytes(_image));
        Assert.Equal("0..7", CarriedFilm.ReadHeader(_folder["b.exr"]).SamplesText);
        CliRun.Refused(2, "--exr-film is for OpenEXR images, but none is written", "render", _scene, "-o", _folder["a.png"], "--exr-film");
        CliRun.Refused(2, "leave it out", "render", _scene, "-o", _image, "--adaptive", "--exr-film");
        CliRun.Refused(2, $"{_image}: an OpenEXR image carries films of at most {FilmExr.MaxPixels} pixels", "render", _scene, "-o", _image, "--exr-film", "--width", "8192", "--height", "4097");
        CliRun.Fine("render", _scene, "-o", _folder["plain.exr"], "--quiet");
        foreach (string[] words in (string[][])[["resume"], ["merge", "--json"]])
        {
            CliRun.Refused(4, "does not carry its film: only those written with --exr-film do", [.. words, _folder["plain.exr"]]);
        }
    }

    [Fact]
    public void Frames_that_are_there_without_their_films_are_not_those_with_them()
    {
        string[] words = ["render", _scene, "--frames", "0..1", "-o", _folder["f-#.exr"], "--spp", "1"];
        CliRun.Fine(words);
        CliRun.Fine([.. words, "--exr-film"]);
        Assert.All(["f-0.exr", "f-1.exr"], f => Assert.True(CarriedFilm.Is(_folder[f])));
        Assert.Contains("exists already", CliRun.Of([.. words, "--exr-film"]).Output, StringComparison.Ordinal);
    }

    public static TheoryData<ExrCompression> Compressions => [.. Enum.GetValues<ExrCompression>()];

    [Theory]
    [MemberData(nameof(Compressions))]
    public void Sums_of_any_size_and_sign_are_kept(ExrCompression compression)
    {
        Random random = new(TestSettings.Seed);
        foreach (bool isWide in (bool[])[false, true])
        {
            (Film film, FilmHeader header) = Random(random, 7, 35, isWide);
            FilmExr.Write(_image, film, header, new() { ExrCompression = compression, ExrPixelType = ExrPixelType.Float });
            (FilmHeader read, Film again) = CarriedFilm.Read(_image);
            Assert.Equal((film.ComputeHash(), "0..2", "ä"), (again.ComputeHash(), read.SamplesText, read.Scene));
            Assert.Equal(isWide, ExrReader.ChannelNames(File.ReadAllBytes(_image)).Contains("film.red.3"));
        }
    }

    [Fact]
    public void Channels_are_the_words_of_the_sums_as_the_documentation_says()
    {
        (Film film, FilmHeader header) = Random(new(TestSettings.Seed), 3, 2, isWide: true);
        FilmExr.Write(_image, film, header, new());
        byte[] file = File.ReadAllBytes(_image);
        Int128[] sums = new Int128[12];
        uint[] counts = new uint[3];
        film.ReadSums(1, sums, counts);
        string[] names = ["red", "green", "blue", "square"];
        for (int i = 0; i < sums.Length; i++)
        {
            uint[] words = [.. Enumerable.Range(0, 4).Select(w => (uint)ExrReader.ReadChannel(file, $"film.{names[i % 4]}.{w}")[3 + (i / 4)])];
            Assert.Equal(sums[i], unchecked((Int128)(((UInt128)words[3] << 96) | ((UInt128)words[2] << 64) | ((UInt128)words[1] << 32) | words[0])));
        }

        Assert.Equal(counts.Select(c => (double)c), ExrReader.ReadChannel(file, "film.count")[3..]);
    }

    [Fact]
    public void Damage_is_found_and_named()
    {
        (Film film, FilmHeader header) = Random(new(TestSettings.Seed), 9, 5, isWide: false);
        FilmExr.Write(_image, film, header, new() { ExrCompression = ExrCompression.None });
        byte[] good = File.ReadAllBytes(_image);
        string hash = film.ComputeHash();

        // The last bytes are the last row's square sums.
        AssertRefused("the sums of its film are damaged", file => file[^1] ^= 1);
        AssertRefused("the sums of its film are damaged", file => file[Place(file, hash)] ^= 1);
        AssertRefused("its text Film, which describes its film, is damaged", file => file[Place(file, "\"samples\":[0,3]") + 11] ^= 1);
        AssertRefused("it has no channel film.count with an unsigned integer", file => file[Place(file, "film.count") + 9] ^= 1);
        AssertRefused("does not carry its film", file => file[Place(file, "Film\0string")] ^= 1);

        // Of another size than the picture.
        ImageFile.Write(_image, new Film(9, 4), new() { Metadata = [.. ImageFile.ReadText(Written(good)).Where(t => t.Key.StartsWith("Film", StringComparison.Ordinal))] });
        Assert.Contains("its film has 9×5 pixels, but its picture 9×4", Assert.Throws<PictureException>(() => CarriedFilm.ReadHeader(_image)).Message, StringComparison.Ordinal);

        void AssertRefused(string reason, Action<byte[]> damage)
        {
            byte[] file = (byte[])good.Clone();
            damage(file);
            CliRun.Refused(4, reason, "merge", Written(file), "--json");
        }
    }

    [Theory]
    [MemberData(nameof(Compressions))]
    public void Damage_gives_nothing_but_a_PictureException_or_the_same_film(ExrCompression compression)
    {
        (Film film, FilmHeader header) = Random(new(TestSettings.Seed), 9, 20, isWide: compression == ExrCompression.None);
        FilmExr.Write(_image, film, header, new() { ExrCompression = compression });
        string hash = film.ComputeHash();
        TestPictures.Fuzz(File.ReadAllBytes(_image), file =>
        {
            (FilmHeader read, Film again) = FilmExr.Read(file);
            Assert.Equal((hash, header.SamplesText, header.Content), (again.ComputeHash(), read.SamplesText, read.Content));
        }, rounds: 1000);
    }

    [ProgramFact("exrheader", "exrinfo", "exrmaketiled")]
    public void The_reference_implementation_reads_the_image()
    {
        CliRun.Fine("render", _scene, "-o", _image, "--exr-film", "--quiet");
        (int status, string output) = ProgramFactAttribute.Run("exrheader", _image);
        Assert.Equal(0, status);
        Assert.Contains("film.square.1, 32-bit unsigned integer, sampling 1 1", output, StringComparison.Ordinal);

        // Its exit status is any number in OpenEXR 3.1.
        Assert.Contains("'film.square.1': uint samp 1 1", ProgramFactAttribute.Run("exrinfo", "-s", _image).Output, StringComparison.Ordinal);

        // What it rewrites still has the picture; tiles are not resumed.
        Assert.Equal(0, ProgramFactAttribute.Run("exrmaketiled", "-o", "-z", "piz", _image, _folder["b.exr"]).ExitCode);
        TestPictures.AssertSameBits(ImageFile.Read(_image), ImageFile.Read(_folder["b.exr"]));
        Assert.Equal(ExrReader.ReadChannel(File.ReadAllBytes(_image), "film.red.0"), ExrReader.ReadChannel(File.ReadAllBytes(_folder["b.exr"]), "film.red.0"));
        CliRun.Refused(4, "another program has rewritten it, with tiles", "merge", _folder["b.exr"], "--json");
    }

    [ProgramFact("mkfifo")]
    public void A_pipe_is_not_waited_for()
    {
        Assert.Equal(0, ProgramFactAttribute.Run("mkfifo", _image).ExitCode);
        Assert.False(CarriedFilm.Is(_image));
    }

    private static int Place(byte[] file, string text) => file.AsSpan().IndexOf(Encoding.UTF8.GetBytes(text));

    private string Written(byte[] file)
    {
        File.WriteAllBytes(_folder["b.exr"], file);
        return _folder["b.exr"];
    }

    private static (Film Film, FilmHeader Header) Random(Random random, int width, int height, bool isWide)
    {
        Film film = new(width, height);
        for (int y = 0; y < height; y++)
        {
            Int128[] sums = [.. Enumerable.Range(0, 4 * width).Select(_ => (Int128)random.NextInt64(long.MinValue, long.MaxValue) * (isWide ? random.NextInt64(1L << 56) : 1))];
            film.AddSums(y, sums, [.. Enumerable.Range(0, width).Select(_ => (uint)random.NextInt64(1L << 32))]);
        }

        return (film, new() { Width = width, Height = height, Content = "c", Samples = [new(0, 3)], Wanted = new(0, 3), Total = 3, Scene = "ä" });
    }
}
