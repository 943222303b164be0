using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>
/// How a medium spreads over directions what it scatters, by the cosine of the angle between the directions of travel before and after. It integrates to one over the sphere, so it is its
/// own pdf.
/// </summary>
internal abstract class PhaseFunction
{
    /// <summary>The fraction of the light that is scattered by an angle, per steradian.</summary>
    /// <param name="point">Where.</param>
    /// <param name="cosine">Cosine of the angle.</param>
    public abstract FloatW Evaluate(in Vec3W point, FloatW cosine);

    /// <summary>Chooses the cosine of an angle, with the density of <see cref="Evaluate"/>.</summary>
    /// <param name="point">Where.</param>
    /// <param name="choice">A random number for mixtures.</param>
    /// <param name="u">Another one.</param>
    public abstract FloatW Cosine(in Vec3W point, FloatW choice, FloatW u);

    /// <summary>A direction of travel.</summary>
    /// <param name="before">Unit direction of travel before.</param>
    /// <param name="cosine">Cosine of the angle between both.</param>
    /// <param name="v">A random number, for the angle around it.</param>
    public static Vec3W Turned(in Vec3W before, FloatW cosine, FloatW v)
    {
        FloatW sine = FloatW.Sqrt(FloatW.Max(FloatW.NegatedMultiplyAdd(cosine, cosine, 1f), 0f));
        LaneMath.SinCosTurn(v, out FloatW sin, out FloatW cos);
        Onb.FromNormal(before, out Onb frame);
        return frame.ToWorld(new(sine * cos, sine * sin, cosine));
    }
}
