using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>The bits of a scan (ITU-T T.81, section F.2.2), up to the next marker.</summary>
internal ref struct JpegBits
{
    // A symbol and the bits after it take at most 16 + 16 of these.
    private const int Enough = 32;

    private readonly ReadOnlySpan<byte> _file;
    private ulong _bits; // the lowest _count of them are still to be read
    private int _count;
    private int _lent; // how many of them are zeros behind the scan's end

    public JpegBits(ReadOnlySpan<byte> file, int position)
    {
        _file = file;
        Position = position;
    }

    /// <summary>The position of the next byte; at the scan's end, its marker.</summary>
    public int Position { get; private set; }

    /// <summary>Reads one symbol.</summary>
    /// <exception cref="PictureException">The bits are those of no code.</exception>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Symbol(JpegHuffmanTable table)
    {
        Fill();
        int found = table.Find((int)(_bits >> (_count - JpegHuffmanTable.LongestCode)) & 0xFFFF);
        if (found == 0)
        {
            ThrowNoCode(Position);
        }

        _count -= found >> 8;
        return found & 0xFF;
    }

    // Apart, so that what is done for every symbol stays short enough to be inlined.
    private static void ThrowNoCode(int position) =>
        throw new PictureException($"its image data holds a code that its Huffman table does not (before byte {position})");

    /// <summary>Reads one symbol, and the number with a sign that has as many bits as the symbol's low four bits say.</summary>
    /// <exception cref="PictureException">The bits are those of no code.</exception>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int SymbolAndNumber(JpegHuffmanTable table, out int number)
    {
        Fill();
        int known = table.FindWithNumber((int)(_bits >> (_count - JpegHuffmanTable.LongestCode)) & 0xFFFF);
        if (known != 0)
        {
            _count -= known & 0xFF;
            number = known >> 16;
            return (known >> 8) & 0xFF;
        }

        int symbol = Symbol(table);
        int length = symbol & 15;
        _count -= length;
        number = JpegHuffmanTable.Extend((int)(_bits >> _count) & ((1 << length) - 1), length);
        return symbol;
    }

    /// <summary>Reads a number of up to 16 bits without a sign.</summary>
    public int Number(int length)
    {
        Fill();
        _count -= length;
        return (int)(_bits >> _count) & ((1 << length) - 1);
    }

    /// <summary>Reads a number of up to 16 bits whose first bit is its sign.</summary>
    public int Signed(int length) => JpegHuffmanTable.Extend(Number(length), length);

    /// <summary>Checks that all that was read was there.</summary>
    /// <exception cref="PictureException">More was read than there is before the next marker.</exception>
    public readonly void CheckNotEnded()
    {
        if (_count < _lent)
        {
            throw new PictureException($"its image data ends before its last block (at byte {Position})");
        }
    }

    /// <summary>Goes over a restart marker.</summary>
    /// <param name="number">The marker's number, from 0 to 7.</param>
    /// <exception cref="PictureException">Something else is here.</exception>
    public void Restart(int number)
    {
        (_bits, _count, _lent) = (0, 0, 0);
        int at = Position;
        while (at + 1 < _file.Length && _file[at] == 0xFF && _file[at + 1] == 0xFF)
        {
            at++;
        }

        if (at + 1 >= _file.Length || _file[at] != 0xFF || _file[at + 1] != 0xD0 + number)
        {
            throw new PictureException($"its restart marker {number} is missing at byte {Position}");
        }

        Position = at + 2;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Fill()
    {
        if (_count >= Enough)
        {
            return;
        }

        // Four bytes at once where none is 255, that is, no byte of the complement is zero.
        if (Position <= _file.Length - sizeof(uint))
        {
            uint four = BinaryPrimitives.ReadUInt32BigEndian(_file[Position..]);
            if (((~four - 0x01010101u) & four & 0x80808080u) == 0)
            {
                _bits = (_bits << 32) | four;
                _count += 32;
                Position += sizeof(uint);
                return;
            }
        }

        this = FillByBytes(this);
    }

    // By value, so that bits being read can stay in registers.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static JpegBits FillByBytes(JpegBits bits)
    {
        while (bits._count < Enough)
        {
            bits._bits <<= 8;
            bits._count += 8;
            ReadOnlySpan<byte> file = bits._file;
            if (bits.Position >= file.Length || (file[bits.Position] == 0xFF && (bits.Position + 1 >= file.Length || file[bits.Position + 1] != 0)))
            {
                bits._lent += 8;
                continue;
            }

            byte next = file[bits.Position];
            bits._bits |= next;
            bits.Position += next == 0xFF ? 2 : 1; // a zero is stuffed in after each 255
        }

        return bits;
    }
}
