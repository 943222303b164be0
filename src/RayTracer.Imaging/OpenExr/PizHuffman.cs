using System.Buffers.Binary;

namespace RayTracer.Imaging;

/// <summary>The Huffman codes of the compression PIZ: of numbers of 16 bits, with one code for repetitions.</summary>
internal ref struct PizHuffman
{
    private const int HeaderBytes = 20;
    private const int Symbols = (1 << 16) + 1;
    private const int LongestCode = 58;
    private const int ShortRun = 59;
    private const int LongRun = 63;

    private readonly ReadOnlySpan<byte> _bytes;
    private long _position; // in bits

    private PizHuffman(ReadOnlySpan<byte> bytes) => _bytes = bytes;

    /// <summary>Decodes as many numbers as there is room for.</summary>
    /// <returns>True if they were there.</returns>
    public static bool TryDecode(ReadOnlySpan<byte> packed, Span<ushort> numbers)
    {
        if (packed.Length < HeaderBytes)
        {
            return numbers.IsEmpty;
        }

        int first = BinaryPrimitives.ReadInt32LittleEndian(packed);
        int last = BinaryPrimitives.ReadInt32LittleEndian(packed[4..]);
        int bits = BinaryPrimitives.ReadInt32LittleEndian(packed[12..]);
        if (first < 0 || last < first || last >= Symbols || bits < 0)
        {
            return false;
        }

        byte[] lengths = new byte[Symbols];
        var reader = new PizHuffman(packed[HeaderBytes..]);
        if (!reader.TryReadLengths(lengths, first, last))
        {
            return false;
        }

        var codes = new PizHuffman(packed[(HeaderBytes + (int)((reader._position + 7) / 8))..]);
        return bits <= 8L * codes._bytes.Length && codes.TryReadNumbers(lengths, last, numbers);
    }

    private bool TryReadLengths(byte[] lengths, int first, int last)
    {
        for (int symbol = first; symbol <= last; symbol++)
        {
            int length = Bits(6);
            if (length < 0)
            {
                return false;
            }

            if (length < ShortRun)
            {
                lengths[symbol] = (byte)length;
                continue;
            }

            // Symbols that do not occur.
            int run = length == LongRun ? Bits(8) + 6 : length - ShortRun + 2;
            if (run < 2 || symbol + run > last + 1)
            {
                return false;
            }

            symbol += run - 1;
        }

        return true;
    }

    // Codes of one length follow one another; shorter ones are larger numbers than the beginnings of longer ones.
    private bool TryReadNumbers(byte[] lengths, int repeat, Span<ushort> numbers)
    {
        long[] firstCode = new long[LongestCode + 1];
        int[] count = new int[LongestCode + 1];
        int[] offset = new int[LongestCode + 2];
        foreach (byte length in lengths)
        {
            count[length]++;
        }

        long code = 0;
        for (int length = LongestCode; length > 0; length--)
        {
            firstCode[length] = code;
            code = (code + count[length]) >> 1;
        }

        for (int length = 1; length <= LongestCode; length++)
        {
            offset[length + 1] = offset[length] + count[length];
        }

        int[] symbols = new int[offset[LongestCode + 1]];
        int[] next = [.. offset];
        for (int symbol = 0; symbol < lengths.Length; symbol++)
        {
            if (lengths[symbol] > 0)
            {
                symbols[next[lengths[symbol]]++] = symbol;
            }
        }

        int written = 0;
        while (written < numbers.Length)
        {
            int symbol = Symbol(firstCode, count, offset, symbols);
            if (symbol < 0)
            {
                return false;
            }

            if (symbol != repeat)
            {
                numbers[written++] = (ushort)symbol;
                continue;
            }

            int times = Bits(8);
            if (times < 0 || written == 0 || times > numbers.Length - written)
            {
                return false;
            }

            numbers.Slice(written, times).Fill(numbers[written - 1]);
            written += times;
        }

        return true;
    }

    private int Symbol(long[] firstCode, int[] count, int[] offset, int[] symbols)
    {
        long code = 0;
        for (int length = 1; length <= LongestCode; length++)
        {
            int bit = Bits(1);
            if (bit < 0)
            {
                return -1;
            }

            code = (code << 1) | (uint)bit;
            long place = code - firstCode[length];
            if (place >= 0 && place < count[length])
            {
                return symbols[offset[length] + (int)place];
            }
        }

        return -1;
    }

    // The highest bit of a byte comes first; below zero behind the end.
    private int Bits(int count)
    {
        int bits = 0;
        for (int i = 0; i < count; i++, _position++)
        {
            int at = (int)(_position >> 3);
            if (at >= _bytes.Length)
            {
                return -1;
            }

            bits = (bits << 1) | ((_bytes[at] >> (7 - (int)(_position & 7))) & 1);
        }

        return bits;
    }
}
