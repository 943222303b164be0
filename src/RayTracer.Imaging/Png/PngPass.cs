namespace RayTracer.Imaging;

/// <summary>
/// A part of the pixels, on a regular grid, that is stored as a separate image: all of them, or one of Adam7's seven passes.
/// </summary>
internal readonly record struct PngPass(int X, int Y, int StepX, int StepY, int Width, int Height)
{
    /// <summary>The passes of a file that have pixels, in their order (W3C PNG specification, section 8).</summary>
    public static IEnumerable<PngPass> Of(PngHeader header)
    {
        PngPass[] all = header.Interlaced
            ? [Make(header, 0, 0, 8, 8), Make(header, 4, 0, 8, 8), Make(header, 0, 4, 4, 8), Make(header, 2, 0, 4, 4),
               Make(header, 0, 2, 2, 4), Make(header, 1, 0, 2, 2), Make(header, 0, 1, 1, 2)]
            : [Make(header, 0, 0, 1, 1)];
        return all.Where(pass => pass.Width > 0 && pass.Height > 0);
    }

    private static PngPass Make(PngHeader header, int x, int y, int stepX, int stepY) =>
        new(x, y, stepX, stepY, (header.Width - x + stepX - 1) / stepX, (header.Height - y + stepY - 1) / stepY);
}
