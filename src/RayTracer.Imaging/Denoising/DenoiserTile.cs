using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Filters a part of a picture that is small enough for what it compares to stay in the processor's cache. Each thread has its own.</summary>
/// <param name="input">The planes to compare.</param>
internal sealed unsafe class DenoiserTile(DenoiserInput input)
{
    /// <summary>The largest width of a tile.</summary>
    public const int Width = 64;

    /// <summary>The largest height of a tile.</summary>
    public const int Height = 32;

    /// <summary>The distance up to which a pixel's likes are looked for, in pixels.</summary>
    public const int Window = 8;

    // Half the side of the patches that are compared.
    private const int Patch = 3;
    private const int Side = (2 * Patch) + 1;

    // Farther away, every other pixel will do.
    private const int DenseWindow = 3;

    // Strength: how many deviations apart two colours may be (Rousselle, Knaus & Zwicker 2012, k).
    private const float Tolerance = 0.45f;
    private const float Tiny = 1e-10f;

    // Whole registers are written, the last of which may end beyond the tile.
    private const int Stride = Width + (2 * Patch) + 32;
    private const int Sums = 4;
    private readonly PaddedPlane _plane = input.Sampled;
    private readonly float[] _distance = GC.AllocateArray<float>(Stride, pinned: true);
    private readonly float[] _across = GC.AllocateArray<float>(2 * Stride * (Height + (2 * Patch)), pinned: true);
    private readonly float[] _sums = GC.AllocateArray<float>(2 * Sums * Stride * Height, pinned: true);
    private int _left;
    private int _top;
    private int _columns;
    private int _rows;

    /// <summary>Filters a tile.</summary>
    /// <param name="left">Its first column.</param>
    /// <param name="top">Its first row.</param>
    public void Filter(int left, int top)
    {
        (_left, _top) = (left, top);
        (_columns, _rows) = (Math.Min(Width, _plane.Width - left), Math.Min(Height, _plane.Height - top));
        Array.Clear(_sums);
        for (int dy = -Window; dy <= Window; dy++)
        {
            for (int dx = -Window; dx <= Window; dx++)
            {
                bool isNear = Math.Abs(dx) <= DenseWindow && Math.Abs(dy) <= DenseWindow;
                if (isNear || ((dx + dy) & 1) == 0)
                {
                    Compare(0, dx, dy);
                    Compare(1, dx, dy);
                    Gather(dx, dy);
                }
            }
        }
    }

    /// <summary>Writes the tile into the picture.</summary>
    public void Write(Picture result)
    {
        for (int y = 0; y < _rows; y++)
        {
            for (int x = 0; x < _columns; x++)
            {
                for (int channel = 0; channel < 3; channel++)
                {
                    result.Pixels[(3 * (((_top + y) * result.Width) + _left + x)) + channel] = Value(x, y, channel);
                }
            }
        }
    }

    // What has no noise keeps its bits.
    private float Value(int x, int y, int channel)
    {
        (int column, int row) = (_left + x, _top + y);
        float all = input.Halves[0].Counts[column, row] + input.Halves[1].Counts[column, row];
        float value = 0;
        for (int half = 0; half < 2; half++)
        {
            float count = input.Halves[half].Counts[column, row];
            int at = (Sums * half * Stride * Height) + (y * Stride) + x;
            float weight = _sums[at + (3 * Stride * Height)];
            float change = weight > 0 && input.Variances[half][column, row] > 0
                ? (_sums[at + (channel * Stride * Height)] / weight) - input.Light[half][channel][column, row] : 0;
            float own = input.Halves[half].Color[channel][column, row];
            value += count > 0 ? count / all * float.FusedMultiplyAdd(input.Albedo[channel][column, row], change, own) : 0;
        }

        return value;
    }

