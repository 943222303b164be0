using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>A reference known by its mean image and the variance of that mean, pixel by pixel; errors of pixels are independent.</summary>
/// <param name="Mean">The mean image.</param>
/// <param name="Variance">Estimated variance of the mean, of the same size.</param>
/// <param name="Freedom">Degrees of freedom of each pixel's variance: the number of images that were averaged, less one.</param>
public sealed record ReferenceMoments(Picture Mean, Picture Variance, double Freedom)
{
    /// <summary>Mean of a block, with its variance, whose degrees of freedom follow from Welch's formula (1947).</summary>
    /// <param name="block">The pixels.</param>
    /// <param name="channel">0 red, 1 green, 2 blue.</param>
    public BlockEstimate Estimate(Block block, int channel)
    {
        double mean = 0;
        double variance = 0;
        double squares = 0;
        for (int y = block.Y; y < block.Y + block.Height; y++)
        {
            for (int x = block.X; x < block.X + block.Width; x++)
            {
                int i = (3 * ((y * Mean.Width) + x)) + channel;
                mean += Mean.Pixels[i];
                variance += Variance.Pixels[i];
                squares += (double)Variance.Pixels[i] * Variance.Pixels[i];
            }
        }

        double count = (double)block.Width * block.Height;
        return new(mean / count, variance / (count * count), squares > 0 ? Freedom * variance * variance / squares : Freedom);
    }
}
