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
