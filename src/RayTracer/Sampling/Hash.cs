using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// The counter-based random numbers that all samplers are made of: a hash of (seed, pixel, sample, dimension) without
/// state, so that any sample of any pixel can be had in any order on any machine.
/// </summary>
public static class Hash
{
    /// <summary>2³² over the golden ratio: consecutive multiples are far from one another.</summary>
    public const uint Golden = 0x9E3779B9;

    /// <summary>
    /// A bijection of the 32-bit integers in which every bit of the result depends on every bit of the argument: two rounds of
    /// multiply and xor-shift with the constants that Wellons found by search (hash-prospector, 2018, "lowbias32").
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW Mix(UIntW x)
    {
        x = (x ^ (x >> 16)) * 0x7feb352du;
        x = (x ^ (x >> 15)) * 0x846ca68bu;
        return x ^ (x >> 16);
    }

    /// <summary>As <see cref="Mix(UIntW)"/>, for one number.</summary>
    public static uint Mix(uint x)
    {
        x = (x ^ (x >> 16)) * 0x7feb352du;
        x = (x ^ (x >> 15)) * 0x846ca68bu;
        return x ^ (x >> 16);
    }

    /// <summary>The key of a pixel, from which all its random numbers come. Different pixels of one seed have different keys.</summary>
    /// <param name="seed">The picture's seed.</param>
    /// <param name="pixel">y · width + x.</param>
    public static uint PixelKey(uint seed, uint pixel) => Mix(Mix(pixel ^ Mix(seed)) + (seed * 0x85EBCA6Bu));

    /// <summary>As <see cref="PixelKey(uint, uint)"/>, for many pixels.</summary>
    internal static UIntW PixelKey(uint seed, UIntW pixel) => Mix(Mix(pixel ^ Mix(seed)) + (seed * 0x85EBCA6Bu));

    /// <summary>The key of one group of dimensions of a pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW GroupKey(UIntW pixelKey, UIntW group) => Mix(pixelKey + (group * Golden));

    /// <summary>The keys of the two coordinates of a pair.</summary>
    /// <param name="groupKey">Key of the group.</param>
    /// <param name="pair">Number of the pair in the group.</param>
    /// <param name="first">Key of the first coordinate.</param>
    /// <param name="second">Key of the second coordinate.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void PairKeys(UIntW groupKey, uint pair, out UIntW first, out UIntW second)
    {
        first = Mix(groupKey + (pair * Golden));

        // The halves change places, so that the lowest digits, which scrambling uses first, come from different bits.
        second = ((first >> 16) | (first << 16)) * 0x2c1b3c6du;
    }
}
