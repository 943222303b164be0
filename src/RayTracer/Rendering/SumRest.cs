namespace RayTracer.Rendering;

/// <summary>
/// The rest of a pixel's sums of up to 64 samples that four 64-bit numbers do not hold, in a fifth: the squares of bright samples from 2⁵⁶
/// units on, of which there are fewer than 2⁴⁷, and how many samples were left out.
/// </summary>
internal static class SumRest
{
    /// <summary>The lowest bit of squares that is in the rest.</summary>
    public const int SquareShift = 56;

    private const int MissingBits = 7;

    /// <summary>Returns the rest of a sample.</summary>
    public static long Of(long highSquare, int missing) => (highSquare << MissingBits) + missing;

    /// <summary>Returns the upper bits of the squares.</summary>
    public static long HighSquare(long rest) => rest >> MissingBits;

    /// <summary>Returns the number of samples that were left out.</summary>
    public static int Missing(long rest) => (int)rest & ((1 << MissingBits) - 1);
}
