using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Imaging;

/// <summary>Tone mapping of one colour: linear light in, linear light of the display out (the sRGB curve is still to come).</summary>
public static class ToneMapping
{
    // Beyond this every curve has long been flat; it keeps products of two such numbers finite.
    private const float Brightest = 1e15f;

    /// <summary>
    /// Maps a colour. A NaN channel may spread to the others; no other input gives NaN, except with <see cref="ToneMap.Clamp"/>, which is
    /// the identity.
    /// </summary>
    /// <param name="map">The curve.</param>
    /// <param name="colour">Linear light, any value.</param>
    /// <returns>Linear light of the display. It may lie slightly outside [0, 1], which the encoding cuts off.</returns>
    /// <remarks>The usual maps are inlined: a call a pixel is half of the time that a moving view's picture takes to be shown.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Rgb Apply(ToneMap map, Rgb colour) =>
        map == ToneMap.Clamp ? colour : map == ToneMap.Soft ? Soft(Bounded(colour)) : ApplyOther(map, colour);

    private static Rgb ApplyOther(ToneMap map, Rgb colour) => map switch
    {
        ToneMap.Reinhard => Reinhard(Bounded(colour)),
        ToneMap.Aces => Aces(Bounded(colour)),
        ToneMap.Agx => Agx(Bounded(colour)),
        _ => colour,
    };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Rgb Bounded(Rgb c) => new(Bounded(c.R), Bounded(c.G), Bounded(c.B));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Bounded(float v) => v > Brightest ? Brightest : v < 0 ? 0 : v;

    // Khronos Group 2024: what exceeds the shoulder in the strongest channel is compressed towards 1, and the stronger, the more white is
    // added. Its offset, which takes reflections of white surroundings from the colours of things, is for viewers without them.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Rgb Soft(Rgb c)
    {
        const float Shoulder = 0.7f;
        const float Fading = 0.05f;
        const float Room = 1 - Shoulder;
        float peak = MathF.Max(c.R, MathF.Max(c.G, c.B));
        if (peak <= Shoulder)
        {
            return c;
        }

        float shown = 1 - (Room * Room / (peak - Shoulder + Room));
        float white = 1 - (1 / ((Fading * (peak - shown)) + 1));
        return (c * (shown / peak * (1 - white))) + (new Rgb(shown, shown, shown) * white);
    }

    // Reinhard et al. 2002, Equation 3: the luminance L becomes L/(1 + L), so every channel is scaled by 1/(1 + L).
    private static Rgb Reinhard(Rgb c) => c * (1 / (1 + c.Luminance));

    // Hill 2016: the matrices lead from linear sRGB to a film-like space and back, the fraction is the fit of RRT and ODT.
    private static Rgb Aces(Rgb c)
    {
        float r = AcesCurve((0.59719f * c.R) + (0.35458f * c.G) + (0.04823f * c.B));
        float g = AcesCurve((0.07600f * c.R) + (0.90834f * c.G) + (0.01566f * c.B));
        float b = AcesCurve((0.02840f * c.R) + (0.13383f * c.G) + (0.83777f * c.B));
        return new Rgb(
            (1.60475f * r) - (0.53108f * g) - (0.07367f * b),
            (-0.10208f * r) + (1.10813f * g) - (0.00605f * b),
            (-0.00327f * r) - (0.07276f * g) + (1.07602f * b));
    }

    private static float AcesCurve(float v) =>
        ((v * (v + 0.0245786f)) - 0.000090537f) / ((v * ((0.983729f * v) + 0.4329510f)) + 0.238081f);

    // Wrensch 2023: inset matrix, logarithm, sigmoid (a polynomial fitted to it), outset matrix, display power 2.2.
    private static Rgb Agx(Rgb c)
    {
        double r = AgxSigmoid((0.842479062253094 * c.R) + (0.0784335999999992 * c.G) + (0.0792237451477643 * c.B));
        double g = AgxSigmoid((0.0423282422610123 * c.R) + (0.878468636469772 * c.G) + (0.0791661274605434 * c.B));
        double b = AgxSigmoid((0.0423756549057051 * c.R) + (0.0784336 * c.G) + (0.879142973793104 * c.B));
        return new Rgb(
            DisplayPower((1.19687900512017 * r) - (0.0980208811401368 * g) - (0.0990297440797205 * b)),
            DisplayPower((-0.0528968517574562 * r) + (1.15190312990417 * g) - (0.0989611768448433 * b)),
            DisplayPower((-0.0529716355144438 * r) - (0.0980434501171241 * g) + (1.15107367264116 * b)));
    }

    private static double AgxSigmoid(double light)
    {
        const double MinimumStops = -12.47393;
        const double MaximumStops = 4.026069;
        double stops = light < 1e-10 ? MinimumStops : PortableMath.Log2(light);
        stops = stops < MinimumStops ? MinimumStops : stops > MaximumStops ? MaximumStops : stops;
        double x = (stops - MinimumStops) / (MaximumStops - MinimumStops);
        double x2 = x * x;
        double x4 = x2 * x2;
        return (15.5 * x4 * x2) - (40.14 * x4 * x) + (31.96 * x4) - (6.868 * x2 * x) + (0.4298 * x2) + (0.1191 * x) - 0.00232;
    }

    // x^2.2 = x²·x^⅕
    private static float DisplayPower(double x) => x <= 0 ? 0 : (float)(x * x * PortableMath.FifthRoot(x));
}
