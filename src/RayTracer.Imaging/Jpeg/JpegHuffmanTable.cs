using System.Runtime.CompilerServices;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>A table of Huffman codes (ITU-T T.81, annex C): short codes are looked up at once, longer ones by their length.</summary>
internal sealed class JpegHuffmanTable
{
    /// <summary>Bits of the codes that are looked up at once.</summary>
    public const int FastBits = 9;

    /// <summary>Bits of the codes that are looked up at once together with the numbers after them.</summary>
    public const int KnownBits = 10;

    /// <summary>Bits of the longest code.</summary>
    public const int LongestCode = 16;

    private readonly ushort[] _fast = new ushort[1 << FastBits];
    private readonly int[] _known = new int[1 << KnownBits];
    private readonly byte[] _symbols;

    // For each length: one more than the largest code (0: none), and what to add to a code to get the place of its symbol.
    private readonly int[] _codeEnd = new int[LongestCode + 1];
    private readonly int[] _symbolOffset = new int[LongestCode + 1];

    /// <summary>Makes the codes of a table.</summary>
    /// <param name="counts">The number of codes of each length from 1 to 16.</param>
    /// <param name="symbols">The symbols of the codes, in the order of the codes.</param>
    /// <exception cref="PictureException">There are more codes of a length than there can be.</exception>
    public JpegHuffmanTable(ReadOnlySpan<byte> counts, ReadOnlySpan<byte> symbols)
    {
        _symbols = symbols.ToArray();
        int code = 0;
        int place = 0;
        for (int length = 1; length <= LongestCode; length++, code <<= 1)
        {
            _symbolOffset[length] = place - code;
            int count = counts[length - 1];
            Require(code + count <= 1 << length, $"one of its Huffman tables has too many codes of {length} bits");

            for (int i = 0; i < count && length <= FastBits; i++)
            {
                int shift = FastBits - length;
                _fast.AsSpan((code + i) << shift, 1 << shift).Fill((ushort)((length << 8) | _symbols[place + i]));
            }

            for (int i = 0; i < count && length <= KnownBits; i++)
            {
                SetKnown(code + i, length, _symbols[place + i]);
            }

            code += count;
            place += count;
            _codeEnd[length] = count == 0 ? 0 : code;
        }
    }

    /// <summary>The code that 16 bits begin with: its length times 256, plus its symbol; 0 where no code begins so.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Find(int bits)
    {
        int found = _fast[bits >> (LongestCode - FastBits)];
        return found != 0 ? found : FindLong(bits);
    }

    /// <summary>
    /// The code that 16 bits begin with, and the number after it: the number times 65,536, plus the symbol times 256, plus how many bits
    /// both take; 0 where these are too many.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int FindWithNumber(int bits) => _known[bits >> (LongestCode - KnownBits)];

    /// <summary>A number whose first bit is its sign (T.81, figure F.12).</summary>
    /// <param name="bits">The number's bits.</param>
    /// <param name="length">The number of these bits.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Extend(int bits, int length)
    {
        // The lower half of the numbers, those without the highest bit, are negative.
        int isNegative = length == 0 ? 0 : (bits >> (length - 1)) - 1;
        return bits + (isNegative & (1 - (1 << length)));
    }

    // As many bits as the symbol's low four bits say follow the code.
    private void SetKnown(int code, int length, byte symbol)
    {
        int size = symbol & 15;
        int shift = KnownBits - length - size;
        for (int number = 0; number < 1 << size && shift >= 0; number++)
        {
            int known = (Extend(number, size) << 16) | (symbol << 8) | (length + size);
            _known.AsSpan(((code << size) | number) << shift, 1 << shift).Fill(known);
        }
    }

    private int FindLong(int bits)
    {
        for (int length = FastBits + 1; length <= LongestCode; length++)
        {
            int code = bits >> (LongestCode - length);
            if (code < _codeEnd[length])
            {
                return (length << 8) | _symbols[code + _symbolOffset[length]];
            }
        }

        return 0;
    }
}
