using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Filters a part of a picture that is small enough for what it compares to stay in the processor's cache. Each thread has its own.</summary>
internal sealed unsafe class DenoiserTile
{
    /// <summary>The largest width of a tile.</summary>
    public const int Width = 64;

    /// <summary>The largest height of a tile.</summary>
    public const int Height = 32;

    /// <summary>The distance up to which a pixel's likes are looked for, in pixels; farther ones are those of <see cref="CoarserScale"/>.</summary>
    public const int Window = 6;

    // Half the side of the patches that are compared.
    private const int Patch = 3;
    private const int Side = (2 * Patch) + 1;

    // Farther away, every other pixel will do.
    private const int DenseWindow = 3;

    // Strength: how many deviations apart two colours may be (Rousselle, Knaus & Zwicker 2012, k).
    private const float Tolerance = 0.45f;
    private const float Tiny = 1e-10f;

    // What a pixel needs of its surroundings.
    private const int Reach = Window + Patch;

    // Whole registers are written, the last of which may end beyond the tile.
    private const int Stride = Width + (2 * Reach) + 26;

    // The planes of a row lie beside each other, at distances that the compiler knows: of each half, light and variance; of each feature, three
    // coordinates, variance and scale; and what counts.
    private const int PlanesOfHalf = 4;
    private const int Features = 2 * PlanesOfHalf;
    private const int PlanesOfFeature = 5;
    private const int Counted = Features + (2 * PlanesOfFeature);
    private const int SumsSize = 2 * PlanesOfHalf * Stride * Height;
    private const int Row = (Counted + 1) * Stride;
    private readonly DenoiserInput _input;
    private readonly PaddedPlane[] _planes;
    private readonly float[] _memory;
    private readonly float* _tile;
    private readonly float* _sums;
    private readonly float* _across;
    private readonly float* _distance;
    private int _left;
    private int _top;
    private int _columns;
    private int _rows;

    /// <summary>Takes memory for tiles.</summary>
    /// <param name="input">The planes to compare.</param>
    public DenoiserTile(DenoiserInput input)
    {
        _input = input;
        _planes =
        [
            .. input.Light[0], input.Variances[0], .. input.Light[1], input.Variances[1],
            .. input.Features.SelectMany(f => f.Mean.Append(f.Variance).Append(f.Scale)), input.Sampled,
        ];
        int tile = Row * (Height + (2 * Reach));
        int across = 2 * Stride * (Height + (2 * Patch));
        _memory = GC.AllocateArray<float>(tile + SumsSize + across + Stride, pinned: true);
        fixed (float* first = _memory)
        {
            // Pinned for good.
            _tile = first;
            _sums = _tile + tile;
            _across = _sums + SumsSize;
            _distance = _across + across;
        }
    }

