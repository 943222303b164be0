namespace RayTracer.Imaging.Tests;

/// <summary>
/// A small encoder of baseline JPEG files of any layout, written from ITU-T T.81 for the tests, that knows which samples its file must
/// be read as: the inverse transform of the definition (T.81, section A.3.3), in double precision.
/// </summary>
internal sealed class TestJpeg
{
    private static readonly int[] s_zigzag = [.. ZigZag()];
    private static readonly double[,] s_cosines = Cosines();

    private readonly List<byte> _file = [0xFF, 0xD8];
    private ulong _bits;
    private int _count;

    public required int Width { get; init; }

    public required int Height { get; init; }

    /// <summary>Horizontal and vertical sampling factors of each component.</summary>
    public required (int H, int V)[] Factors { get; init; }

    /// <summary>A component's samples before coding, from 0 to 255.</summary>
    public required Func<int, int, int, double> Sample { get; init; }

    public string Names { get; init; } = "\u0001\u0002\u0003\u0004";

    /// <summary>Units between restart markers; 0 for none.</summary>
    public int RestartInterval { get; init; }

    /// <summary>Whether all components share one scan.</summary>
    public bool Interleaved { get; init; } = true;

    /// <summary>Bits of every code of an AC coefficient, from 8 to 16.</summary>
    public int AcCodeLength { get; init; } = 8;

    public byte FrameMarker { get; init; } = 0xC0;

    /// <summary>Segments behind the file's first marker, whole.</summary>
    public byte[] Segments { get; init; } = [];

    public int QuantizationStep { get; init; } = 3;

    /// <summary>For each component its samples as they must be read, not rounded; rows of whole units.</summary>
    public double[][,] Samples { get; private set; } = [];

    public static byte[] Adobe(byte transform) => [0xFF, 0xEE, 0, 14, .. "Adobe"u8, 0, 100, 0, 0, 0, 0, transform];

    public static byte[] Jfif => [0xFF, 0xE0, 0, 16, .. "JFIF\0"u8, 1, 1, 0, 0, 1, 0, 1, 0, 0];

    private int MaxH => Factors.Max(f => f.H);

    private int MaxV => Factors.Max(f => f.V);

    public byte[] Encode()
    {
        (int across, int down) = ((Width + (8 * MaxH) - 1) / (8 * MaxH), (Height + (8 * MaxV) - 1) / (8 * MaxV));
        Samples = [.. Factors.Select(f => new double[down * f.V * 8, across * f.H * 8])];
        _file.AddRange(Segments);
        AddSegment(0xDB, [0, .. Enumerable.Repeat((byte)QuantizationStep, 64)]);
        AddSegment(FrameMarker, [8, (byte)(Height >> 8), (byte)Height, (byte)(Width >> 8), (byte)Width, (byte)Factors.Length,
            .. Factors.SelectMany((f, i) => new byte[] { (byte)Names[i], (byte)((f.H << 4) | f.V), 0 })]);
        AddSegment(0xC4, [0x00, .. Counts(4, 12), .. Enumerable.Range(0, 12).Select(i => (byte)i)]);
        AddSegment(0xC4, [0x10, .. Counts(AcCodeLength, 162), .. AcSymbols()]);
        AddSegment(0xDD, [(byte)(RestartInterval >> 8), (byte)RestartInterval]);
        int[] all = [.. Enumerable.Range(0, Factors.Length)];
        foreach (int[] scan in Interleaved ? [all] : all.Select(i => new[] { i }))
        {
            AddScan(scan, across, down);
        }

        _file.AddRange([0xFF, 0xD9]);
        return [.. _file];
    }

    /// <summary>The samples of a component in row y at the places of the pixels: interpolated linearly where it has half as many, else the one around the place.</summary>
    public double SampleAt(int component, int x, int y)
    {
        (int h, int v) = Factors[component];
        (int width, int height) = (((Width * h) + MaxH - 1) / MaxH, ((Height * v) + MaxV - 1) / MaxV);
        bool smooth = MaxH <= 2 * h && MaxV <= 2 * v && MaxH % h == 0 && MaxV % v == 0;
        (int x0, int x1, double tx) = Place((x + 0.5) * h / MaxH, width, smooth);
        (int y0, int y1, double ty) = Place((y + 0.5) * v / MaxV, height, smooth);
        double At(int yy, int xx) => Math.Clamp(Math.Floor(Samples[component][yy, xx] + 0.5), 0, 255);
        return ((1 - ty) * (((1 - tx) * At(y0, x0)) + (tx * At(y0, x1)))) + (ty * (((1 - tx) * At(y1, x0)) + (tx * At(y1, x1))));
    }

    private static (int Low, int High, double Between) Place(double position, int size, bool smooth)
    {
        if (!smooth)
        {
            return ((int)position, (int)position, 0);
        }

        int low = (int)Math.Floor(position - 0.5);
        return (Math.Clamp(low, 0, size - 1), Math.Clamp(low + 1, 0, size - 1), position - 0.5 - low);
    }

