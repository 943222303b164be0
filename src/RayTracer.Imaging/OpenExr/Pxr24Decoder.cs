using System.Buffers.Binary;

namespace RayTracer.Imaging;

/// <summary>
/// Restores blocks of the compression PXR24 (ImfPxr24Compressor of OpenEXR's reference implementation): Deflate of differences between
/// neighbours in a row, their highest bytes first; of floats, the upper 24 bits.
/// </summary>
internal static class Pxr24Decoder
{
    /// <summary>Restores a block.</summary>
    /// <param name="packed">The packed bytes.</param>
    /// <param name="header">The file's header.</param>
    /// <param name="block">The block.</param>
    /// <returns>Its rows, one channel after the other in each; null where it is damaged.</returns>
    public static byte[]? Decode(ReadOnlySpan<byte> packed, ExrHeader header, ExrBlock block)
    {
        byte[] planes = new byte[PlaneBytes(header, block)];
        if (!ExrBlockCodec.Inflate(packed, planes))
        {
            return null;
        }

        byte[] bytes = new byte[block.Bytes];
        ReadOnlySpan<byte> from = planes;
        Span<byte> to = bytes;
        for (int y = 0; y < block.Rows; y++)
        {
            foreach (ExrChannel channel in header.Channels)
            {
                int count = block.RowBytes(header, channel, y) / channel.ValueBytes;
                Restore(from, to, count, channel);
                from = from[(count * StoredBytes(channel))..];
                to = to[(count * channel.ValueBytes)..];
            }
        }

        return bytes;
    }

    private static int PlaneBytes(ExrHeader header, ExrBlock block)
    {
        int bytes = 0;
        for (int y = 0; y < block.Rows; y++)
        {
            foreach (ExrChannel channel in header.Channels)
            {
                bytes += block.RowBytes(header, channel, y) / channel.ValueBytes * StoredBytes(channel);
            }
        }

        return bytes;
    }

    private static int StoredBytes(ExrChannel channel) => channel.Type == ExrPixelType.Float ? 3 : channel.ValueBytes;

    private static void Restore(ReadOnlySpan<byte> from, Span<byte> to, int count, ExrChannel channel)
    {
        int stored = StoredBytes(channel);
        uint value = 0;
        for (int i = 0; i < count; i++)
        {
            uint difference = 0;
            for (int plane = 0; plane < stored; plane++)
            {
                difference = (difference << 8) | from[(plane * count) + i];
            }

            value += channel.Type == ExrPixelType.Float ? difference << 8 : difference;
            if (channel.Type == ExrPixelType.Half)
            {
                BinaryPrimitives.WriteUInt16LittleEndian(to[(2 * i)..], (ushort)value);
            }
            else
            {
                BinaryPrimitives.WriteUInt32LittleEndian(to[(4 * i)..], value);
            }
        }
    }
}
