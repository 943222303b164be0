using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>The phase function of Henyey and Greenstein (1941, eq. 2).</summary>
/// <param name="g">Mean cosine.</param>
internal sealed class HenyeyGreenstein(float g) : PhaseFunction
{
    /// <summary>The fraction of the light that is scattered by an angle, per steradian.</summary>
    /// <param name="cosine">Cosine of the angle between the directions of travel before and after.</param>
    /// <param name="g">Mean cosine.</param>
    public static FloatW Evaluate(FloatW cosine, FloatW g)
    {
        FloatW square = FloatW.Max(FloatW.MultiplyAdd(g, g - (cosine * 2f), 1f), 1e-12f);
        return FloatW.NegatedMultiplyAdd(g, g, 1f) * (1f / (4 * float.Pi)) / (square * FloatW.Sqrt(square));
    }

    /// <summary>The cosine of an angle, with the density of the other one.</summary>
    /// <param name="g">Mean cosine.</param>
    /// <param name="u">A random number.</param>
    public static FloatW Cosine(FloatW g, FloatW u)
    {
        // The inverse of the distribution of cosines; where g is small, it is all but 2u − 1, and the formula loses its digits.
        FloatW ratio = FloatW.NegatedMultiplyAdd(g, g, 1f) / FloatW.MultiplyAdd(g * 2f, u, 1f - g);
        FloatW formula = (FloatW.MultiplyAdd(g, g, 1f) - (ratio * ratio)) / (g * 2f);
        FloatW even = FloatW.MultiplyAdd(u, 2f, -1f);
        FloatW first = FloatW.MultiplyAdd(g * 1.5f, FloatW.NegatedMultiplyAdd(even, even, 1f), even);
        return FloatW.Max(FloatW.Min((FloatW.Abs(g) < 1e-3f).Select(first, formula), 1f), -1f);
    }

    /// <inheritdoc/>
    public override FloatW Evaluate(in Vec3W point, FloatW cosine) => Evaluate(cosine, g);

    /// <inheritdoc/>
    public override FloatW Cosine(in Vec3W point, FloatW choice, FloatW u) => Cosine((FloatW)g, u);
}