    /// <summary>Filters a tile.</summary>
    /// <param name="left">Its first column.</param>
    /// <param name="top">Its first row.</param>
    public void Filter(int left, int top)
    {
        (_left, _top) = (left, top);
        (_columns, _rows) = (Math.Min(Width, _input.Sampled.Width - left), Math.Min(Height, _input.Sampled.Height - top));
        CopyPlanes();
        new Span<float>(_sums, SumsSize).Clear();
        for (int dy = -Window; dy <= Window; dy++)
        {
            for (int dx = -Window; dx <= Window; dx++)
            {
                bool isNear = Math.Abs(dx) <= DenseWindow && Math.Abs(dy) <= DenseWindow;
                if (isNear || ((dx + dy) & 1) == 0)
                {
                    int offset = (dy * Row) + dx;
                    Compare(0, offset);
                    Compare(1, offset);
                    Gather(offset);
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
        float all = _input.Halves[0].Counts[column, row] + _input.Halves[1].Counts[column, row];
        float value = 0;
        for (int half = 0; half < 2; half++)
        {
            float count = _input.Halves[half].Counts[column, row];
            float* sums = _sums + (((2 * y) + half) * PlanesOfHalf * Stride) + x;
            float weight = sums[3 * Stride];
            float change = weight > 0 && _input.Variances[half][column, row] > 0
                ? (sums[channel * Stride] / weight) - _input.Light[half][channel][column, row] : 0;
            float own = _input.Halves[half].Color[channel][column, row];
            value += count > 0 ? count / all * float.FusedMultiplyAdd(_input.Surfaces[channel][column, row], change, own) : 0;
        }

        return value;
    }

    private void CopyPlanes()
    {
        int width = _columns + (2 * Reach);
        for (int row = 0; row < _rows + (2 * Reach); row++)
        {
            for (int i = 0; i < _planes.Length; i++)
            {
                new ReadOnlySpan<float>(_planes[i].At(_left - Reach, _top + row - Reach), width).CopyTo(new Span<float>(_tile + (row * Row) + (i * Stride), width));
            }
        }
    }

    // Differences between each pixel and the one that lies an offset from it, in units of what noise makes expected, and their sums along rows.
    private void Compare(int half, int offset)
    {
        int lanes = Vector<float>.Count;
        for (int row = 0; row < _rows + (2 * Patch); row++)
        {
            float* here = _tile + ((row + Window) * Row) + (half * PlanesOfHalf * Stride) + Window;
            float* there = here + offset;
            for (int i = 0; i < _columns + (2 * Patch); i += lanes)
            {
                FloatW variance = FloatW.Load(here + i + (3 * Stride));
                FloatW other = FloatW.Load(there + i + (3 * Stride));
                FloatW squares = Squares(here + i, there + i, variance, other);
                (squares / FloatW.MultiplyAdd(Tolerance * Tolerance, variance + other, Tiny)).Store(_distance + i);
            }

            float* across = _across + (((2 * row) + half) * Stride);
            for (int i = 0; i < _columns; i += lanes)
            {
                float* d = _distance + i;
                FloatW left = FloatW.Load(d) + FloatW.Load(d + 1) + FloatW.Load(d + 2);
                FloatW right = FloatW.Load(d + 4) + FloatW.Load(d + 5) + FloatW.Load(d + 6);
                (left + right + FloatW.Load(d + 3)).Store(across + i);
            }
        }
    }

    private void Gather(int offset)
    {
        for (int row = 0; row < _rows; row++)
        {
            float* here = _tile + ((row + Reach) * Row) + Reach;
            float* there = here + offset;
            float* across = _across + (2 * row * Stride);
            float* sums = _sums + (row * 2 * PlanesOfHalf * Stride);
            for (int i = 0; i < _columns; i += Vector<float>.Count)
            {
                FloatW normal = Distance(here + i + (Features * Stride), there + i + (Features * Stride));
                FloatW albedo = Distance(here + i + ((Features + PlanesOfFeature) * Stride), there + i + ((Features + PlanesOfFeature) * Stride));
                FloatW far = FloatW.Max(0f, FloatW.Max(normal, albedo));
                FloatW counted = FloatW.Load(there + i + (Counted * Stride));

                // Each half has the weights that the other one gives.
                Add(sums + i, there + i, Falling(FloatW.Max(far, PatchMean(across + i + Stride))) * counted);
                Add(sums + i + (PlanesOfHalf * Stride), there + i + (PlanesOfHalf * Stride), Falling(FloatW.Max(far, PatchMean(across + i))) * counted);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW PatchMean(float* across)
    {
        const int down = 2 * Stride;
        FloatW above = FloatW.Load(across) + FloatW.Load(across + down) + FloatW.Load(across + (2 * down));
        FloatW below = FloatW.Load(across + (4 * down)) + FloatW.Load(across + (5 * down)) + FloatW.Load(across + (6 * down));
        return (above + below + FloatW.Load(across + (3 * down))) * (1f / (Side * Side));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Add(float* sums, float* light, FloatW weight)
    {
        FloatW.MultiplyAdd(weight, FloatW.Load(light), FloatW.Load(sums)).Store(sums);
        FloatW.MultiplyAdd(weight, FloatW.Load(light + Stride), FloatW.Load(sums + Stride)).Store(sums + Stride);
        FloatW.MultiplyAdd(weight, FloatW.Load(light + (2 * Stride)), FloatW.Load(sums + (2 * Stride))).Store(sums + (2 * Stride));
        (weight + FloatW.Load(sums + (3 * Stride))).Store(sums + (3 * Stride));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Distance(float* here, float* there) =>
        Squares(here, there, FloatW.Load(here + (3 * Stride)), FloatW.Load(there + (3 * Stride))) * FloatW.Load(here + (4 * Stride));

    // The squared difference of three numbers, less what their variances make expected.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Squares(float* here, float* there, FloatW variance, FloatW other)
    {
        FloatW x = FloatW.Load(here) - FloatW.Load(there);
        FloatW y = FloatW.Load(here + Stride) - FloatW.Load(there + Stride);
        FloatW z = FloatW.Load(here + (2 * Stride)) - FloatW.Load(there + (2 * Stride));
        FloatW expected = variance + FloatW.Min(variance, other);
        return FloatW.MultiplyAdd(x, x, FloatW.MultiplyAdd(y, y, FloatW.MultiplyAdd(z, z, -expected)));
    }

    // About e to the power −far: (1 − far/16)¹⁶.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Falling(FloatW far)
    {
        FloatW root = FloatW.Max(0f, FloatW.NegatedMultiplyAdd(far, 1f / 16, 1f));
        root *= root;
        root *= root;
        root *= root;
        return root * root;
    }
}
