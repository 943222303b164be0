using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

public static partial class LaneMath
{
    // π/2 as a sum of three floats (Cody and Waite, Software Manual for the Elementary Functions, 1980).
    private const float HalfPiHigh = 1.57079637f;
    private const float HalfPiMiddle = -4.37113883e-8f;
    private const float HalfPiLow = -1.71512451e-15f;

    private const float TwoOverPi = 0.636619772f;

    // Up to here x − k·HalfPiHigh is exact and the three parts of π/2 are enough.
    private const float LargestByThreeParts = 131072f;

    // Sixty-four zeros, then the binary digits of 2/π.
    private static ReadOnlySpan<ulong> TwoOverPiDigits =>
        [0, 0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561];

    /// <summary>
    /// Sine and cosine of an angle in radians, for every finite float, within 1.6 ulp; NaN for NaN and the infinities.
    /// Angles beyond 131072 in magnitude are right too, but slow.
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void SinCos(in FloatW x, out FloatW sin, out FloatW cos)
    {
        FloatW angle = FloatW.Abs(x);
        FloatW biased = Fma(angle, TwoOverPi, RoundingBias);
        FloatW k = biased - RoundingBias;
        UIntW quadrant = biased.AsUInt();
        FloatW r = FloatW.NegatedMultiplyAdd(k, HalfPiHigh, angle);
        r = FloatW.NegatedMultiplyAdd(k, HalfPiMiddle, r);
        r = FloatW.NegatedMultiplyAdd(k, HalfPiLow, r);
        MaskW large = angle > LargestByThreeParts;
        if (large.Any)
        {
            // Copies: a variable whose address is taken would live in memory on the fast path too.
            (FloatW original, MaskW affected) = (angle, large);
            FloatW reduced = r;
            UIntW ofReduced = quadrant;
            ReduceLarge(original, affected, ref reduced, ref ofReduced);
            r = reduced;
            quadrant = ofReduced;
        }

        FloatW z = r * r;
        FloatW s = Fma(z, Fma(z, -1.95078843e-4f, 8.33210628e-3f), -1.66666538e-1f);
        s = Fma(r * z, s, r);
        FloatW c = Fma(z, Fma(z, 2.44300845e-5f, -1.38872978e-3f), 4.16666456e-2f);
        c = Fma(z, Fma(z, c, -0.5f), 1f);

        MaskW even = UIntW.Equal(quadrant & 1, 0);
        UIntW signOfX = x.AsUInt() & 0x80000000;
        sin = FlipSign(even.Select(s, c), signOfX ^ ((quadrant & 2) << 30));
        cos = FlipSign(even.Select(c, s), ((quadrant + 1) & 2) << 30);
    }

    /// <inheritdoc cref="SinCos(in FloatW, out FloatW, out FloatW)"/>
    public static void SinCos(float x, out float sin, out float cos)
    {
        SinCos((FloatW)x, out FloatW s, out FloatW c);
        sin = s[0];
        cos = c[0];
    }

    /// <summary>
    /// Sine and cosine of 2π·<paramref name="u"/>, absolute error below 1.4e-7, exact at the multiples of a quarter and
    /// never beyond ±1. <paramref name="u"/> is meant to lie in [0, 1]; the bound holds for all |u| ≤ 10⁶.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void SinCosTurn(FloatW u, out FloatW sin, out FloatW cos)
    {
        // 2u = k + r with |r| ≤ 1/2, exactly. Then sin 2πu = ± sin πr, cos 2πu = ± cos πr, and the factors r and
        // 1/4 − r² carry the zeros of the two.
        FloatW biased = Fma(u, 2f, RoundingBias);
        FloatW r = Fma(u, 2f, RoundingBias - biased);
        FloatW z = r * r;
        FloatW s = Fma(z, Fma(z, 7.64966682e-2f, -5.97645223e-1f), 2.54995918f);
        s = Fma(z, Fma(z, s, -5.1677022f), 3.1415925f);
        FloatW c = Fma(z, Fma(z, 2.44386978e-2f, -2.28859574e-1f), 1.2780056f);
        c = Fma(z, Fma(z, c, -3.7392087f), 4f);

        UIntW sign = biased.AsUInt() << 31;
        sin = FlipSign(r, sign) * s;
        cos = FlipSign(FloatW.NegatedMultiplyAdd(r, r, 0.25f), sign) * c;
    }

    /// <inheritdoc cref="SinCosTurn(FloatW, out FloatW, out FloatW)"/>
    public static void SinCosTurn(float u, out float sin, out float cos)
    {
        SinCosTurn((FloatW)u, out FloatW s, out FloatW c);
        sin = s[0];
        cos = c[0];
    }

    /// <summary>
    /// The tangent of an angle in radians, for every finite float, within 3.3 ulp; NaN for NaN and the infinities.
    /// </summary>
    public static float Tan(float x)
    {
        SinCos(x, out float sin, out float cos);
        return sin / cos;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static unsafe void ReduceLarge(in FloatW angle, in MaskW large, ref FloatW r, ref UIntW quadrant)
    {
        float* rs = stackalloc float[FloatW.Count];
        uint* quadrants = stackalloc uint[FloatW.Count];
        r.Store(rs);
        quadrant.Store(quadrants);
        uint bits = large.Bits;
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            if ((bits >> lane & 1) != 0)
            {
                rs[lane] = ReduceLarge(angle[lane], out quadrants[lane]);
            }
        }

        r = FloatW.Load(rs);
        quadrant = UIntW.Load(quadrants);
    }

    // angle − quadrant·π/2 for an angle of at least 2¹⁷. Digits of 2/π whose product with the angle is a multiple of four
    // quadrants are left out (Payne and Hanek, Radian reduction for trigonometric functions, 1983).
    private static float ReduceLarge(float angle, out uint quadrant)
    {
        uint bits = BitConverter.SingleToUInt32Bits(angle);
        if (bits >= 0x7f800000)
        {
            quadrant = 0;
            return float.NaN;
        }

        uint significand = (bits & 0x7fffff) | 0x800000;
        int exponent = (int)(bits >> 23) - 150;

        // The window has two digits before the binary point, so that the product wraps around modulo 4.
        int first = 62 + exponent;
        int word = first >> 6;
        int shift = first & 63;
        ReadOnlySpan<ulong> digits = TwoOverPiDigits;
        UInt128 window = new UInt128(digits[word], digits[word + 1]) << shift | digits[word + 2] >> 1 >> (63 - shift);
        ulong quadrants = (ulong)(significand * window >> 64);

        quadrant = (uint)((quadrants + (1ul << 61)) >> 62);
        long rest = (long)(quadrants - ((ulong)quadrant << 62));
        return (float)(rest * (1.5707963267948966 / (1ul << 62)));
    }
}
