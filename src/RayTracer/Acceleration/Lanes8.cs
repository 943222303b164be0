using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>
/// What the kernels need of registers of eight lanes beyond operators, with the same results on every machine: eight is the width of
/// a tree's node, so these do not follow the width of <see cref="FloatW"/>.
/// </summary>
internal static unsafe class Lanes8
{
    /// <summary>Exactly a &lt; b ? a : b, so b where either is NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Min(Vector256<float> a, Vector256<float> b) =>
        Avx.IsSupported ? Avx.Min(a, b) : Vector256.ConditionalSelect(Vector256.LessThan(a, b), a, b);

    /// <summary>Exactly a &gt; b ? a : b, so b where either is NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Max(Vector256<float> a, Vector256<float> b) =>
        Avx.IsSupported ? Avx.Max(a, b) : Vector256.ConditionalSelect(Vector256.GreaterThan(a, b), a, b);

    /// <summary>Exactly a &lt; b ? a : b.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector128<float> Min(Vector128<float> a, Vector128<float> b) =>
        Sse.IsSupported ? Sse.Min(a, b) : Vector128.ConditionalSelect(Vector128.LessThan(a, b), a, b);

    /// <summary>Exactly a &gt; b ? a : b.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector128<float> Max(Vector128<float> a, Vector128<float> b) =>
        Sse.IsSupported ? Sse.Max(a, b) : Vector128.ConditionalSelect(Vector128.GreaterThan(a, b), a, b);

    /// <summary>a·b + c with one rounding.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> MultiplyAdd(Vector256<float> a, Vector256<float> b, Vector256<float> c) =>
        Vector256.FusedMultiplyAdd(a, b, c);

    /// <summary>c − a·b with one rounding.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> NegatedMultiplyAdd(Vector256<float> a, Vector256<float> b, Vector256<float> c) =>
        Fma.IsSupported ? Fma.MultiplyAddNegated(a, b, c) : Vector256.FusedMultiplyAdd(-a, b, c);

    /// <summary>One number in all lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Broadcast(float* number) => Vector256.Create(*number);

    /// <summary>Eight bytes as numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> FromBytes(byte* bytes) => Avx2.IsSupported
        ? Avx.ConvertToVector256Single(Avx2.ConvertToVector256Int32(bytes))
        : Vector256.Create((float)bytes[0], bytes[1], bytes[2], bytes[3], bytes[4], bytes[5], bytes[6], bytes[7]);

    /// <summary>The set of lanes in which a comparison holds, as bits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Vector256<float> mask) => mask.ExtractMostSignificantBits();

    /// <summary>Lane i of the result is lane indices[i].</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<int> Permute(Vector256<int> lanes, Vector256<int> indices) =>
        Avx2.IsSupported ? Avx2.PermuteVar8x32(lanes, indices) : Vector256.Shuffle(lanes, indices);

    /// <summary>Lane i of the result is lane indices[i].</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Permute(Vector256<float> lanes, Vector256<int> indices) =>
        Avx2.IsSupported ? Avx2.PermuteVar8x32(lanes, indices) : Vector256.Shuffle(lanes, indices);

    /// <summary>Shifts each lane to the right by its own count.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<int> ShiftRight(int bits, Vector256<int> counts)
    {
        if (Avx2.IsSupported)
        {
            return Avx2.ShiftRightLogicalVariable(Vector256.Create(bits), counts.AsUInt32());
        }

        return Vector256.Create(
            bits >>> counts[0], bits >>> counts[1], bits >>> counts[2], bits >>> counts[3],
            bits >>> counts[4], bits >>> counts[5], bits >>> counts[6], bits >>> counts[7]);
    }

    /// <summary>The smallest lane; no lane may be NaN.</summary>
    public static float Smallest(Vector256<float> a)
    {
        Vector128<float> four = Min(a.GetLower(), a.GetUpper());
        Vector128<float> two = Min(four, Vector128.Shuffle(four, Vector128.Create(2, 3, 0, 1)));
        return Min(two, Vector128.Shuffle(two, Vector128.Create(1, 0, 3, 2))).ToScalar();
    }

    /// <summary>The largest lane; no lane may be NaN.</summary>
    public static float Largest(Vector256<float> a) => -Smallest(-a);
}
