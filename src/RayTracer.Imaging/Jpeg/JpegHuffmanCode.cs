namespace RayTracer.Imaging;

/// <summary>
/// The Huffman code with the fewest bits for symbols that come so often, with at most 16 bits each (ITU-T T.81, annex K.2).
/// </summary>
internal sealed class JpegHuffmanCode
{
    private const int Symbols = 256;
    private const int Longest = 64;

    private readonly ushort[] _codes = new ushort[Symbols];
    private readonly byte[] _lengths = new byte[Symbols];

    /// <summary>Makes the code.</summary>
    /// <param name="frequencies">The frequency of each of the 256 symbols; 0 for those that get no code.</param>
    public JpegHuffmanCode(ReadOnlySpan<long> frequencies)
    {
        int[] lengths = Lengths(frequencies);
        int[] counts = Shortened(lengths);
        byte[] symbols = [.. Enumerable.Range(0, Symbols).Where(s => lengths[s] > 0).OrderBy(s => lengths[s]).Select(s => (byte)s)];
        Table = [.. counts.Select(c => (byte)c), .. symbols];
        int code = 0;
        int next = 0;
        for (int length = 1; length <= JpegHuffmanTable.LongestCode; length++, code <<= 1)
        {
            for (int i = 0; i < counts[length - 1]; i++)
            {
                _codes[symbols[next]] = (ushort)code++;
                _lengths[symbols[next++]] = (byte)length;
            }
        }
    }

    /// <summary>The table as files hold it: how many codes there are of each length, and the symbols in the order of their codes.</summary>
    public byte[] Table { get; }

    /// <summary>The code of a symbol and its length in bits.</summary>
    public (int Code, int Length) this[int symbol] => (_codes[symbol], _lengths[symbol]);

    // Figure K.1: the two rarest become one, over and over. One more symbol takes the code of ones only, which must not be used.
    private static int[] Lengths(ReadOnlySpan<long> frequencies)
    {
        long[] weights = [.. frequencies, 1];
        int[] lengths = new int[weights.Length];
        int[] next = [.. Enumerable.Repeat(-1, weights.Length)];
        while (true)
        {
            int first = Rarest(weights, -1);
            int second = Rarest(weights, first);
            if (second < 0)
            {
                return lengths;
            }

            weights[first] += weights[second];
            weights[second] = 0;
            int last = Lengthen(lengths, next, first);
            next[last] = second;
            Lengthen(lengths, next, second);
        }
    }

    private static int Rarest(long[] weights, int except)
    {
        int rarest = -1;
        for (int i = 0; i < weights.Length; i++)
        {
            if (weights[i] > 0 && i != except && (rarest < 0 || weights[i] <= weights[rarest]))
            {
                rarest = i;
            }
        }

        return rarest;
    }

    private static int Lengthen(int[] lengths, int[] next, int symbol)
    {
        for (; ; symbol = next[symbol])
        {
            lengths[symbol]++;
            if (next[symbol] < 0)
            {
                return symbol;
            }
        }
    }

    // Figure K.3: pairs of too long codes move up to where a shorter code makes room for two; then the code of ones only goes.
    private static int[] Shortened(int[] lengths)
    {
        int[] counts = new int[Longest + 1];
        foreach (int length in lengths)
        {
            counts[length]++;
        }

        counts[0] = 0;
        for (int length = Longest; length > JpegHuffmanTable.LongestCode; length--)
        {
            while (counts[length] > 0)
            {
                int above = length - 2;
                while (counts[above] == 0)
                {
                    above--;
                }

                counts[length] -= 2;
                counts[length - 1]++;
                counts[above + 1] += 2;
                counts[above]--;
            }
        }

        counts[Array.FindLastIndex(counts, JpegHuffmanTable.LongestCode, c => c > 0)]--;
        return counts[1..(JpegHuffmanTable.LongestCode + 1)];
    }
}
