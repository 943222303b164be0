using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// Maps from the unit square to distributions of points and directions, each beside its pdf. Directions are unit vectors
/// around +z; neighbouring points of the square stay neighbours, so that stratification survives.
/// </summary>
public static class Warp
{
    /// <summary>A direction in the upper hemisphere, denser around z: pdf = cos/π (Malley's method).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W CosineHemisphere(FloatW u, FloatW v)
    {
        LaneMath.SinCosTurn(v, out FloatW sin, out FloatW cos);
        FloatW r = FloatW.Sqrt(u);
        return new(r * cos, r * sin, FloatW.Sqrt(1f - u));
    }

    /// <summary>Pdf of <see cref="CosineHemisphere"/> at the given cosine with z, per steradian.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW CosineHemispherePdf(FloatW cosine) => FloatW.Max(cosine, 0f) * (1f / float.Pi);

    /// <summary>A direction in the cosine-power lobe around z: pdf = (n+1)/2π · cosⁿ (Lafortune &amp; Willems 1994).</summary>
    /// <param name="u">First random number.</param>
    /// <param name="v">Second random number.</param>
    /// <param name="exponent">The power n, at least 0.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W CosinePowerLobe(FloatW u, FloatW v, float exponent)
    {
        // sin² = 1 − (1−u)^(2/(n+1)) = −expm1(−x); a series for small x keeps sharp lobes from rounding to steps.
        FloatW x = LaneMath.Log(1f - u) * (-2f / (exponent + 1f));
        FloatW series = x * FloatW.MultiplyAdd(x, FloatW.MultiplyAdd(x, FloatW.MultiplyAdd(x, -1f / 24f, 1f / 6f), -0.5f), 1f);
        FloatW sin2 = (x < 0.03f).Select(series, 1f - LaneMath.Exp(-x));
        FloatW r = FloatW.Sqrt(FloatW.Max(sin2, 0f));
        LaneMath.SinCosTurn(v, out FloatW sin, out FloatW cos);
        return new(r * cos, r * sin, FloatW.Sqrt(FloatW.Max(1f - sin2, 0f)));
    }

    /// <summary>Pdf of <see cref="CosinePowerLobe"/> where 1 − cosine with z is <paramref name="height"/>, per steradian.</summary>
    public static FloatW CosinePowerLobePdf(FloatW height, float exponent)
    {
        // ln cos = log1p(−h); a series for small h, for 1 − h would round a sharp lobe to steps.
        FloatW series = height * FloatW.MultiplyAdd(height, FloatW.MultiplyAdd(height, FloatW.MultiplyAdd(height, FloatW.MultiplyAdd(
            height, -1f / 5f, -1f / 4f), -1f / 3f), -1f / 2f), -1f);
        FloatW log = (height < 0.03f).Select(series, LaneMath.Log(1f - height));
        FloatW pdf = LaneMath.Exp(log * exponent) * ((exponent + 1f) / (2f * float.Pi));
        return (height < 1f).Select(pdf, 0f);
    }

    /// <summary>A point of the unit sphere: pdf = 1/4π.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W UniformSphere(FloatW u, FloatW v)
    {
        FloatW z = FloatW.NegatedMultiplyAdd(2f, u, 1f);
        FloatW r = FloatW.Sqrt(FloatW.Max(FloatW.NegatedMultiplyAdd(z, z, 1f), 0f));
        LaneMath.SinCosTurn(v, out FloatW sin, out FloatW cos);
        return new(r * cos, r * sin, z);
    }

    /// <summary>A direction in the cone around z whose rim has 1 − cosine = <paramref name="height"/>: pdf = 1/(2π·height).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W UniformCone(FloatW u, FloatW v, FloatW height)
    {
        FloatW below = u * height;
        FloatW r = FloatW.Sqrt(FloatW.Max(below * (2f - below), 0f));
        LaneMath.SinCosTurn(v, out FloatW sin, out FloatW cos);
        return new(r * cos, r * sin, 1f - below);
    }

    /// <summary>A point of the unit disk: pdf = 1/π, by the concentric map (Shirley &amp; Chiu 1997).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void ConcentricDisk(FloatW u, FloatW v, out FloatW x, out FloatW y)
    {
        FloatW a = FloatW.MultiplyAdd(u, 2f, -1f);
        FloatW b = FloatW.MultiplyAdd(v, 2f, -1f);
        MaskW wide = FloatW.Abs(a) > FloatW.Abs(b);
        FloatW r = wide.Select(a, b);
        FloatW other = wide.Select(b, a);
        FloatW ratio = (FloatW.Abs(r) > 0f).Select(other / r, 0f);
        LaneMath.SinCosTurn(ratio * 0.125f, out FloatW sin, out FloatW cos);
        x = r * wide.Select(cos, sin);
        y = r * wide.Select(sin, cos);
    }

    /// <summary>A point of the regular polygon whose corners lie on the unit circle: pdf = 1 / (n/2 · sin 2π/n).</summary>
    /// <param name="u">First random number: it also chooses one of the triangles around the middle.</param>
    /// <param name="v">Second random number.</param>
    /// <param name="corners">Number n of corners, at least 3.</param>
    /// <param name="turn">By how much of a turn the first corner lies from the x axis towards y, in [0, 1).</param>
    /// <param name="x">First coordinate of the point.</param>
    /// <param name="y">Second coordinate of the point.</param>
    public static void RegularPolygon(FloatW u, FloatW v, int corners, float turn, out FloatW x, out FloatW y)
    {
        FloatW scaled = u * corners;
        FloatW corner = FloatW.Min(FloatW.Floor(scaled), corners - 1);
        UniformTriangle(FloatW.Min(scaled - corner, FloatBits.OneMinusEpsilon), v, out FloatW middle, out FloatW next);
        FloatW here = FloatW.MultiplyAdd(corner, 1f / corners, turn);
        LaneMath.SinCosTurn(here, out FloatW sin, out FloatW cos);
        LaneMath.SinCosTurn(here + (1f / corners), out FloatW nextSin, out FloatW nextCos);
        FloatW first = 1f - middle - next;
        x = FloatW.MultiplyAdd(cos, first, nextCos * next);
        y = FloatW.MultiplyAdd(sin, first, nextSin * next);
    }

    /// <summary>
    /// Barycentric coordinates of a uniform point of a triangle: pdf = 1/area (Shirley &amp; Chiu 1997's square root map).
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void UniformTriangle(FloatW u, FloatW v, out FloatW b1, out FloatW b2)
    {
        FloatW root = FloatW.Sqrt(u);
        b1 = 1f - root;
        b2 = root * v;
    }
}
