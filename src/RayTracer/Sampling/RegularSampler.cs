using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// The report's uniform grid (section 3.4): the same n×n points in every pixel, which turns fine detail into false patterns
/// (aliasing). Only the position in the pixel is regular; all other dimensions are jittered, for light would alias too.
/// </summary>
/// <param name="samplesPerPixel">How many samples a pixel will have: a square.</param>
public sealed class RegularSampler(int samplesPerPixel) : JitteredSampler(samplesPerPixel)
{
    /// <inheritdoc/>
    public override void Pair(in UIntW pixelKey, in UIntW sample, in UIntW pair, out FloatW u, out FloatW v)
    {
        base.Pair(pixelKey, sample, pair, out u, out v);
        MaskW isPixel = UIntW.Equal(pair, Dimensions.Pixel);
        if (!isPixel.Any)
        {
            return;
        }

        Cell(sample, out FloatW column, out FloatW row);
        u = isPixel.Select((column + 0.5f) * (1f / Side), u);
        v = isPixel.Select((row + 0.5f) * (1f / Side), v);
    }
}