    // Differences between each pixel and the one that lies dx, dy from it, in units of what noise makes expected, and their sums along rows.
    private void Compare(int half, int dx, int dy)
    {
        PaddedPlane[] light = input.Light[half];
        int lanes = Vector<float>.Count;
        int offset = (dy * _plane.Stride) + dx;
        float* distance = Pointer(_distance);
        for (int row = 0; row < _rows + (2 * Patch); row++)
        {
            (int x, int y) = (_left - Patch, _top + row - Patch);
            float* red = light[0].At(x, y);
            float* green = light[1].At(x, y);
            float* blue = light[2].At(x, y);
            float* variance = input.Variances[half].At(x, y);
            for (int i = 0; i < _columns + (2 * Patch); i += lanes)
            {
                FloatW here = FloatW.Load(variance + i);
                FloatW there = FloatW.Load(variance + i + offset);
                FloatW d = FloatW.Load(red + i) - FloatW.Load(red + i + offset);
                FloatW squares = FloatW.MultiplyAdd(d, d, -(here + FloatW.Min(here, there)));
                d = FloatW.Load(green + i) - FloatW.Load(green + i + offset);
                squares = FloatW.MultiplyAdd(d, d, squares);
                d = FloatW.Load(blue + i) - FloatW.Load(blue + i + offset);
                squares = FloatW.MultiplyAdd(d, d, squares);
                (squares / FloatW.MultiplyAdd(Tolerance * Tolerance, here + there, Tiny)).Store(distance + i);
            }

            float* across = Pointer(_across) + (((half * (Height + (2 * Patch))) + row) * Stride);
            for (int i = 0; i < _columns; i += lanes)
            {
                FloatW sum = FloatW.Load(distance + i) + FloatW.Load(distance + i + 1);
                for (int j = 2; j < Side; j++)
                {
                    sum += FloatW.Load(distance + i + j);
                }

                sum.Store(across + i);
            }
        }
    }

    private void Gather(int dx, int dy)
    {
        int offset = (dy * _plane.Stride) + dx;
        for (int row = 0; row < _rows; row++)
        {
            int y = _top + row;
            float* counts = _plane.At(_left + dx, y + dy);
            for (int i = 0; i < _columns; i += Vector<float>.Count)
            {
                FloatW counted = FloatW.Load(counts + i);
                int at = (y * _plane.Stride) + _left + i;
                FloatW far = FloatW.Max(0f, FloatW.Max(Distance(input.Features[0], at, offset), Distance(input.Features[1], at, offset)));
                Add(0, row, i, at + offset, far, counted);
                Add(1, row, i, at + offset, far, counted);
            }
        }
    }

    // Adds one pixel to each half's sums, weighted with what the other half says.
    private void Add(int half, int row, int column, int there, FloatW far, FloatW counted)
    {
        float* across = Pointer(_across) + ((((1 - half) * (Height + (2 * Patch))) + row) * Stride) + column;
        FloatW patch = FloatW.Load(across) + FloatW.Load(across + Stride);
        for (int j = 2; j < Side; j++)
        {
            patch += FloatW.Load(across + (j * Stride));
        }

        FloatW weight = Falling(FloatW.Max(far, patch * (1f / (Side * Side)))) * counted;
        float* sums = Pointer(_sums) + (Sums * half * Stride * Height) + (row * Stride) + column;
        PaddedPlane[] light = input.Light[half];
        for (int channel = 0; channel < 3; channel++)
        {
            float* sum = sums + (channel * Stride * Height);
            FloatW.MultiplyAdd(weight, FloatW.Load(light[channel].At(0, 0) + there), FloatW.Load(sum)).Store(sum);
        }

        float* weights = sums + (3 * Stride * Height);
        (weight + FloatW.Load(weights)).Store(weights);
    }

    // About e to the power −far: (1 − far/16)¹⁶.
    private static FloatW Falling(FloatW far)
    {
        FloatW root = FloatW.Max(0f, FloatW.NegatedMultiplyAdd(far, 1f / 16, 1f));
        root *= root;
        root *= root;
        root *= root;
        return root * root;
    }

    private static FloatW Distance(DenoiserInput.GuideFeature feature, int at, int offset)
    {
        FloatW here = FloatW.Load(feature.Variance.At(0, 0) + at);
        FloatW squares = -(here + FloatW.Min(here, FloatW.Load(feature.Variance.At(0, 0) + at + offset)));
        foreach (PaddedPlane plane in feature.Mean)
        {
            FloatW d = FloatW.Load(plane.At(0, 0) + at) - FloatW.Load(plane.At(0, 0) + at + offset);
            squares = FloatW.MultiplyAdd(d, d, squares);
        }

        return squares * FloatW.Load(feature.Scale.At(0, 0) + at);
    }

    private static float* Pointer(float[] pinned) => (float*)Marshal.UnsafeAddrOfPinnedArrayElement(pinned, 0);
}
