using System.Buffers.Binary;
using System.IO.Compression;

namespace RayTracer.RenderTests.Oracle;

/// <summary>Reads the PNG files of the oracle's scenes: 8-bit RGB, not interlaced.</summary>
internal static class PngFile
{
    private const int BytesPerPixel = 3;

    /// <summary>The picture's rows, the top one first.</summary>
    /// <param name="path">The file.</param>
    /// <param name="raw">Whether numbers are linear, not sRGB.</param>
    public static Vec[][] Read(string path, bool raw)
    {
        byte[] file = File.ReadAllBytes(path);
        int width = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(16));
        int height = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(20));
        if (!file.AsSpan(24, 5).SequenceEqual<byte>([8, 2, 0, 0, 0]))
        {
            throw new FormatException($"{path}: not 8-bit RGB without interlacing");
        }

        using MemoryStream compressed = new();
        for (int at = 8; at < file.Length; at += 12 + BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at)))
        {
            if (file.AsSpan(at + 4, 4).SequenceEqual("IDAT"u8))
            {
                compressed.Write(file, at + 8, BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at)));
            }
        }

        compressed.Position = 0;
        using ZLibStream stream = new(compressed, CompressionMode.Decompress);
        byte[] above = new byte[BytesPerPixel * width];
        return [.. Enumerable.Range(0, height).Select(_ => Colors(above = ReadRow(stream, above), raw))];
    }

    /// <summary>A byte as linear light.</summary>
    public static double Linear(byte code, bool raw)
    {
        double value = code / 255.0;
        return raw ? value : value <= 0.04045 ? value / 12.92 : Math.Pow((value + 0.055) / 1.055, 2.4);
    }

    private static byte[] ReadRow(ZLibStream stream, byte[] above)
    {
        int filter = stream.ReadByte();
        byte[] row = new byte[above.Length];
        stream.ReadExactly(row);
        for (int i = 0; i < row.Length; i++)
        {
            int left = i < BytesPerPixel ? 0 : row[i - BytesPerPixel];
            int corner = i < BytesPerPixel ? 0 : above[i - BytesPerPixel];
            row[i] += (byte)(filter switch
            {
                0 => 0,
                1 => left,
                2 => above[i],
                3 => (left + above[i]) / 2,
                4 => new[] { left, above[i], corner }.MinBy(p => Math.Abs(left + above[i] - corner - p)),
                _ => throw new FormatException($"filter {filter}"),
            });
        }

        return row;
    }

    private static Vec[] Colors(byte[] row, bool raw) =>
        [.. row.Chunk(BytesPerPixel).Select(p => new Vec(Linear(p[0], raw), Linear(p[1], raw), Linear(p[2], raw)))];
}
