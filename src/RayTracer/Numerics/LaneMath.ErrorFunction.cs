using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

public static partial class LaneMath
{
    /// <summary>
    /// The error function, 2/√π times the integral of exp(−t²) from 0 to <paramref name="x"/>: absolute error below 3e-7
    /// (Abramowitz &amp; Stegun, Handbook of Mathematical Functions, 1964, eq. 7.1.26).
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static FloatW Erf(in FloatW x)
    {
        FloatW size = FloatW.Abs(x);
        FloatW t = 1f / Fma(size, 0.3275911f, 1f);
        FloatW p = Fma(t, Fma(t, 1.061405429f, -1.453152027f), 1.421413741f);
        p = Fma(t, Fma(t, p, -0.284496736f), 0.254829592f) * t;
        return FloatW.CopySign(FloatW.NegatedMultiplyAdd(p, Exp(-(size * size)), 1f), x);
    }

    /// <inheritdoc cref="Erf(in FloatW)"/>
    public static float Erf(float x) => Erf((FloatW)x)[0];

    /// <summary>
    /// The inverse of the error function, for arguments inside (−1, 1): relative error below 1e-6 but for the rounding of 1 − x² near the ends (Giles,
    /// Approximating the erfinv function, GPU Computing Gems, 2011, listing 2).
    /// </summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static FloatW InverseErf(in FloatW x)
    {
        FloatW w = -Log((1f - x) * (1f + x));
        FloatW c = w - 2.5f;
        FloatW central = Fma(c, Fma(c, Fma(c, 2.81022636e-8f, 3.43273939e-7f), -3.5233877e-6f), -4.39150654e-6f);
        central = Fma(c, Fma(c, Fma(c, Fma(c, Fma(c, central, 2.1858087e-4f), -1.25372503e-3f), -4.17768164e-3f), 0.246640727f), 1.50140941f);
        FloatW d = FloatW.Sqrt(w) - 3f;
        FloatW tail = Fma(d, Fma(d, Fma(d, -2.00214257e-4f, 1.00950558e-4f), 1.34934322e-3f), -3.67342844e-3f);
        tail = Fma(d, Fma(d, Fma(d, Fma(d, Fma(d, tail, 5.73950773e-3f), -7.6224613e-3f), 9.43887047e-3f), 1.00167406f), 2.83297682f);
        return (w < 5f).Select(central, tail) * x;
    }

    /// <inheritdoc cref="InverseErf(in FloatW)"/>
    public static float InverseErf(float x) => InverseErf((FloatW)x)[0];
}
