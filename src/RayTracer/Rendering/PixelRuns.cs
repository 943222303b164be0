namespace RayTracer.Rendering;

/// <summary>The runs of neighbours in a row that pixels of a film come in.</summary>
internal static class PixelRuns
{
    /// <summary>Returns them in the order of the pixels.</summary>
    /// <param name="tile">The pixels, unless there are single ones.</param>
    /// <param name="pixels">The numbers of single pixels; nothing for those of the tile.</param>
    /// <param name="width">Width of the film.</param>
    public static IEnumerable<(int X, int Y, int Length)> Of(Tile tile, ReadOnlyMemory<int> pixels, int width)
    {
        for (int i = 0; i < pixels.Length; i++)
        {
            yield return (pixels.Span[i] % width, pixels.Span[i] / width, 1);
        }

        for (int row = 0; pixels.IsEmpty && row < tile.Height; row++)
        {
            yield return (tile.X, tile.Y + row, tile.Width);
        }
    }
}
