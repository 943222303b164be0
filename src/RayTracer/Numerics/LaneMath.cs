using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

/// <summary>
/// The project's own transcendental functions. They are built from IEEE 754 operations alone, so their bits are the same
/// on every machine and at every register width. Each takes a lane of floats or one float, with the same bits. An error
/// bound counts units in the last place (ulp) of the correctly rounded result. Polynomials are minimax, found with
/// the Remez algorithm and then rounded to floats (Muller, Elementary Functions, 2016, chapter 3).
/// </summary>
public static partial class LaneMath
{
    // Adding 1.5·2²³ leaves no place for fraction bits: the sum rounds to the nearest integer, ties to even, and the low
    // bits of its representation are that integer in two's complement.
    private const float RoundingBias = 12582912f;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Fma(FloatW a, FloatW b, FloatW c) => FloatW.MultiplyAdd(a, b, c);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW FlipSign(FloatW a, UIntW signBit) => (a.AsUInt() ^ signBit).AsFloat();
}
