using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;

namespace RayTracer.Testing;

/// <summary>Makes PNG files of any kind, valid or not, without the code under test.</summary>
internal static class TestPng
{
    private static readonly (int X, int Y, int StepX, int StepY)[] Adam7 =
        [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)];

    public static ReadOnlySpan<byte> Signature => [137, 80, 78, 71, 13, 10, 26, 10];

    public static byte[] File(params byte[][] chunks) => [.. Signature, .. chunks.SelectMany(chunk => chunk)];

    public static byte[] Chunk(string type, params byte[] data)
    {
        var bytes = new byte[12 + data.Length];
        BinaryPrimitives.WriteInt32BigEndian(bytes, data.Length);
        Encoding.Latin1.GetBytes(type, bytes.AsSpan(4));
        data.CopyTo(bytes, 8);
        MendChecksum(bytes, 0);
        return bytes;
    }

    public static byte[] Header(uint width, uint height, int depth = 8, int type = 2, int interlaced = 0)
    {
        var data = new byte[13];
        BinaryPrimitives.WriteUInt32BigEndian(data, width);
        BinaryPrimitives.WriteUInt32BigEndian(data.AsSpan(4), height);
        (data[8], data[9], data[12]) = ((byte)depth, (byte)type, (byte)interlaced);
        return Chunk("IHDR", data);
    }

    public static byte[] End => Chunk("IEND");

    public static byte[] Zlib(byte[] data)
    {
        using var packed = new MemoryStream();
        using (var zlib = new ZLibStream(packed, CompressionLevel.Optimal))
        {
            zlib.Write(data);
        }

        return packed.ToArray();
    }

    /// <summary>Packs samples into filtered rows, with the filters 0 to 4 in turn.</summary>
    /// <param name="width">Pixels a row.</param>
    /// <param name="height">Rows.</param>
    /// <param name="channels">Samples a pixel.</param>
    /// <param name="depth">Bits a sample.</param>
    /// <param name="interlaced">Whether Adam7 is used.</param>
    /// <param name="sample">The sample of x, y and channel.</param>
    public static byte[] Rows(int width, int height, int channels, int depth, bool interlaced, Func<int, int, int, int> sample)
    {
        var bytes = new List<byte>();
        foreach ((int x0, int y0, int stepX, int stepY) in interlaced ? Adam7 : [(0, 0, 1, 1)])
        {
            byte[] above = [];
            for (int y = y0; y < height && x0 < width; y += stepY)
            {
                var bits = new List<int>();
                for (int x = x0; x < width; x += stepX)
                {
                    for (int channel = 0; channel < channels; channel++)
                    {
                        bits.AddRange(Enumerable.Range(1, depth).Select(bit => (sample(x, y, channel) >> (depth - bit)) & 1));
                    }
                }

                byte[] row = [.. bits.Chunk(8).Select(eight => (byte)eight.Select((bit, i) => bit << (7 - i)).Sum())];
                above = above.Length == 0 ? new byte[row.Length] : above;
                int type = y / stepY % 5;
                bytes.Add((byte)type);
                bytes.AddRange(Filter(type, row, above, Math.Max(1, channels * depth / 8)));
                above = row;
            }
        }

        return [.. bytes];
    }

    /// <summary>Corrects the checksums of all chunks that can still be found in a damaged file.</summary>
    public static void MendChecksums(byte[] file)
    {
        for (long at = 8; at + 12 <= file.Length;)
        {
            uint length = BinaryPrimitives.ReadUInt32BigEndian(file.AsSpan((int)at));
            if (length > file.Length - at - 12)
            {
                return;
            }

            MendChecksum(file, (int)at);
            at += 12 + length;
        }
    }

    private static void MendChecksum(byte[] file, int at)
    {
        int length = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at));
        uint crc = uint.MaxValue;
        foreach (byte b in file.AsSpan(at + 4, 4 + length))
        {
            crc ^= b;
            for (int bit = 0; bit < 8; bit++)
            {
                crc = (crc >> 1) ^ (0xEDB88320 & (0 - (crc & 1)));
            }
        }

        BinaryPrimitives.WriteUInt32BigEndian(file.AsSpan(at + 8 + length), ~crc);
    }

    private static IEnumerable<byte> Filter(int type, byte[] row, byte[] above, int pixel) => row.Select((value, i) =>
    {
        int a = i >= pixel ? row[i - pixel] : 0;
        int b = above[i];
        int c = i >= pixel ? above[i - pixel] : 0;
        int[] nearest = [.. new[] { a, b, c }.OrderBy(candidate => Math.Abs(a + b - c - candidate))];
        int[] predictions = [0, a, b, (a + b) / 2, nearest[0]];
        return (byte)(value - predictions[type]);
    });
}
