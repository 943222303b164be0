namespace RayTracer.Rendering;

/// <summary>Where the pixels of a picture lie in a plane of numbers with room around it, so that what looks at neighbours need not ask whether there are any.</summary>
/// <param name="Width">Width in pixels.</param>
/// <param name="Height">Height in pixels.</param>
internal readonly record struct PaddedRows(int Width, int Height)
{
    /// <summary>Columns beside each row; a register's worth at least.</summary>
    public const int Margin = 16;

    /// <summary>From a row to the next.</summary>
    public int Stride => Width + (2 * Margin);

    /// <summary>The numbers of a plane, with a row above and one below the picture.</summary>
    public int Size => checked(Stride * (Height + 2));

    /// <summary>The place of a pixel.</summary>
    public int At(int x, int y) => ((y + 1) * Stride) + Margin + x;

    /// <summary>The place of a pixel.</summary>
    /// <param name="number">Its number in the picture, row by row.</param>
    public int At(uint number) => At((int)(number % (uint)Width), (int)(number / (uint)Width));
}
