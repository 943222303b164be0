using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// The report's uniform grid (section 3.4): the same n×n points in every pixel, which turns fine detail into false patterns
/// (aliasing). Only the position in the pixel is regular; all other dimensions are jittered, for light would alias too.
/// </summary>
/// <param name="samplesPerPixel">The number of samples that a pixel will have: a square.</param>
internal sealed class RegularSampler(int samplesPerPixel) : JitteredSampler(samplesPerPixel)
{
    /// <inheritdoc/>
    public override void Begin(in UIntW pixelKey, in UIntW sample, uint group, out SamplePoints points)
    {
        base.Begin(pixelKey, sample, group, out points);
        points.Second = group == Dimensions.Pixel ? IsPixel : 0u;
    }

    /// <inheritdoc/>
    public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points)
    {
        base.Begin(pixelKey, sample, group, out points);
        points.Second = 0u;
    }

    /// <inheritdoc/>
    public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v)
    {
        if (points.Second[0] != IsPixel)
        {
            base.Pair(points, pair, out u, out v);
            return;
        }

        Cell(points.First, out FloatW column, out FloatW row);
        u = (column + 0.5f) * (1f / Side);
        v = (row + 0.5f) * (1f / Side);
    }

    private const uint IsPixel = 1;
}

/// <summary>The regular sampler.</summary>
internal sealed class RegularKind() : JitteredKind("regular")
{
    public override Sampler Create(int samplesPerPixel) => new RegularSampler(samplesPerPixel);
}
