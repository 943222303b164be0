using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Imaging;

/// <summary>One number a pixel, with a margin around the picture in which its edges go on, so that windows need not end there.</summary>
/// <param name="width">Width of the picture in pixels.</param>
/// <param name="height">Height of the picture in pixels.</param>
internal sealed class PaddedPlane(int width, int height)
{
    /// <summary>Pixels of margin on each side.</summary>
    public const int Margin = 12;

    // Whole registers are read, the last of which may end beyond the margin.
    private const int WidestRegister = 16;
    private readonly float[] _values = new float[checked((width + (2 * Margin) + WidestRegister) * (height + (2 * Margin)))];

    /// <summary>Width of the picture.</summary>
    public int Width => width;

    /// <summary>Height of the picture.</summary>
    public int Height => height;

    private int Stride => width + (2 * Margin) + WidestRegister;

    /// <summary>A number; set only within the picture.</summary>
    public float this[int x, int y]
    {
        get => _values[Index(x, y)];
        set => _values[Index(x, y)] = value;
    }

    /// <summary>The numbers of as many pixels as there are lanes.</summary>
    public FloatW Load(int x, int y) => new(new Vector<float>(_values, Index(x, y)));

    /// <summary>Lets the edges go on in the margin.</summary>
    public void Extend()
    {
        for (int y = 0; y < height; y++)
        {
            Span<float> row = _values.AsSpan(Index(-Margin, y), Stride);
            row[..Margin].Fill(row[Margin]);
            row[(Margin + width)..].Fill(row[Margin + width - 1]);
        }

        for (int i = 1; i <= Margin; i++)
        {
            _values.AsSpan(Index(-Margin, 0), Stride).CopyTo(_values.AsSpan(Index(-Margin, -i)));
            _values.AsSpan(Index(-Margin, height - 1), Stride).CopyTo(_values.AsSpan(Index(-Margin, height - 1 + i)));
        }
    }

    /// <summary>Means over the squares around each pixel; the edges of both planes go on.</summary>
    /// <param name="radius">Pixels on each side of the middle, at most the margin.</param>
    public PaddedPlane Blurred(int radius)
    {
        PaddedPlane across = new(width, height);
        PaddedPlane all = new(width, height);
        float scale = 1f / ((2 * radius) + 1);
        ForEach((x, y) => across[x, y] = scale * Sum(radius, i => this[x + i, y]));
        across.Extend();
        ForEach((x, y) => all[x, y] = scale * Sum(radius, i => across[x, y + i]));
        all.Extend();
        return all;
    }

    /// <summary>Visits all pixels, rows in any order.</summary>
    public void ForEach(Action<int, int> visit) => Parallel.For(0, height, y =>
    {
        for (int x = 0; x < width; x++)
        {
            visit(x, y);
        }
    });

    private static float Sum(int radius, Func<int, float> value)
    {
        float sum = 0;
        for (int i = -radius; i <= radius; i++)
        {
            sum += value(i);
        }

        return sum;
    }

    private int Index(int x, int y) => ((y + Margin) * Stride) + x + Margin;
}
