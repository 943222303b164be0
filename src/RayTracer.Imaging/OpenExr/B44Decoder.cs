using System.Buffers.Binary;
using RayTracer.Numerics;

namespace RayTracer.Imaging;

/// <summary>
/// Restores blocks of the compressions B44 and B44A (ImfB44Compressor of OpenEXR's reference implementation): squares of 4 × 4 halves as
/// one number and 15 differences of 6 bits that share an exponent; with B44A, even squares as the number alone. Other channels are as they
/// are.
/// </summary>
internal static class B44Decoder
{
    private const int Side = 4;
    private const int FullBytes = 14;
    private const int EvenBytes = 3;

    // The exponents of differences go to 12; from here on a square is even.
    private const int EvenShift = 13;

    /// <summary>Restores a block.</summary>
    /// <param name="packed">The packed bytes.</param>
    /// <param name="header">The file's header.</param>
    /// <param name="block">The block.</param>
    /// <returns>Its rows, one channel after the other in each; null where it is damaged.</returns>
    public static byte[]? Decode(ReadOnlySpan<byte> packed, ExrHeader header, ExrBlock block)
    {
        ushort[] numbers = new ushort[block.Bytes / 2];
        Span<ushort> rest = numbers;
        foreach (ExrChannel channel in header.Channels)
        {
            (int width, int height) = ExrPlanes.Extent(header, block, channel);
            Span<ushort> plane = rest[..(width * height * channel.ValueBytes / 2)];
            bool complete = channel.Type == ExrPixelType.Half ? TryReadSquares(ref packed, plane, width, height) : TryCopy(ref packed, plane);
            if (!complete)
            {
                return null;
            }

            if (channel is { Type: ExrPixelType.Half, IsPerceptual: true })
            {
                ToLight(plane);
            }

            rest = rest[plane.Length..];
        }

        return packed.IsEmpty ? ExrPlanes.Rearranged(numbers, header, block) : null;
    }

    private static bool TryCopy(ref ReadOnlySpan<byte> packed, Span<ushort> plane)
    {
        if (packed.Length < 2 * plane.Length)
        {
            return false;
        }

        for (int i = 0; i < plane.Length; i++)
        {
            plane[i] = BinaryPrimitives.ReadUInt16LittleEndian(packed[(2 * i)..]);
        }

        packed = packed[(2 * plane.Length)..];
        return true;
    }

    private static bool TryReadSquares(ref ReadOnlySpan<byte> packed, Span<ushort> plane, int width, int height)
    {
        Span<ushort> square = stackalloc ushort[Side * Side];
        for (int y = 0; y < height; y += Side)
        {
            for (int x = 0; x < width; x += Side)
            {
                if (packed.Length < EvenBytes)
                {
                    return false;
                }

                bool isEven = packed[2] >= EvenShift << 2;
                int bytes = isEven ? EvenBytes : FullBytes;
                if (packed.Length < bytes)
                {
                    return false;
                }

                ReadSquare(packed, isEven, square);
                packed = packed[bytes..];
                for (int row = 0; row < Math.Min(Side, height - y); row++)
                {
                    square.Slice(row * Side, Math.Min(Side, width - x)).CopyTo(plane[(((y + row) * width) + x)..]);
                }
            }
        }

        return true;
    }

    private static void ReadSquare(ReadOnlySpan<byte> packed, bool isEven, Span<ushort> square)
    {
        square[0] = BinaryPrimitives.ReadUInt16BigEndian(packed);
        if (isEven)
        {
            square.Fill(square[0]);
        }
        else
        {
            ReadDifferences(packed, square);
        }

        // The numbers stand in the order of the halves' sizes.
        foreach (ref ushort number in square)
        {
            number = (ushort)((number & 0x8000) != 0 ? number & 0x7FFF : ~number);
        }
    }

    // Down the first column, then from each column to the next.
    private static void ReadDifferences(ReadOnlySpan<byte> packed, Span<ushort> square)
    {
        int shift = packed[2] >> 2;
        int bias = 0x20 << shift;
        int bit = 22;
        for (int i = 1; i < square.Length; i++, bit += 6)
        {
            (int column, int row) = (i / Side, i % Side);
            int before = column == 0 ? (row - 1) * Side : (row * Side) + column - 1;
            int two = (packed[bit >> 3] << 8) | (bit >> 3 < FullBytes - 1 ? packed[(bit >> 3) + 1] : 0);
            int difference = (two >> (10 - (bit & 7))) & 0x3F;
            square[(row * Side) + column] = (ushort)(square[before] + (difference << shift) - bias);
        }
    }

    // Channels that are marked as perceptually linear hold eight times the logarithm.
    private static void ToLight(Span<ushort> plane)
    {
        const double Log2E = 1.4426950408889634;
        foreach (ref ushort number in plane)
        {
            double value = (double)BitConverter.UInt16BitsToHalf(number);
            double light = !double.IsFinite(value) ? 0 : Math.Min(PortableMath.Exp2(value / 8 * Log2E), (double)Half.MaxValue);
            number = BitConverter.HalfToUInt16Bits((Half)light);
        }
    }
}
