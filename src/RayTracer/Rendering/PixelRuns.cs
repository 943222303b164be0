namespace RayTracer.Rendering;

/// <summary>The runs of neighbours in a row that pixels of a film come in.</summary>
internal static class PixelRuns
{
    /// <summary>Returns column, row and length of the run that begins with a pixel.</summary>
    /// <param name="pixel">The pixel's number among those of the tile or the single ones; of a tile, the first of a row.</param>
    /// <param name="tile">The pixels, unless there are single ones.</param>
    /// <param name="pixels">The numbers of single pixels; nothing for those of the tile.</param>
    /// <param name="width">Width of the film.</param>
    public static (int X, int Y, int Length) At(int pixel, in Tile tile, ReadOnlySpan<int> pixels, int width) => pixels.IsEmpty
        ? (tile.X, tile.Y + (pixel / tile.Width), tile.Width)
        : (pixels[pixel] % width, pixels[pixel] / width, 1);
}
