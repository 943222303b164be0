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
    }

    /// <summary>A row of blocks, 64 coefficients each; it takes memory only from its first use on, so that a mere claim of size costs nothing.</summary>
    public short[] BlockRow(int row) => _coefficients[row] ??= new short[Stride * Side];

    /// <summary>Remembers the quantization that holds at its first scan; tables may be defined anew after it (T.81, section B.2.4.1).</summary>
    /// <exception cref="PictureException">There is no such table.</exception>
    public void LatchQuantization(float[]?[] tables) => _steps ??= tables[quantization]
        ?? throw new PictureException($"its quantization table {quantization} is missing");

    /// <summary>Turns the coefficients into samples and lets go of them.</summary>
    public void Reconstruct()
    {
        Samples = new byte[_coefficients.Length * Side * Stride];
        float[] steps = _steps!;
        for (int row = 0; row < _coefficients.Length; row++)
        {
            short[] blocks = BlockRow(row);
            for (int block = 0; block < Stride / Side; block++)
            {
                Span<byte> samples = Samples.AsSpan((row * Side * Stride) + (block * Side));
                JpegTransform.Inverse(blocks.AsSpan(block * BlockSize, BlockSize), steps, samples, Stride);
            }

            _coefficients[row] = null;
        }
    }
}
