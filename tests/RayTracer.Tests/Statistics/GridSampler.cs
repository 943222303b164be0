using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Tests.Statistics;

/// <summary>
/// Samples in a grid's cells, for integrals without noise: sample i has the i-th cell for its direction, and chooses its lobe
/// by the i-th multiple of the golden ratio. The columns are shifted against each other, lest an edge along the grid be taken
/// for one a whole cell away.
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
        UIntW column = points.First & last;
        u = (column.ToFloat() + 0.5f) * cell;
        FloatW shift = (((column * Hash.Golden) >> 24).ToFloat() + 0.5f) * (1f / 256f);
        v = ((points.First >> sideBits).ToFloat() + shift) * cell;
        u = UIntW.Equal(points.Key, 0u).Select(u, (points.First * Hash.Golden).ToUnit());
    }
}
