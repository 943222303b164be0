using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>One component (luminance, a colour difference, a colour) of a JPEG picture: first its coefficients, then its samples.</summary>
internal sealed class JpegComponent(byte id, int horizontal, int vertical, int quantization)
{
    /// <summary>Samples on a side of a block.</summary>
    public const int Side = 8;

    /// <summary>Coefficients of a block.</summary>
    public const int BlockSize = Side * Side;

    private short[]?[] _coefficients = [];
    private bool[] _isDone = [];
    private short[]? _spare; // of a row that is done, all zero
    private float[]? _steps;

    /// <summary>The name by which scans call it.</summary>
    public byte Id => id;

    /// <summary>Blocks of a unit (MCU) side by side.</summary>
    public int Horizontal => horizontal;

    /// <summary>Blocks of a unit one above the other.</summary>
    public int Vertical => vertical;

    /// <summary>The number of its quantization table.</summary>
    public int Quantization => quantization;

    /// <summary>Samples in a row.</summary>
    public int Width { get; private set; }

    /// <summary>Rows of samples.</summary>
    public int Height { get; private set; }

    /// <summary>Bytes from one row of samples to the next.</summary>
    public int Stride { get; private set; }

    /// <summary>The samples, once <see cref="Reconstruct"/> has been called; rows of <see cref="Stride"/>.</summary>
    public byte[] Samples { get; private set; } = [];

    /// <summary>For each coefficient, in the order of scans, which of its bits was coded last; −1 where it was not coded at all.</summary>
    public int[] LastBit { get; } = [.. Enumerable.Repeat(-1, BlockSize)];

    /// <summary>Lays out the blocks.</summary>
    public void SetSize(int width, int height, int unitsAcross, int unitsDown)
    {
        Width = width;
        Height = height;
        Stride = unitsAcross * horizontal * Side;
        _coefficients = new short[]?[unitsDown * vertical];
        _isDone = new bool[unitsDown * vertical];
    }

    /// <summary>
    /// A row of blocks, 64 coefficients each; it takes memory only from its first use on, so that a mere claim of size costs nothing.
    /// </summary>
    public short[] BlockRow(int row)
    {
        short[] blocks = _coefficients[row] ?? _spare ?? new short[Stride * Side];
        _spare = blocks == _spare ? null : _spare;
        return _coefficients[row] = blocks;
    }

    /// <summary>
    /// Remembers the quantization that holds at its first scan; tables may be redefined after it (T.81, section B.2.4.1).
    /// </summary>
    /// <exception cref="PictureException">There is no such table.</exception>
    public void LatchQuantization(float[]?[] tables) => _steps ??= tables[quantization]
        ?? throw new PictureException($"its quantization table {quantization} is missing");

    /// <summary>Turns a row of blocks, all of whose coefficients have been read, into samples.</summary>
    public void ReconstructRow(int row)
    {
        if (Samples.Length == 0)
        {
            Samples = new byte[_coefficients.Length * Side * Stride];
        }

        short[] blocks = BlockRow(row);
        Span<byte> samples = Samples.AsSpan(row * Side * Stride, Side * Stride);
        for (int block = 0; block < Stride / Side; block++)
        {
            JpegTransform.Inverse(blocks.AsSpan(block * BlockSize, BlockSize), _steps!, samples[(block * Side)..], Stride);
        }

        blocks.AsSpan().Clear();
        (_spare, _coefficients[row], _isDone[row]) = (blocks, null, true);
    }

    /// <summary>Turns the coefficients into samples that are still to be, and lets go of them.</summary>
    public void Reconstruct()
    {
        for (int row = 0; row < _coefficients.Length; row++)
        {
            if (!_isDone[row])
            {
                ReconstructRow(row);
            }
        }

        _spare = null;
    }
}
