namespace RayTracer.Rendering;

/// <summary>A rectangle of pixels.</summary>
/// <param name="X">Left column.</param>
/// <param name="Y">Top row.</param>
/// <param name="Width">Number of columns.</param>
/// <param name="Height">Number of rows.</param>
public readonly record struct Tile(int X, int Y, int Width, int Height)
{
    /// <summary>Number of pixels.</summary>
    public int Pixels => Width * Height;

    /// <summary>Column and row in the picture of the tile's pixel of the given number (row by row).</summary>
    public (int X, int Y) Pixel(int number) => (X + (number % Width), Y + (number / Width));

    /// <summary>The smallest rectangle with some pixels.</summary>
    /// <param name="pixels">Their numbers in the picture, row by row; at least one.</param>
    /// <param name="width">The width of the picture.</param>
    internal static Tile Around(ReadOnlySpan<int> pixels, int width)
    {
        (int left, int top, int right, int bottom) = (int.MaxValue, int.MaxValue, 0, 0);
        foreach (int pixel in pixels)
        {
            (int y, int x) = int.DivRem(pixel, width);
            (left, top, right, bottom) = (Math.Min(left, x), Math.Min(top, y), Math.Max(right, x), Math.Max(bottom, y));
        }

        return new(left, top, right - left + 1, bottom - top + 1);
    }

    /// <summary>Cuts a rectangle into tiles of at most <paramref name="edge"/> pixels on a side, row by row.</summary>
    internal static Tile[] Cut(Tile area, int edge)
    {
        List<Tile> tiles = [];
        for (int y = 0; y < area.Height; y += edge)
        {
            for (int x = 0; x < area.Width; x += edge)
            {
                tiles.Add(new(area.X + x, area.Y + y, Math.Min(edge, area.Width - x), Math.Min(edge, area.Height - y)));
            }
        }

        return [.. tiles];
    }
}

/// <summary>A half-open range of sample numbers of every pixel.</summary>
/// <param name="First">The first sample.</param>
/// <param name="End">One after the last sample.</param>
public readonly record struct SampleRange(int First, int End)
{
    /// <summary>The number of samples.</summary>
    public int Count => End - First;
}
