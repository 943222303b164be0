using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>
/// The phase function of Henyey and Greenstein (1941, eq. 2): how light is spread over directions where a medium scatters it. It integrates to one over
/// the sphere, so it is its own pdf.
/// </summary>
internal static class HenyeyGreenstein
{
    /// <summary>The fraction of the light that is scattered by an angle, per steradian.</summary>
    /// <param name="cosine">Cosine of the angle between the directions of travel before and after.</param>
    /// <param name="g">Mean cosine.</param>
    public static FloatW Evaluate(FloatW cosine, FloatW g)
    {
        FloatW square = FloatW.Max(FloatW.MultiplyAdd(g, g - (cosine * 2f), 1f), 1e-12f);
        return FloatW.NegatedMultiplyAdd(g, g, 1f) * (1f / (4 * float.Pi)) / (square * FloatW.Sqrt(square));
    }

    /// <summary>A direction of travel, with the density of <see cref="Evaluate"/>.</summary>
    /// <param name="before">Unit direction of travel before.</param>
    /// <param name="g">Mean cosine.</param>
    /// <param name="u">First random number.</param>
    /// <param name="v">Second random number.</param>
    /// <param name="cosine">Cosine of the angle between both.</param>
    public static Vec3W Sample(in Vec3W before, FloatW g, FloatW u, FloatW v, out FloatW cosine)
    {
        // The inverse of the distribution of cosines; where g is small, it is all but 2u − 1, and the formula loses its digits.
        FloatW ratio = FloatW.NegatedMultiplyAdd(g, g, 1f) / FloatW.MultiplyAdd(g * 2f, u, 1f - g);
        FloatW formula = (FloatW.MultiplyAdd(g, g, 1f) - (ratio * ratio)) / (g * 2f);
        FloatW even = FloatW.MultiplyAdd(u, 2f, -1f);
        FloatW first = FloatW.MultiplyAdd(g * 1.5f, FloatW.NegatedMultiplyAdd(even, even, 1f), even);
        cosine = FloatW.Max(FloatW.Min((FloatW.Abs(g) < 1e-3f).Select(first, formula), 1f), -1f);
        FloatW sine = FloatW.Sqrt(FloatW.Max(FloatW.NegatedMultiplyAdd(cosine, cosine, 1f), 0f));
        LaneMath.SinCosTurn(v, out FloatW sin, out FloatW cos);
        Onb.FromNormal(before, out Onb frame);
        return frame.ToWorld(new(sine * cos, sine * sin, cosine));
    }
}
