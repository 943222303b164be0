using System.Buffers.Binary;

namespace RayTracer.Imaging;

/// <summary>Blocks whose compression holds one channel after the other, as numbers of 16 bits.</summary>
internal static class ExrPlanes
{
    /// <summary>The number of values a channel has in a row of a block, and in how many rows.</summary>
    public static (int Width, int Height) Extent(ExrHeader header, ExrBlock block, ExrChannel channel)
    {
        int width = 0;
        int height = 0;
        for (int y = 0; y < block.Rows; y++)
        {
            int inRow = block.RowBytes(header, channel, y) / channel.ValueBytes;
            width = Math.Max(width, inRow);
            height += inRow > 0 ? 1 : 0;
        }

        return (width, height);
    }

    /// <summary>From channel after channel to row after row.</summary>
    public static byte[] Rearranged(ushort[] numbers, ExrHeader header, ExrBlock block)
    {
        byte[] bytes = new byte[block.Bytes];
        int[] next = new int[header.Channels.Count];
        for (int c = 1; c < next.Length; c++)
        {
            (int width, int height) = Extent(header, block, header.Channels[c - 1]);
            next[c] = next[c - 1] + (width * height * header.Channels[c - 1].ValueBytes / 2);
        }

        int at = 0;
        for (int y = 0; y < block.Rows; y++)
        {
            for (int c = 0; c < next.Length; c++)
            {
                int count = block.RowBytes(header, header.Channels[c], y) / 2;
                for (int i = 0; i < count; i++, at += 2)
                {
                    BinaryPrimitives.WriteUInt16LittleEndian(bytes.AsSpan(at), numbers[next[c]++]);
                }
            }
        }

        return bytes;
    }
}
