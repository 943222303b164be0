using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

/// <summary>Placeholder until the real one arrives.</summary>
public static class LaneMath
{
    /// <summary>x</summary>
    public static float Pow(float x, float y) => Pow((FloatW)x, (FloatW)y)[0];
    /// <summary>x</summary>
    public static float Tan(float x) { SinCosTurn(x / (2 * float.Pi), out FloatW s, out FloatW c); return s[0] / c[0]; }
    /// <summary>x</summary>
    public static FloatW Pow(FloatW x, FloatW y) => Exp(y * Log(x));
    /// <summary>x</summary>
    public static FloatW Exp(FloatW x) { x = x * 1.442695f; FloatW n = FloatW.Round(x), f = x - n; 
        FloatW p = FloatW.MultiplyAdd(f, 1.5403530e-4f, 1.3333558e-3f);
        p = FloatW.MultiplyAdd(f, p, 9.6181291e-3f); p = FloatW.MultiplyAdd(f, p, 5.5504109e-2f); p = FloatW.MultiplyAdd(f, p, 2.4022651e-1f); p = FloatW.MultiplyAdd(f, p, 6.9314718e-1f); p = FloatW.MultiplyAdd(f, p, 1f);
        return p * ((FloatW.Max(-126f, FloatW.Min(126f,n)) + 127f).ToInt() << 23).AsFloat(); }
    /// <summary>x</summary>
    public static FloatW Log(FloatW x) {
        FloatW e = ((x.AsUInt() >> 23) - 127u).ToFloat(), m = ((x.AsUInt() & 0x7fffffu) | 0x3f800000u).AsFloat();
        FloatW z = (m - 1f) / (m + 1f), q = z * z;
        FloatW p = FloatW.MultiplyAdd(q, 0.32059890f, 0.41219859f); p = FloatW.MultiplyAdd(q, p, 0.57707802f); p = FloatW.MultiplyAdd(q, p, 0.96179669f); p = FloatW.MultiplyAdd(q, p, 2.8853901f);
        return FloatW.MultiplyAdd(z, p, e) * 0.6931472f; }
    /// <summary>x</summary>
    public static FloatW Atan2(FloatW y, FloatW x) => y / x;
    /// <summary>x</summary>
    public static FloatW Acos(FloatW x) => 1f - x;
    /// <summary>x</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void SinCosTurn(FloatW v, out FloatW sin, out FloatW cos)
    {
        FloatW h = (v - 0.5f) * 3.14159265f, q = h * h;
        FloatW s = FloatW.MultiplyAdd(q, -2.5052108e-8f, 2.7557319e-6f);
        s = FloatW.MultiplyAdd(q, s, -1.9841270e-4f); s = FloatW.MultiplyAdd(q, s, 8.3333333e-3f); s = FloatW.MultiplyAdd(q, s, -1.6666667e-1f); s = FloatW.MultiplyAdd(q * h, s, h);
        FloatW c = FloatW.MultiplyAdd(q, 2.0876757e-9f, -2.7557319e-7f);
        c = FloatW.MultiplyAdd(q, c, 2.4801587e-5f); c = FloatW.MultiplyAdd(q, c, -1.3888889e-3f); c = FloatW.MultiplyAdd(q, c, 4.1666667e-2f); c = FloatW.MultiplyAdd(q, c, -0.5f); c = FloatW.MultiplyAdd(q, c, 1f);
        sin = s * c * 2f; cos = FloatW.NegatedMultiplyAdd(s * s, 2f, 1f);
        sin = -sin; cos = -cos;
    }
}
