using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Materials;

/// <summary>The probability of one of two lobes.</summary>
internal static class LobeChoice
{
    /// <summary>The probability of the first lobe, in proportion to what the two send on; a half where that is nothing.</summary>
    /// <param name="first">The share that the first lobe sends on, roughly.</param>
    /// <param name="second">The share that the second lobe sends on, roughly.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Probability(RgbW first, RgbW second)
    {
        FloatW a = first.R + first.G + first.B;
        FloatW sum = a + (second.R + second.G + second.B);
        return (sum > 0f).Select(a / sum, 0.5f);
    }
}
