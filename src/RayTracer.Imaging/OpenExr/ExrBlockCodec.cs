using System.IO.Compression;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Compression of one OpenEXR block (openexr.com, "OpenEXR File Layout", and ImfZip, ImfRle of the reference implementation).
/// </summary>
internal static class ExrBlockCodec
{
    private const int LongestRun = 127;
    private const int ShortestRun = 3;

    /// <summary>Compresses a block, unless that makes it no smaller: then it is stored as it is.</summary>
    public static ReadOnlySpan<byte> Compress(ExrCompression compression, ReadOnlySpan<byte> block)
    {
        if (compression == ExrCompression.None)
        {
            return block;
        }

        byte[] differences = Difference(block);
        byte[] packed = compression == ExrCompression.Rle ? PackRuns(differences) : Deflate(differences);
        return packed.Length < block.Length ? packed : block;
    }

    /// <summary>Restores a block of <paramref name="size"/> bytes; as many bytes as that are taken to be stored as they are.</summary>
    public static ReadOnlySpan<byte> Decompress(ExrCompression compression, ReadOnlySpan<byte> packed, int size)
    {
        if (packed.Length == size)
        {
            return packed;
        }

        var differences = new byte[size];
        bool complete = compression switch
        {
            ExrCompression.Rle => UnpackRuns(packed, differences),
            ExrCompression.None => false,
            _ => Inflate(packed, differences),
        };
        return complete ? Undo(differences) : throw new PictureException("one of its blocks of pixels is damaged");
    }

    // Even bytes first, then odd ones (so that exponents meet exponents), then differences of neighbours, centred on 128.
    private static byte[] Difference(ReadOnlySpan<byte> block)
    {
        var result = new byte[block.Length];
        int half = (block.Length + 1) / 2;
        for (int i = 0; i < block.Length; i++)
        {
            result[(i / 2) + ((i & 1) * half)] = block[i];
        }

        for (int i = result.Length - 1; i > 0; i--)
        {
            result[i] = (byte)(result[i] - result[i - 1] + 128);
        }

        return result;
    }

    private static byte[] Undo(byte[] differences)
    {
        for (int i = 1; i < differences.Length; i++)
        {
            differences[i] = (byte)(differences[i] + differences[i - 1] - 128);
        }

        var block = new byte[differences.Length];
        int half = (block.Length + 1) / 2;
        for (int i = 0; i < block.Length; i++)
        {
            block[i] = differences[(i / 2) + ((i & 1) * half)];
        }

        return block;
    }

    private static byte[] Deflate(byte[] data)
    {
        using var packed = new MemoryStream();
        using (var zlib = new ZLibStream(packed, CompressionLevel.Optimal))
        {
            zlib.Write(data);
        }

        return packed.ToArray();
    }

    /// <summary>Unpacks exactly as many bytes as there is room for; false where there are not so many.</summary>
    public static bool Inflate(ReadOnlySpan<byte> packed, byte[] data)
    {
        using var zlib = new ZLibStream(new MemoryStream(packed.ToArray()), CompressionMode.Decompress);
        try
        {
            return zlib.ReadAtLeast(data, data.Length, throwOnEndOfStream: false) == data.Length && zlib.ReadByte() < 0;
        }
        catch (Exception e) when (e is InvalidDataException or IOException)
        {
            return false;
        }
    }

    // A count n ≥ 0 repeats the next byte n + 1 times, n < 0 is followed by −n bytes as they are.
    private static byte[] PackRuns(byte[] data)
    {
        var packed = new List<byte>(data.Length);
        int begin = 0;
        while (begin < data.Length)
        {
            int run = RunAt(data, begin);
            if (run >= ShortestRun)
            {
                packed.Add((byte)(run - 1));
                packed.Add(data[begin]);
                begin += run;
                continue;
            }

            int end = begin + 1;
            while (end < data.Length && end - begin < LongestRun && RunAt(data, end) < ShortestRun)
            {
                end++;
            }

            packed.Add((byte)(begin - end));
            packed.AddRange(data.AsSpan(begin, end - begin));
            begin = end;
        }

        return [.. packed];
    }

    private static int RunAt(byte[] data, int begin)
    {
        int end = begin + 1;
        while (end < data.Length && data[end] == data[begin] && end - begin < LongestRun)
        {
            end++;
        }

        return end - begin;
    }

    private static bool UnpackRuns(ReadOnlySpan<byte> packed, Span<byte> data)
    {
        while (packed.Length >= 2)
        {
            int count = (sbyte)packed[0];
            int length = count < 0 ? -count : count + 1;
            if (length > data.Length || (count < 0 && length >= packed.Length))
            {
                return false;
            }

            if (count < 0)
            {
                packed.Slice(1, length).CopyTo(data);
            }
            else
            {
                data[..length].Fill(packed[1]);
            }

            packed = packed[(count < 0 ? 1 + length : 2)..];
            data = data[length..];
        }

        return packed.IsEmpty && data.IsEmpty;
    }
}
