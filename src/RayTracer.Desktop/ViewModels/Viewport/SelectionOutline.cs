using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The outline of a thing in the picture, from the pixels that show it.</summary>
internal static class SelectionOutline
{
    private static readonly byte[] Color = [0xff, 0xa5, 0x1f, 0xff];

    /// <summary>Draws it: the pixels that lie outside of the thing, and beside it.</summary>
    public static PixelFrame Of(PixelMask mask)
    {
        (int width, int height) = (mask.Width, mask.Height);
        bool[] inside = new bool[width * height];
        for (int i = 0; i + 1 < mask.Runs.Count; i += 2)
        {
            Array.Fill(inside, true, mask.Runs[i], mask.Runs[i + 1]);
        }

        byte[] rgba = new byte[4 * inside.Length];
        for (int i = 0; i < inside.Length; i++)
        {
            if (!inside[i] && IsBeside(inside, width, height, i))
            {
                Color.CopyTo(rgba, 4 * i);
            }
        }

        return new(width, height, rgba);
    }

    private static bool IsBeside(bool[] inside, int width, int height, int i)
    {
        (int x, int y) = (i % width, i / width);
        return (x > 0 && inside[i - 1]) || (x + 1 < width && inside[i + 1]) || (y > 0 && inside[i - width]) || (y + 1 < height && inside[i + width]);
    }
}

/// <summary>Pixels for the screen: four bytes each, red, green, blue and how opaque it is, row by row from the top.</summary>
/// <param name="Width">Pixels across.</param>
/// <param name="Height">Pixels down.</param>
/// <param name="Rgba">The bytes. The caller copies them at once: the buffer is used again.</param>
internal sealed record PixelFrame(int Width, int Height, byte[] Rgba);
