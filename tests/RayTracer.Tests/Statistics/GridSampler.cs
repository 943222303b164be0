using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Tests.Statistics;

/// <summary>
/// Samples at the middles of a grid's cells, for integrals without noise: sample i has the i-th cell for its direction, and
/// chooses its lobe by the i-th multiple of the golden ratio.
/// </summary>
/// <param name="sideBits">Logarithm to base 2 of the cells along each side.</param>
internal sealed class GridSampler(int sideBits) : Sampler(1 << (2 * sideBits))
{
    /// <inheritdoc/>
    public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points)
    {
        points.Key = (group - Dimensions.FirstVertex) & (Dimensions.GroupsPerVertex - 1);
        points.First = points.Second = sample;
    }

    /// <inheritdoc/>
    public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v)
    {
        float cell = 1f / (1 << sideBits);
        uint last = (1u << sideBits) - 1;
        u = ((points.First & last).ToFloat() + 0.5f) * cell;
        v = ((points.First >> sideBits).ToFloat() + 0.5f) * cell;
        u = UIntW.Equal(points.Key, 0u).Select(u, (points.First * Hash.Golden).ToUnit());
    }
}
