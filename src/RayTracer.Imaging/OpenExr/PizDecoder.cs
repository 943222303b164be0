using System.Buffers.Binary;

namespace RayTracer.Imaging;

/// <summary>
/// Restores blocks of the compression PIZ (ImfPizCompressor, ImfHuf and ImfWav of OpenEXR's reference implementation): 16-bit numbers, of
/// which only those that occur are counted, as a wavelet transform of each channel, in Huffman codes.
/// </summary>
internal static class PizDecoder
{
    private const int Values = 1 << 16;

    /// <summary>Restores a block.</summary>
    /// <param name="packed">The packed bytes.</param>
    /// <param name="header">The file's header.</param>
    /// <param name="block">The block.</param>
    /// <returns>Its rows, one channel after the other in each; null where it is damaged.</returns>
    public static byte[]? Decode(ReadOnlySpan<byte> packed, ExrHeader header, ExrBlock block)
    {
        if (!TryReadUsedValues(ref packed, out ushort[] values, out int largest) || packed.Length < 4)
        {
            return null;
        }

        int length = BinaryPrimitives.ReadInt32LittleEndian(packed);
        ushort[] numbers = new ushort[block.Bytes / 2];
        if (length < 0 || length > packed.Length - 4 || !PizHuffman.TryDecode(packed.Slice(4, length), numbers))
        {
            return null;
        }

        int begin = 0;
        foreach (ExrChannel channel in header.Channels)
        {
            int size = channel.ValueBytes / 2;
            (int width, int height) = ExrPlanes.Extent(header, block, channel);
            for (int part = 0; part < size; part++)
            {
                PizWavelet.Decode(numbers.AsSpan(begin), part, width, size, height, width * size, largest);
            }

            begin += width * height * size;
        }

        for (int i = 0; i < numbers.Length; i++)
        {
            numbers[i] = values[numbers[i]];
        }

        return ExrPlanes.Rearranged(numbers, header, block);
    }

    // A bit for each number that occurs; 0 always does.
    private static bool TryReadUsedValues(ref ReadOnlySpan<byte> packed, out ushort[] values, out int largest)
    {
        values = new ushort[Values];
        largest = 0;
        if (packed.Length < 4)
        {
            return false;
        }

        int first = BinaryPrimitives.ReadUInt16LittleEndian(packed);
        int last = BinaryPrimitives.ReadUInt16LittleEndian(packed[2..]);
        packed = packed[4..];
        int count = Math.Max(0, last - first + 1);
        if (last >= Values / 8 || packed.Length < count)
        {
            return false;
        }

        int used = 1;
        for (int value = 1; value < Values; value++)
        {
            int place = (value >> 3) - first;
            if ((uint)place < (uint)count && (packed[place] & (1 << (value & 7))) != 0)
            {
                values[used++] = (ushort)value;
            }
        }

        largest = used - 1;
        packed = packed[count..];
        return true;
    }
}
