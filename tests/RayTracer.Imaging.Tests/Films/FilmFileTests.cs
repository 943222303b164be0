using System.Buffers.Binary;
using System.Text;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>The bytes of films' files, as docs/long-renders.md describes them.</summary>
public sealed class FilmFileTests : IDisposable
{
    private const int Width = 5;
    private const int Height = 4;
    private const int RowLength = 1 + 4 + (Width * 4 * 8);
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    // RFC 3720, appendix B.4; and the check value of this CRC in catalogues.
    [Theory]
    [InlineData("0000000000000000000000000000000000000000000000000000000000000000", 0x8A9136AAu)]
    [InlineData("ffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff", 0x62A8AB43u)]
    [InlineData("000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f", 0x46DD794Eu)]
    [InlineData("313233343536373839", 0xE3069283u)]
    public void The_check_is_that_of_the_standard_in_one_piece_or_two(string hex, uint check)
    {
        byte[] bytes = Convert.FromHexString(hex);
        for (int cut = 0; cut <= bytes.Length; cut++)
        {
            Assert.Equal(check, Crc32C.Append(Crc32C.Append(0, bytes.AsSpan(0, cut)), bytes.AsSpan(cut)));
        }
    }

    [Fact]
    public void Each_part_is_followed_by_the_check_of_all_before()
    {
        byte[] file = Write();
        int at = 16 + BinaryPrimitives.ReadInt32LittleEndian(file.AsSpan(12));
        List<byte> all = [.. file.AsSpan(0, at)];
        for (int row = 0; row <= Height; row++)
        {
            Assert.Equal(BitByBit(all), BinaryPrimitives.ReadUInt32LittleEndian(file.AsSpan(at)));
            at += 4;
            all.AddRange(file.AsSpan(at, row < Height ? RowLength : 0));
            at += row < Height ? RowLength : 0;
        }

        Assert.Equal(file.Length, at);
    }

    [Fact]
    public void Damage_is_reported_with_its_place()
    {
        byte[] file = Write();
        int rows = 16 + BinaryPrimitives.ReadInt32LittleEndian(file.AsSpan(12)) + 4;
        AssertRefused("its header is damaged", Changed(file, f => f[rows - 9] ^= 1));
        AssertRefused("row 0 is damaged", Changed(file, f => f[rows + 9] ^= 1));
        AssertRefused("row 3 is damaged", Changed(file, f => f[^5] ^= 1));
        AssertRefused("row 3 is damaged", Changed(file, f => f[^1] ^= 1));
        AssertRefused("data follows", [.. file, 0]);
        AssertRefused("it ends too early", file[..^1]);

        // Rows that are good in themselves, but stand elsewhere.
        int length = RowLength + 4;
        AssertRefused("row 1 is damaged", Changed(file, f => file.AsSpan(rows + (2 * length), length).CopyTo(f.AsSpan(rows + length))));
    }

    [Fact]
    public void Films_of_several_blocks_come_back_as_they_were()
    {
        Film film = new(1000, 300);
        for (int y = 0; y < film.Height; y++)
        {
            Random random = new(y);
            Int128[] sums = [.. Enumerable.Range(0, 4 * film.Width).Select(_ => y % 7 == 0 ? (Int128)random.NextInt64() * random.NextInt64() : random.NextInt64())];
            film.AddSums(y, sums, [.. Enumerable.Range(0, film.Width).Select(x => y % 5 == 0 ? (uint)x : 3u)]);
        }

        string path = _folder["large.rtfilm"];
        FilmFile.Write(path, film, Header(film.Width, film.Height));
        Assert.True(new FileInfo(path).Length > 1 << 23);
        Assert.Equal(film.ComputeHash(), FilmFile.Read(path).Film.ComputeHash());
    }

    [Theory]
    [InlineData(1)]
    [InlineData(1L << 40)]
    public void Planes_come_back_as_they_were(long factor)
    {
        Film film = WithHalf(factor);
        FilmFile.Write(_folder["a.rtfilm"], film, Header(Width, Height));
        FilmExr.Write(_folder["a.exr"], film, Header(Width, Height), new());
        foreach (string file in (string[])["a.rtfilm", "a.exr"])
        {
            (FilmHeader header, Film read) = CarriedFilm.Read(_folder[file]);
            Assert.Equal([FilmPlane.Half], header.Planes);
            Assert.Equal(film.ComputeHash(), read.ComputeHash());
            Film sum = new(Width, Height, FilmPlane.Half);
            CarriedFilm.AddTo(_folder[file], sum);
            Assert.Equal(film.ComputeHash(), sum.ComputeHash());

            // What a film has no plane for is left out, and what it needs must be there.
            Film plain = new(Width, Height);
            CarriedFilm.AddTo(_folder[file], plain);
            Assert.Equal(film.ComputeHash([]), plain.ComputeHash());
        }

        FilmFile.Write(_folder["plain.rtfilm"], new(Width, Height), Header(Width, Height));
        Assert.Throws<ArgumentException>(() => CarriedFilm.AddTo(_folder["plain.rtfilm"], film));
    }

