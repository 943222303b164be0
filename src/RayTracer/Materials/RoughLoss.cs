using RayTracer.Numerics;

namespace RayTracer.Materials;

/// <summary>
/// The light that rough mirrors lose, because one microfacet reflects it onto another, over what they reflect: a table by numerical
/// integration.
/// </summary>
internal sealed unsafe class RoughLoss
{
    private const int Angles = 128;
    private readonly PinnedBuffer<float> _memory = new(Angles + 1);
    private readonly float* _loss;

    /// <summary>Integrates.</summary>
    /// <param name="roughness">The roughness, the same everywhere and in all directions.</param>
    public RoughLoss(Roughness roughness)
    {
        _loss = _memory.Pointer;
        SurfaceW anywhere = default;
        roughness.Evaluate(anywhere, out Microfacets microfacets);
        for (int i = 0; i <= Angles; i++)
        {
            RoughTransmittance.Integrate(microfacets, Math.Max(i / (float)Angles, 1e-3f), 0, out float reflected, out _);
            _loss[i] = (1 - reflected) / reflected;
        }
    }

    /// <summary>The light that is lost, as a part of what is reflected.</summary>
    /// <param name="cosine">Cosine of the ray; taken for 0 below, and for 1 above.</param>
    public FloatW At(FloatW cosine)
    {
        FloatW place = FloatW.Max(0f, FloatW.Min(cosine, 1f)) * Angles;
        FloatW left = FloatW.Min(FloatW.Floor(place), Angles - 1);
        UIntW index = left.ToIntInRange();
        FloatW.Gather(_loss, index, out FloatW a, out FloatW b);
        return FloatW.Mix(a, b, place - left);
    }
}
