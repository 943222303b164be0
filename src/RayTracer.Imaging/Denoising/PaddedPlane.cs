using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Imaging;

/// <summary>
/// One number a pixel, with a margin around the picture in which its edges go on, so that windows need not end there. Planes of one size
/// have the same <see cref="Stride"/>, so that one index serves several of them.
/// </summary>
internal sealed unsafe class PaddedPlane
{
    /// <summary>Pixels of margin on each side.</summary>
    public const int Margin = 12;

    // Whole registers are read, the last of which may end beyond the margin.
    private const int WidestRegister = 16;
    private readonly float[] _values;
    private readonly float* _origin;

    /// <summary>Makes a plane of zeros.</summary>
    /// <param name="width">Width of the picture in pixels.</param>
    /// <param name="height">Height of the picture in pixels.</param>
    public PaddedPlane(int width, int height)
    {
        (Width, Height, Stride) = (width, height, width + (2 * Margin) + WidestRegister);
        _values = GC.AllocateArray<float>(checked(Stride * (height + (2 * Margin))), pinned: true);
        fixed (float* first = _values)
        {
            // Pinned for good.
            _origin = first + (Margin * Stride) + Margin;
        }
    }

    /// <summary>Width of the picture.</summary>
    public int Width { get; }

    /// <summary>Height of the picture.</summary>
    public int Height { get; }

    /// <summary>The distance between a pixel and the one below it, in numbers.</summary>
    public int Stride { get; }

    /// <summary>A number; set only within the picture.</summary>
    public float this[int x, int y]
    {
        get => _origin[(y * Stride) + x];
        set => _origin[(y * Stride) + x] = value;
    }

    /// <summary>The numbers from a pixel on. They stay where they are as long as the plane is in use.</summary>
    public float* At(int x, int y) => _origin + (y * Stride) + x;

    /// <summary>The numbers of as many pixels as there are lanes.</summary>
    public FloatW Load(int x, int y) => FloatW.Load(At(x, y));

    /// <summary>Makes a plane of the same size of what is computed for as many pixels as there are lanes, at their first one.</summary>
    public PaddedPlane With(Func<int, int, FloatW> value)
    {
        PaddedPlane plane = new(Width, Height);
        plane.Fill(value);
        return plane;
    }

    /// <summary>Sets all numbers, as <see cref="With"/> does.</summary>
    public void Fill(Func<int, int, FloatW> value)
    {
        Parallel.For(0, Height, y =>
        {
            for (int x = 0; x < Width; x += FloatW.Count)
            {
                value(x, y).Store(At(x, y));
            }
        });
        Extend();
    }

    /// <summary>Lets the edges go on in the margin.</summary>
    public void Extend()
    {
        for (int y = 0; y < Height; y++)
        {
            Span<float> row = Row(y);
            row[..Margin].Fill(row[Margin]);
            row[(Margin + Width)..].Fill(row[Margin + Width - 1]);
        }

        for (int i = 1; i <= Margin; i++)
        {
            Row(0).CopyTo(Row(-i));
            Row(Height - 1).CopyTo(Row(Height - 1 + i));
        }
    }

    /// <summary>Means over the squares around each pixel; the edges of both planes go on.</summary>
    /// <param name="radius">Pixels on each side of the middle, at most the margin.</param>
    public PaddedPlane Blurred(int radius)
    {
        int side = (2 * radius) + 1;
        PaddedPlane across = With((x, y) => Sum(At(x - radius, y), 1, side) * (1f / side));
        return With((x, y) => Sum(across.At(x, y - radius), Stride, side) * (1f / side));
    }

    /// <summary>A plane of half the size: means over squares of four pixels.</summary>
    /// <param name="weights">The weight of each of them.</param>
    /// <param name="least">The least that the weights of four are taken to be together: less makes the mean smaller.</param>
    public PaddedPlane Halved(PaddedPlane weights, float least)
    {
        PaddedPlane half = new((Width + 1) / 2, (Height + 1) / 2);
        for (int y = 0; y < half.Height; y++)
        {
            for (int x = 0; x < half.Width; x++)
            {
                float sum = 0;
                float weight = 0;
                for (int i = 0; i < 4; i++)
                {
                    (int column, int row) = ((2 * x) + (i & 1), (2 * y) + (i >> 1));
                    sum = float.FusedMultiplyAdd(weights[column, row], this[column, row], sum);
                    weight += weights[column, row];
                }

                half[x, y] = sum / float.Max(weight, least);
            }
        }

        half.Extend();
        return half;
    }

    /// <summary>The largest numbers of the squares around each pixel.</summary>
    /// <inheritdoc cref="Blurred"/>
    public PaddedPlane Largest(int radius)
    {
        int side = (2 * radius) + 1;
        PaddedPlane across = With((x, y) => Most(At(x - radius, y), 1, side));
        return With((x, y) => Most(across.At(x, y - radius), Stride, side));
    }

    /// <summary>Makes no number larger than that of another plane.</summary>
    public void Limit(PaddedPlane largest) => Fill((x, y) => FloatW.Min(Load(x, y), largest.Load(x, y)));

    /// <summary>The sum of the picture's numbers.</summary>
    public double Total()
    {
        double sum = 0;
        for (int y = 0; y < Height; y++)
        {
            foreach (float value in new ReadOnlySpan<float>(At(0, y), Width))
            {
                sum += value;
            }
        }

        return sum;
    }

    private static FloatW Sum(float* first, int step, int count)
    {
        FloatW sum = 0f;
        for (int i = 0; i < count; i++)
        {
            sum += FloatW.Load(first + (i * step));
        }

        return sum;
    }

    private static FloatW Most(float* first, int step, int count)
    {
        FloatW most = FloatW.Load(first);
        for (int i = 1; i < count; i++)
        {
            most = FloatW.Max(most, FloatW.Load(first + (i * step)));
        }

        return most;
    }

    private Span<float> Row(int y) => new(At(-Margin, y), Stride);
}