    [Fact]
    public void Light_comes_back_as_it_was_but_its_noise_only_beside_halves()
    {
        FilmPlane[] all = [FilmPlane.Half, FilmPlane.Light, FilmPlane.LightSquare, FilmPlane.LightHalf];
        foreach (FilmPlane[] planes in (FilmPlane[][])[all, [FilmPlane.Light, FilmPlane.LightSquare], [FilmPlane.Light]])
        {
            Film film = new(Width, Height, planes);
            film.AddLight(1, 2, [3, 4L << 32, (Int128)5 << 70], 2);
            FilmFile.Write(_folder["a.rtfilm"], film, Header(Width, Height));
            FilmExr.Write(_folder["a.exr"], film, Header(Width, Height), new());
            foreach (string file in (string[])["a.rtfilm", "a.exr"])
            {
                Film read = CarriedFilm.Read(_folder[file]).Film;
                Assert.Equal(planes.Length == all.Length ? all : [FilmPlane.Light], read.Planes);
                Assert.Equal(film.ComputeHash(), read.ComputeHash());
                Assert.Equal(film.Mean(1, 2), read.Mean(1, 2));
                Assert.Equal(planes.Length == all.Length, read.KnowsNoise);
            }
        }
    }

    [Fact]
    public void A_damaged_plane_is_reported_with_its_row()
    {
        FilmFile.Write(_folder["a.rtfilm"], WithHalf(1), Header(Width, Height));
        byte[] file = File.ReadAllBytes(_folder["a.rtfilm"]);
        int rows = 16 + BinaryPrimitives.ReadInt32LittleEndian(file.AsSpan(12)) + 4;
        const int planeLength = 1 + (Width * 5 * 8);
        Assert.Equal(file.Length, rows + (Height * (RowLength + planeLength + 4)));
        AssertRefused("row 0 is damaged", Changed(file, f => f[rows + RowLength + 9] ^= 1));
        AssertRefused("row 3 is damaged", Changed(file, f => f[^9] ^= 1));
        AssertRefused("it ends too early", file[..^1]);
    }

    [Fact]
    public void A_plane_of_a_later_version_is_refused_by_name_and_its_header_is_read()
    {
        FilmFile.Write(_folder["a.rtfilm"], new(Width, Height, FilmPlane.Of("splats", ["red", "count"])), Header(Width, Height) with { Software = "raytracer 9" });
        FilmPlane plane = Assert.Single(FilmFile.ReadHeader(_folder["a.rtfilm"]).Planes);
        Assert.Equal(("splats", "red, count"), (plane.Name, string.Join(", ", plane.Sums)));
        AssertRefused(
            "it holds the plane 'splats' (red, count), which this version of the program does not know: use the one that wrote it, raytracer 9", File.ReadAllBytes(_folder["a.rtfilm"]));
    }

    [Theory]
    [InlineData("[]", "its header makes no sense")]
    [InlineData("""["count"]},{"name":"half","sums":["count"]""", "its header makes no sense")]
    [InlineData("[3]", "its header is damaged")]
    [InlineData("3", "its header is damaged")]
    public void Planes_that_make_no_sense_are_refused(string sums, string message)
    {
        byte[] text = Encoding.UTF8.GetBytes(Encoding.UTF8.GetString((Header(Width, Height) with { Planes = [FilmPlane.Of("half", ["mark"])] }).ToBytes()).Replace("[\"mark\"]", sums, StringComparison.Ordinal));
        Assert.Contains(message, Assert.Throws<PictureException>(() => FilmHeader.Of(text)).Message, StringComparison.Ordinal);
    }

    private static Film WithHalf(long factor)
    {
        Film film = new(Width, Height, FilmPlane.Half);
        for (int y = 0; y < Height; y++)
        {
            Random random = new(y);
            film.AddSums(y, [.. Enumerable.Range(0, 4 * Width).Select(_ => (Int128)random.NextInt64())], [.. Enumerable.Repeat(2u, Width)]);
            film.AddPlane(FilmPlane.Half, y, [.. Enumerable.Range(0, 5 * Width).Select(_ => (Int128)random.NextInt64() * factor)]);
        }

        return film;
    }

    private static FilmHeader Header(int width, int height) =>
        new() { Width = width, Height = height, Content = "content", Samples = [new(0, 1)], Wanted = new(0, 1), Total = 1, Scene = "scene.json" };

    // Castagnoli's polynomial, reversed.
    private static uint BitByBit(IEnumerable<byte> bytes)
    {
        uint rest = uint.MaxValue;
        foreach (byte b in bytes)
        {
            rest ^= b;
            for (int bit = 0; bit < 8; bit++)
            {
                rest = (rest >> 1) ^ ((rest & 1) * 0x82F63B78);
            }
        }

        return ~rest;
    }

    private static byte[] Changed(byte[] file, Action<byte[]> change)
    {
        byte[] changed = [.. file];
        change(changed);
        return changed;
    }

    private byte[] Write()
    {
        Film film = new(Width, Height);
        for (int y = 0; y < Height; y++)
        {
            film.AddSums(y, [.. Enumerable.Range(0, 4 * Width).Select(i => (Int128)(1000 * y) + i)], [.. Enumerable.Repeat(1u, Width)]);
        }

        FilmFile.Write(_folder["a.rtfilm"], film, Header(Width, Height));
        byte[] file = File.ReadAllBytes(_folder["a.rtfilm"]);
        Assert.Equal("RTFILM\r\n", Encoding.ASCII.GetString(file.AsSpan(0, 8)));
        return file;
    }

    private void AssertRefused(string message, byte[] file)
    {
        File.WriteAllBytes(_folder["b.rtfilm"], file);
        Assert.Contains(message, Assert.Throws<PictureException>(() => FilmFile.Read(_folder["b.rtfilm"])).Message, StringComparison.Ordinal);
    }
}
