using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>One scan (ITU-T T.81, section B.2.3): some coefficients, or bits of coefficients, of some components.</summary>
internal sealed class JpegScan
{
    // Which coefficient of a block, row by row, comes next (T.81, figure A.6).
    private static ReadOnlySpan<byte> ZigZag =>
    [
        0, 1, 8, 16, 9, 2, 3, 10, 17, 24, 32, 25, 18, 11, 4, 5, 12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6, 7, 14, 21, 28,
        35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51, 58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54, 47, 55, 62, 63,
    ];

    private readonly JpegFrame _frame;
    private readonly (JpegComponent Component, JpegHuffmanTable? Dc, JpegHuffmanTable? Ac)[] _parts;
    private readonly int _first;
    private readonly int _last;
    private readonly int _bit; // the lowest that this scan codes
    private readonly bool _refines;
    private readonly int _restartInterval;
    private readonly int[] _predictions;
    private int _endRun; // blocks, after the current one, whose band has ended

    /// <summary>Reads a scan header.</summary>
    /// <param name="frame">The picture.</param>
    /// <param name="data">The bytes after the header's length.</param>
    /// <param name="tables">The Huffman tables: four of DC, then four of AC.</param>
    /// <param name="restartInterval">Units between restart markers; 0 for none.</param>
    /// <exception cref="PictureException">It is damaged or does not continue the scans before it.</exception>
    public JpegScan(JpegFrame frame, ReadOnlySpan<byte> data, JpegHuffmanTable?[] tables, int restartInterval)
    {
        Require(data.Length >= 6 && data[0] is >= 1 and <= 4 && data.Length == 4 + (2 * data[0]), "one of its scan headers has the wrong length");
        _frame = frame;
        _restartInterval = restartInterval;
        _parts = new (JpegComponent, JpegHuffmanTable?, JpegHuffmanTable?)[data[0]];
        _predictions = new int[data[0]];
        ReadOnlySpan<byte> band = data[(1 + (2 * data[0]))..];
        (_first, _last, _bit) = frame.IsProgressive ? (band[0], band[1], band[2] & 15) : (0, 63, 0);
        int before = frame.IsProgressive ? band[2] >> 4 : 0;
        _refines = before != 0;
        Require(_first <= _last && _last < 64 && _bit <= 13 && (!_refines || before == _bit + 1), "one of its scan headers names coefficients or bits that do not exist");
        Require(!frame.IsProgressive || (_first == 0 ? _last == 0 : data[0] == 1), "one of its scans mixes what a progressive scan must not");
        for (int i = 0; i < _parts.Length; i++)
        {
            byte id = data[1 + (2 * i)];
            byte selectors = data[2 + (2 * i)];
            JpegComponent component = Array.Find(frame.Components, c => c.Id == id) ?? throw new PictureException($"one of its scans names component {id}, which is not in its frame");
            Require(selectors >> 4 < 4 && (selectors & 15) < 4, "one of its scans names an impossible Huffman table");
            Require(!_parts.Take(i).Any(p => p.Component == component), "one of its scans names a component twice");
            _parts[i] = (component, tables[selectors >> 4], tables[4 + (selectors & 15)]);
            Require(_parts[i].Dc is not null || _first > 0 || _refines, "a Huffman table of DC coefficients is missing");
            Require(_parts[i].Ac is not null || _last == 0, "a Huffman table of AC coefficients is missing");
            Follow(component, before);
        }
    }

    /// <summary>Returns the place in a block of a coefficient that has a given place in a scan or quantization table.</summary>
    public static int PlaceOf(int index) => ZigZag[index];

    /// <summary>Reads the scan's data.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="position">The offset at which the data begins.</param>
    /// <returns>The offset at which the data ends.</returns>
    /// <exception cref="PictureException">The data is damaged.</exception>
    public int Read(ReadOnlySpan<byte> file, int position)
    {
        // A scan of one component has its blocks one by one, without those that only fill up units (T.81, section A.2.2).
        JpegComponent single = _parts[0].Component;
        bool interleaved = _parts.Length > 1;
        int across = interleaved ? _frame.UnitsAcross : JpegFrame.Divide(single.Width, JpegComponent.Side);
        int down = interleaved ? _frame.UnitsDown : JpegFrame.Divide(single.Height, JpegComponent.Side);
        JpegBits bits = new(file, position);
        int unit = 0;
        for (int y = 0; y < down; y++)
        {
            for (int x = 0; x < across; x++, unit++)
            {
                if (_restartInterval > 0 && unit > 0 && unit % _restartInterval == 0)
                {
                    bits.Restart(((unit / _restartInterval) - 1) % 8);
                    Array.Clear(_predictions);
                    _endRun = 0;
                }

                ReadUnit(ref bits, x, y, interleaved);
                bits.CheckNotEnded();
            }

            if (!_frame.IsProgressive)
            {
                ReconstructRow(y, interleaved);
            }
        }

        return bits.Position;
    }

