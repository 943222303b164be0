using System.Numerics;
using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

public static partial class LaneMath
{
    private const float Ln2High = 0.693147182f;
    private const float Ln2Low = -1.90465421e-9f;

    /// <summary>
    /// e to the power <paramref name="x"/>, within 1.1 ulp, subnormal results included; too small a result is 0, too large
    /// a one +∞; NaN gives NaN.
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static FloatW Exp(in FloatW x)
    {
        // The order of the operands lets NaN through. Beyond the limits the result is 0 or infinite anyway.
        FloatW limited = FloatW.Min(89f, FloatW.Max(-104f, x));
        FloatW biased = Fma(limited, 1.44269502f, RoundingBias);
        FloatW n = biased - RoundingBias;
        FloatW r = FloatW.NegatedMultiplyAdd(n, Ln2Low, FloatW.NegatedMultiplyAdd(n, Ln2High, limited));
        FloatW p = Fma(r, Fma(r, 1.38470693e-3f, 8.36999062e-3f), 4.1668009e-2f);
        p = Fma(r, Fma(r, p, 1.66665092e-1f), 0.49999994f);
        p = Fma(r * r, p, r) + 1f;

        // 2ⁿ as two factors: n itself may lie beyond the exponents of normal numbers.
        UIntW exponents = biased.AsUInt() - BitConverter.SingleToUInt32Bits(RoundingBias) + (2 * 127);
        UIntW half = exponents >> 1;
        return p * (half << 23).AsFloat() * ((exponents - half) << 23).AsFloat();
    }

    /// <inheritdoc cref="Exp(in FloatW)"/>
    public static float Exp(float x) => Exp((FloatW)x)[0];

    /// <summary>
    /// The natural logarithm, within 1 ulp, for all positive floats, subnormal ones included; −∞ for zero, NaN below
    /// zero and for NaN.
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static FloatW Log(in FloatW x)
    {
        // x = 2ⁿ·m with m in [2/3, 4/3).
        const uint TwoThirds = 0x3f2aaaab;
        MaskW subnormal = x < 1.17549435e-38f;
        UIntW bits = subnormal.Select(x * 8388608f, x).AsUInt() + (0x3f800000 - TwoThirds);
        FloatW n = (bits >> 23).ToFloat() - subnormal.Select(127f + 23f, 127f);
        FloatW f = ((bits & 0x7fffff) + TwoThirds).AsFloat() - 1f;

        FloatW p = Fma(f, Fma(f, -1.24897741e-1f, 1.40602574e-1f), -1.22733831e-1f);
        p = Fma(f, Fma(f, Fma(f, p, 1.39896929e-1f), -1.66744471e-1f), 2.0011434e-1f);
        p = Fma(f, Fma(f, Fma(f, p, -2.49999195e-1f), 3.33331972e-1f), -0.5f);
        FloatW log = Fma(n, Ln2High, Fma(f * f, p, f));

        log = (x < float.PositiveInfinity).Select(log, x);
        return (x <= 0f).Select((x < 0f).Select(float.NaN, float.NegativeInfinity), log);
    }

    /// <inheritdoc cref="Log(in FloatW)"/>
    public static float Log(float x) => Log((FloatW)x)[0];

    /// <summary>
    /// <paramref name="x"/> to the power <paramref name="y"/> for x ≥ 0, within 0.75 ulp, subnormal results included. As
    /// in ISO C (2018, F.10.4.4), x⁰ and 1ʸ are 1 even for NaN, and zero and the infinities are limits; −0 counts as 0.
    /// Otherwise NaN below zero and for NaN.
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static FloatW Pow(in FloatW x, in FloatW y)
    {
        Vector<double> low = Pow(Vector.WidenLower(x.V), Vector.WidenLower(y.V));
        Vector<double> high = Pow(Vector.WidenUpper(x.V), Vector.WidenUpper(y.V));
        FloatW pow = new(Vector.Narrow(low, high));

        MaskW limit = x <= 0f | x >= float.PositiveInfinity;
        pow = limit.Select((x < 1f & y < 0f | x > 1f & y > 0f).Select(float.PositiveInfinity, 0f), pow);
        pow = (x >= 0f & FloatW.Abs(y) <= float.PositiveInfinity).Select(pow, float.NaN);
        MaskW one = UIntW.Equal(x.AsUInt(), 0x3f800000) | UIntW.Equal(y.AsUInt() << 1, 0);
        return one.Select(1f, pow);
    }

    /// <inheritdoc cref="Pow(in FloatW, in FloatW)"/>
    public static float Pow(float x, float y) => Pow((FloatW)x, (FloatW)y)[0];

    // 2 to the power y·log₂x in double precision, for positive finite x and any result that a float can hold.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<double> Pow(Vector<double> x, Vector<double> y)
    {
        // x = 2ⁿ·m with m in [2/3, 4/3). Bits of n in the last places of 2⁵² become a double by a subtraction.
        const ulong TwoThirds = 0x3fe5555555555555;
        Vector<ulong> bits = Vector.AsVectorUInt64(x) + new Vector<ulong>(0x3ff0000000000000 - TwoThirds);
        Vector<ulong> biased = bits >> 52 | new Vector<ulong>(0x4330000000000000);
        Vector<double> n = Vector.AsVectorDouble(biased) - new Vector<double>((1L << 52) + 1023);
        Vector<ulong> significand = (bits & new Vector<ulong>(0x000fffffffffffff)) + new Vector<ulong>(TwoThirds);
        Vector<double> f = Vector.AsVectorDouble(significand) - Vector<double>.One;

        // Even and odd terms apart: two short chains of operations instead of a long one.
        Vector<double> z = f * f;
        Vector<double> odd = Fma(z, Fma(z, -0.1658131328838962, -0.13755042987126156), -0.18079612672509604);
        odd = Fma(z, Fma(z, Fma(z, odd, -0.24043414453759182), -0.3606739689695472), -0.7213475196231808);
        Vector<double> even = Fma(z, Fma(z, 0.17607905083854597, 0.15432633610906035), 0.2064542237743695);
        even = Fma(z, Fma(z, Fma(z, even, 0.2885295906248616), 0.48089843779072367), 1.4426950407475623);
        Vector<double> p = Vector.FusedMultiplyAdd(f, odd, even);
        Vector<double> power = y * Vector.FusedMultiplyAdd(f, p, n);

        // Beyond the limits the result is 0 or infinite as a float. The bias is 1.5·2⁵²: see RoundingBias.
        power = Vector.ClampNative(power, new Vector<double>(-200), new Vector<double>(200));
        var bias = new Vector<double>(6755399441055744);
        Vector<double> rounded = power + bias;
        Vector<double> r = power - (rounded - bias);
        Vector<double> e = Fma(r, Fma(r, 0.00015476278592386407, 0.0013400269794225112), 0.009618003968277387);
        e = Fma(r, Fma(r, Fma(r, e, 0.05550327789971868), 0.24022651345305843), 0.6931472062497709);
        e = Fma(r, e, 1);
        return Vector.AsVectorDouble(Vector.AsVectorUInt64(e) + (Vector.AsVectorUInt64(rounded) << 52));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<double> Fma(Vector<double> a, Vector<double> b, double c) =>
        Vector.FusedMultiplyAdd(a, b, new Vector<double>(c));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<double> Fma(Vector<double> a, double b, double c) => Fma(a, new Vector<double>(b), c);
}
