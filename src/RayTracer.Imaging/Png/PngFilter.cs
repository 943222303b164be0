namespace RayTracer.Imaging;

/// <summary>The five row filters of PNG (W3C PNG specification, section 9).</summary>
internal static class PngFilter
{
    public const int Count = 5;

    /// <summary>Filters a row for writing.</summary>
    /// <param name="type">0 none, 1 left, 2 above, 3 average, 4 Paeth.</param>
    /// <param name="row">The row's bytes.</param>
    /// <param name="above">The bytes of the row above, zero for the first.</param>
    /// <param name="pixelBytes">Bytes from one pixel to the next, at least 1.</param>
    /// <param name="filtered">Gets the result.</param>
    /// <returns>The sum of absolute (signed) results: the smaller, the better it will compress.</returns>
    public static long Apply(int type, ReadOnlySpan<byte> row, ReadOnlySpan<byte> above, int pixelBytes, Span<byte> filtered)
    {
        long sum = 0;
        above = above[..row.Length];
        filtered = filtered[..row.Length];
        for (int i = 0; i < row.Length; i++)
        {
            int left = i < pixelBytes ? 0 : row[i - pixelBytes];
            int aboveLeft = i < pixelBytes ? 0 : above[i - pixelBytes];
            byte difference = (byte)(row[i] - Predict(type, left, above[i], aboveLeft));
            filtered[i] = difference;
            sum += Math.Abs((int)(sbyte)difference);
        }

        return sum;
    }

    /// <summary>Undoes the filter in place.</summary>
    public static void Undo(int type, Span<byte> row, ReadOnlySpan<byte> above, int pixelBytes)
    {
        if (type == 0)
        {
            return;
        }

        above = above[..row.Length];
        for (int i = 0; i < row.Length; i++)
        {
            int left = i < pixelBytes ? 0 : row[i - pixelBytes];
            int aboveLeft = i < pixelBytes ? 0 : above[i - pixelBytes];
            row[i] = (byte)(row[i] + Predict(type, left, above[i], aboveLeft));
        }
    }

    private static int Predict(int type, int left, int above, int aboveLeft) => type switch
    {
        1 => left,
        2 => above,
        3 => (left + above) >> 1,
        4 => Paeth(left, above, aboveLeft),
        _ => 0,
    };

    private static int Paeth(int left, int above, int aboveLeft)
    {
        int toLeft = Math.Abs(above - aboveLeft);
        int toAbove = Math.Abs(left - aboveLeft);
        int toAboveLeft = Math.Abs(left + above - (2 * aboveLeft));
        if (toLeft <= toAbove && toLeft <= toAboveLeft)
        {
            return left;
        }

        return toAbove <= toAboveLeft ? above : aboveLeft;
    }
}
