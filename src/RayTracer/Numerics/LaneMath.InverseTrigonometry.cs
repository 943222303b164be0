using System.Numerics;
using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

public static partial class LaneMath
{
    /// <summary>
    /// The angle of the point (x, y) from the x axis, in radians, in [−π, π], within 1.6 ulp. Zeros keep their signs and
    /// infinities are limits, as in ISO C (2018, F.10.1.4); NaN gives NaN.
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static FloatW Atan2(in FloatW y, in FloatW x)
    {
        FloatW absX = FloatW.Abs(x);
        FloatW absY = FloatW.Abs(y);
        FloatW low = FloatW.Min(absX, absY);
        FloatW high = FloatW.Max(absX, absY);

        // Equal magnitudes have quotient 1, also where they are infinite; but 0/0 is taken as 0.
        FloatW q = (low < high).Select(low / high, (high > 0f).Select(1f, 0f));
        FloatW z = q * q;
        FloatW p = Fma(z, Fma(z, -1.79605058e-3f, 1.09181022e-2f), -3.11699659e-2f);
        p = Fma(z, Fma(z, Fma(z, p, 5.79352938e-2f), -8.40137675e-2f), 1.09512664e-1f);
        p = Fma(z, Fma(z, Fma(z, p, -1.42640427e-1f), 1.99985296e-1f), -3.33332986e-1f);
        FloatW r = Fma(q * z, p, q);

        // atan q, π/2 − atan q, π/2 + atan q or π − atan q.
        MaskW steep = absY > absX;
        var left = new MaskW(Vector.AsVectorInt32(x.V) >> 31);
        FloatW start = steep.Select(HalfPiHigh, left.Select(2f * HalfPiHigh, 0f));
        r = steep.Select(~left, left).Select(-r, r);
        r = Fma(start, HalfPiMiddle / HalfPiHigh, r) + start;
        MaskW numbers = absX <= float.PositiveInfinity & absY <= float.PositiveInfinity;
        return numbers.Select(FloatW.CopySign(r, y), float.NaN);
    }

    /// <inheritdoc cref="Atan2(in FloatW, in FloatW)"/>
    public static float Atan2(float y, float x) => Atan2((FloatW)y, (FloatW)x)[0];

    /// <summary>The angle in [0, π] whose cosine is <paramref name="x"/>, within 2.4 ulp; NaN outside [−1, 1].</summary>
    public static FloatW Acos(in FloatW x) => Atan2(FloatW.Sqrt((1f - x) * (1f + x)), x);

    /// <inheritdoc cref="Acos(in FloatW)"/>
    public static float Acos(float x) => Acos((FloatW)x)[0];
}
