using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Media;

/// <summary>A mixture of two phase functions.</summary>
/// <param name="first">The one.</param>
/// <param name="second">The other.</param>
/// <param name="weight">The share of the second one.</param>
/// <param name="weights">Factors on that share; null for none.</param>
internal sealed class MixedPhase(PhaseFunction first, PhaseFunction second, float weight, PlacedGrid? weights) : PhaseFunction
{
    private readonly AffineW? _toWeights = weights is null ? null : new(weights.ToVoxels);

    /// <inheritdoc/>
    public override FloatW Evaluate(in Vec3W point, FloatW cosine)
    {
        FloatW one = first.Evaluate(point, cosine);
        return FloatW.MultiplyAdd(second.Evaluate(point, cosine) - one, Share(point), one);
    }

    /// <inheritdoc/>
    public override FloatW Cosine(in Vec3W point, FloatW choice, FloatW u)
    {
        MaskW isSecond = VertexSamples.Choose(choice, Share(point), out FloatW rest);
        return isSecond.Select(second.Cosine(point, rest, u), first.Cosine(point, rest, u));
    }

    private FloatW Share(in Vec3W point)
    {
        if (_toWeights is null)
        {
            return weight;
        }

        _toWeights.Point(point, out Vec3W there);
        weights!.Value(there, out RgbW factor);
        return FloatW.Min(factor.R * weight, 1f);
    }
}