    // No later scan may add anything to a component that has been coded as a whole (see Follow).
    private void ReconstructRow(int y, bool interleaved)
    {
        foreach ((JpegComponent c, _, _) in _parts)
        {
            int rows = interleaved ? c.Vertical : 1;
            for (int row = y * rows; row < (y + 1) * rows; row++)
            {
                c.ReconstructRow(row);
            }
        }
    }

    private void ReadUnit(ref JpegBits bits, int x, int y, bool interleaved)
    {
        for (int i = 0; i < _parts.Length; i++)
        {
            JpegComponent c = _parts[i].Component;
            (int across, int down) = interleaved ? (c.Horizontal, c.Vertical) : (1, 1);
            for (int block = 0; block < across * down; block++)
            {
                short[] row = c.BlockRow((y * down) + (block / across));
                int column = (x * across) + (block % across);
                ReadBlock(ref bits, i, row.AsSpan(column * JpegComponent.BlockSize, JpegComponent.BlockSize));
            }
        }
    }

    private void ReadBlock(ref JpegBits bits, int part, Span<short> block)
    {
        if (_first == 0 && _refines)
        {
            block[0] |= (short)(bits.Number(1) << _bit);
            return;
        }

        if (_first == 0)
        {
            int length = bits.Symbol(_parts[part].Dc!);
            Require(length <= 15, "one of its DC coefficients has more than 15 bits");
            _predictions[part] += bits.Signed(length);
            block[0] = (short)(_predictions[part] << _bit);
        }

        if (_last > 0 && _refines)
        {
            RefineBand(ref bits, _parts[part].Ac!, block);
        }
        else if (_last > 0)
        {
            ReadBand(ref bits, _parts[part].Ac!, block);
        }
    }

    // T.81, figures F.13 and G.3; runs of ended bands come in progressive pictures only.
    private void ReadBand(ref JpegBits shared, JpegHuffmanTable table, Span<short> block)
    {
        if (_endRun > 0)
        {
            _endRun--;
            return;
        }

        // A copy, which stays in registers.
        JpegBits bits = shared;
        (int last, int bit) = (_last, _bit);
        for (int k = Math.Max(1, _first); k <= last; k++)
        {
            int symbol = bits.SymbolAndNumber(table, out int number);
            (int run, int length) = (symbol >> 4, symbol & 15);
            if (length == 0 && run < 15)
            {
                shared = bits;
                _endRun = _frame.IsProgressive ? EndRun(ref shared, run) : 0;
                return;
            }

            k += run;
            if (length != 0)
            {
                Require(k <= last, "one of its blocks has too many coefficients");
                block[ZigZag[k]] = (short)(number << bit);
            }
        }

        shared = bits;
    }

    private static int EndRun(ref JpegBits bits, int length) => (1 << length) + bits.Number(length) - 1;

    // T.81, section G.1.2.3: coefficients that are not zero get one bit more; between them come new ones, of one bit.
    private void RefineBand(ref JpegBits bits, JpegHuffmanTable table, Span<short> block)
    {
        int k = _first;
        if (_endRun > 0)
        {
            _endRun--;
            RefineOver(ref bits, block, ref k, zeros: JpegComponent.BlockSize);
            return;
        }

        for (; k <= _last; k++)
        {
            int symbol = bits.Symbol(table);
            (int run, int length) = (symbol >> 4, symbol & 15);
            if (length == 0 && run < 15)
            {
                _endRun = EndRun(ref bits, run);
                RefineOver(ref bits, block, ref k, zeros: JpegComponent.BlockSize);
                return;
            }

            Require(length <= 1, "one of its coefficients is refined by more than one bit");
            int value = length == 0 ? 0 : bits.Number(1) == 1 ? 1 << _bit : -1 << _bit;
            RefineOver(ref bits, block, ref k, run);
            if (value != 0)
            {
                Require(k <= _last, "one of its blocks has too many coefficients");
                block[ZigZag[k]] = (short)value;
            }
        }
    }

    // Refines coefficients up to the zero after so many zeros, or to the band's end.
    private void RefineOver(ref JpegBits bits, Span<short> block, ref int k, int zeros)
    {
        for (; k <= _last; k++)
        {
            ref short coefficient = ref block[ZigZag[k]];
            if (coefficient != 0)
            {
                int more = bits.Number(1) << _bit;
                bool isThere = (Math.Abs((int)coefficient) & (1 << _bit)) != 0;
                coefficient += (short)(isThere ? 0 : coefficient > 0 ? more : -more);
            }
            else if (zeros-- == 0)
            {
                return;
            }
        }
    }

    // Every bit of every coefficient is coded once, from the highest on: so the number of scans has a bound.
    private void Follow(JpegComponent component, int before)
    {
        Require(_first == 0 || component.LastBit[0] >= 0, "one of its scans codes AC coefficients before their DC coefficient");
        for (int k = _first; k <= _last; k++)
        {
            Require(component.LastBit[k] == (_refines ? before : -1), "one of its scans repeats what an earlier scan coded, or leaves out bits between");
            component.LastBit[k] = _bit;
        }
    }
}
