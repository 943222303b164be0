using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>The phase function of what is much smaller than a wavelength, for light without polarisation: 3/(16π) · (1 + cos²) (Rayleigh 1871).</summary>
internal sealed class RayleighPhase : PhaseFunction
{
    /// <inheritdoc/>
    public override FloatW Evaluate(in Vec3W point, FloatW cosine) => FloatW.MultiplyAdd(cosine, cosine, 1f) * (3f / (16 * float.Pi));

    /// <inheritdoc/>
    public override FloatW Cosine(in Vec3W point, FloatW choice, FloatW u)
    {
        // Cardano's root of cos³ + 3 cos = 8u − 4, where the distribution is u.
        FloatW half = FloatW.MultiplyAdd(u, 4f, -2f);
        FloatW size = FloatW.Abs(half);
        FloatW cube = size + FloatW.Sqrt(FloatW.MultiplyAdd(size, size, 1f));
        FloatW root = LaneMath.Exp(LaneMath.Log(cube) * (1f / 3f));
        return FloatW.CopySign(FloatW.Max(FloatW.Min(root - (1f / root), 1f), 0f), half);
    }
}
