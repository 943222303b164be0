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

    /// <summary>Where the next byte is read from; at the scan's end, its marker.</summary>
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
            ThrowNoCode();
        }

        _count -= found >> 8;
        return found & 0xFF;
    }

    // Apart, so that what is done for every symbol stays short enough to be inlined.
    private readonly void ThrowNoCode() => throw new PictureException($"its image data holds a code that its Huffman table does not (before byte {Position})");

    /// <summary>Reads one symbol, and the number with a sign that has as many bits as the symbol's low four bits say.</summary>
    /// <exception cref="PictureException">The bits are those of no code.</exception>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int SymbolAndNumber(JpegHuffmanTable table, out int number)
    {
        int symbol = Symbol(table);
        int length = symbol & 15;
        _count -= length;
        int bits = (int)(_bits >> _count) & ((1 << length) - 1);

        // The lower half of the numbers, those without the highest bit, are negative.
        int isNegative = length == 0 ? 0 : (bits >> (length - 1)) - 1;
        number = bits + (isNegative & (1 - (1 << length)));
        return symbol;
    }

    /// <summary>Reads a number of up to 16 bits without a sign.</summary>
    public int Number(int length)
    {
        Fill();
        _count -= length;
        return (int)(_bits >> _count) & ((1 << length) - 1);
    }

    /// <summary>Reads a number of up to 16 bits whose first bit tells its sign (T.81, figure F.12).</summary>
    public int Signed(int length)
    {
        if (length == 0)
        {
            return 0;
        }

        int number = Number(length);
        return number < 1 << (length - 1) ? number - (1 << length) + 1 : number;
    }

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

        FillByBytes();
    }

    private void FillByBytes()
    {
        while (_count < Enough)
        {
            _bits <<= 8;
            _count += 8;
            if (Position >= _file.Length || (_file[Position] == 0xFF && (Position + 1 >= _file.Length || _file[Position + 1] != 0)))
            {
                _lent += 8;
                continue;
            }

            byte next = _file[Position];
            _bits |= next;
            Position += next == 0xFF ? 2 : 1; // a zero is stuffed in after each 255
        }
    }
}
