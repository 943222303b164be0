namespace RayTracer.Imaging;

/// <summary>
/// Goes through the coefficients of an image in the order of a baseline scan (ITU-T T.81, section F.1.2): first counting symbols, then
/// writing them in the codes that are best for those counts.
/// </summary>
internal sealed class JpegCoder(JpegPlanes planes)
{
    private const int ZeroRun = 0xF0;

    // DC and AC of luminance, DC and AC of differences of colour.
    private readonly long[][] _counts = [new long[256], new long[256], new long[256], new long[256]];
    private JpegHuffmanCode[]? _codes;
    private Stream? _output;
    private ulong _bits;
    private int _count;

    /// <summary>Finds the codes.</summary>
    /// <returns>Of DC and AC of luminance, and of DC and AC of differences of colour.</returns>
    public IReadOnlyList<JpegHuffmanCode> MakeCodes()
    {
        Walk();
        return _codes = [.. _counts.Select(c => new JpegHuffmanCode(c))];
    }

    /// <summary>Writes the scan's data, in the codes that <see cref="MakeCodes"/> found.</summary>
    public void Write(Stream output)
    {
        _output = output;
        Walk();
        Add(0x7F, 7); // ones fill the last byte up
    }

    private void Walk()
    {
        int[] predictions = new int[planes.Components.Length];
        for (int y = 0; y < planes.UnitsDown; y++)
        {
            for (int x = 0; x < planes.UnitsAcross; x++)
            {
                for (int c = 0; c < predictions.Length; c++)
                {
                    WalkUnit(planes.Components[c], x, y, 2 * Math.Min(c, 1), ref predictions[c]);
                }
            }
        }
    }

    private void WalkUnit(JpegComponent component, int x, int y, int table, ref int prediction)
    {
        int side = component.Horizontal;
        for (int block = 0; block < side * side; block++)
        {
            short[] row = component.BlockRow((y * side) + (block / side));
            WalkBlock(row.AsSpan(((x * side) + (block % side)) * JpegComponent.BlockSize, JpegComponent.BlockSize), table, ref prediction);
        }
    }

    private void WalkBlock(ReadOnlySpan<short> block, int table, ref int prediction)
    {
        int difference = block[0] - prediction;
        prediction = block[0];
        Put(table, Size(difference), difference);
        int run = 0;
        int last = block.LastIndexOfAnyExcept((short)0);
        for (int k = 1; k <= last; k++)
        {
            if (block[k] == 0)
            {
                run++;
                continue;
            }

            for (; run > 15; run -= 16)
            {
                Put(table + 1, ZeroRun, 0);
            }

            Put(table + 1, (run << 4) | Size(block[k]), block[k]);
            run = 0;
        }

        if (last < block.Length - 1)
        {
            Put(table + 1, 0, 0);
        }
    }

    private static int Size(int value) => 32 - int.LeadingZeroCount(Math.Abs(value));

    // A symbol, whose low four bits say how many bits of the number follow; negative numbers are one less.
    private void Put(int table, int symbol, int number)
    {
        if (_output is null)
        {
            _counts[table][symbol]++;
            return;
        }

        int size = symbol & 15;
        (int code, int length) = _codes![table][symbol];
        int bits = (number < 0 ? number - 1 : number) & ((1 << size) - 1);
        Add((code << size) | bits, length + size);
    }

    private void Add(int value, int length)
    {
        _bits = (_bits << length) | (uint)value;
        for (_count += length; _count >= 8; _count -= 8)
        {
            byte next = (byte)(_bits >> (_count - 8));
            _output!.WriteByte(next);
            if (next == 0xFF)
            {
                _output.WriteByte(0);
            }
        }
    }
}