    private void AddScan(int[] components, int across, int down)
    {
        AddSegment(0xDA, [(byte)components.Length, .. components.SelectMany(c => new byte[] { (byte)Names[c], 0 }), 0, 63, 0]);
        var predictions = new int[Factors.Length];
        bool single = components.Length == 1;
        (int h, int v) = Factors[components[0]];
        int unitsAcross = single ? ((((Width * h) + MaxH - 1) / MaxH) + 7) / 8 : across;
        int unitsDown = single ? ((((Height * v) + MaxV - 1) / MaxV) + 7) / 8 : down;
        for (int unit = 0; unit < unitsAcross * unitsDown; unit++)
        {
            if (RestartInterval > 0 && unit > 0 && unit % RestartInterval == 0)
            {
                Align();
                _file.AddRange([0xFF, (byte)(0xD0 + (((unit / RestartInterval) - 1) % 8))]);
                Array.Clear(predictions);
            }

            foreach (int c in components)
            {
                (int blocksAcross, int blocksDown) = single ? (1, 1) : Factors[c];
                for (int b = 0; b < blocksAcross * blocksDown; b++)
                {
                    int column = (unit % unitsAcross * blocksAcross) + (b % blocksAcross);
                    int row = (unit / unitsAcross * blocksDown) + (b / blocksAcross);
                    AddBlock(c, 8 * column, 8 * row, ref predictions[c]);
                }
            }
        }

        Align();
    }

    private void AddBlock(int component, int left, int top, ref int prediction)
    {
        var coefficients = new int[64];
        for (int i = 0; i < 64; i++)
        {
            coefficients[i] = (int)Math.Round(Forward(component, left, top, i % 8, i / 8) / QuantizationStep);
        }

        for (int y = 0; y < 8; y++)
        {
            for (int x = 0; x < 8; x++)
            {
                double sum = 0;
                for (int i = 0; i < 64; i++)
                {
                    sum += coefficients[i] * QuantizationStep * s_cosines[i % 8, x] * s_cosines[i / 8, y];
                }

                Samples[component][top + y, left + x] = (sum / 4) + 128;
            }
        }

        int difference = coefficients[0] - prediction;
        prediction = coefficients[0];
        Add(Size(difference), 4);
        AddNumber(difference);
        int run = 0;
        for (int k = 1; k < 64; k++)
        {
            int value = coefficients[s_zigzag[k]];
            if (value == 0)
            {
                run++;
                continue;
            }

            for (; run > 15; run -= 16)
            {
                AddAc(0xF0);
            }

            AddAc((run << 4) | Size(value));
            AddNumber(value);
            run = 0;
        }

        if (run > 0)
        {
            AddAc(0);
        }
    }

    private double Forward(int component, int left, int top, int u, int v)
    {
        double sum = 0;
        for (int i = 0; i < 64; i++)
        {
            sum += (Sample(component, left + (i % 8), top + (i / 8)) - 128) * s_cosines[u, i % 8] * s_cosines[v, i / 8];
        }

        return sum / 4;
    }

    private void AddAc(int symbol) => Add(Array.IndexOf(AcSymbols(), (byte)symbol), AcCodeLength);

    private static int Size(int value) => 32 - int.LeadingZeroCount(Math.Abs(value));

    private void AddNumber(int value) => Add(value < 0 ? value - 1 + (1 << Size(value)) : value, Size(value));

    private void Add(int value, int length)
    {
        _bits = (_bits << length) | (uint)value;
        for (_count += length; _count >= 8; _count -= 8)
        {
            byte next = (byte)(_bits >> (_count - 8));
            _file.AddRange(next == 0xFF ? [0xFF, 0] : [next]);
        }
    }

    private void Align() => Add((1 << ((8 - _count) & 7)) - 1, (8 - _count) & 7);

    private void AddSegment(byte marker, byte[] data) => _file.AddRange([0xFF, marker, (byte)((data.Length + 2) >> 8), (byte)(data.Length + 2), .. data]);

    private static byte[] Counts(int length, int count) => [.. Enumerable.Range(1, 16).Select(i => (byte)(i == length ? count : 0))];

    private static byte[] AcSymbols() => [0, 0xF0, .. Enumerable.Range(0, 160).Select(i => (byte)((i / 10 << 4) | (1 + (i % 10))))];

    // The diagonals in turn, up and down.
    private static IEnumerable<int> ZigZag() => Enumerable.Range(0, 64)
        .OrderBy(i => (i % 8) + (i / 8))
        .ThenBy(i => ((i % 8) + (i / 8)) % 2 == 0 ? i % 8 : i / 8);

    private static double[,] Cosines()
    {
        var cosines = new double[8, 8];
        for (int i = 0; i < 64; i++)
        {
            cosines[i / 8, i % 8] = (i < 8 ? Math.Sqrt(0.5) : 1) * Math.Cos(((2 * (i % 8)) + 1) * (i / 8) * Math.PI / 16);
        }

        return cosines;
    }
}
