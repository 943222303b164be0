using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>The exposure that a picture asks for.</summary>
public static class AutoExposure
{
    // What the middle brightness becomes, and steps that are written in full.
    private const double MiddleGrey = 0.25;
    private const int StepsPerStop = 100;

    /// <summary>
    /// The stops of an exposure; of an automatic one those that make the geometric mean of the luminance of all pixels that are not
    /// black (Reinhard et al. 2002, Equation 1) a middle grey. They depend on the pixels alone, which are added up in their order.
    /// </summary>
    /// <param name="exposure">The exposure.</param>
    /// <param name="image">Linear light.</param>
    /// <returns>Stops in steps of a hundredth; 0 for an image that is black.</returns>
    public static float StopsFor(this Exposure exposure, IImageRows image)
    {
        if (!exposure.IsAuto)
        {
            return exposure.Stops;
        }

        float[] row = new float[3 * image.Width];
        (double sum, long lit) = (0, 0);
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, row);
            for (int i = 0; i < row.Length; i += 3)
            {
                float luminance = new Rgb(row[i], row[i + 1], row[i + 2]).Luminance;
                if (luminance > 0 && float.IsFinite(luminance))
                {
                    sum += PortableMath.Log2(luminance);
                    lit++;
                }
            }
        }

        double stops = lit > 0 ? PortableMath.Log2(MiddleGrey) - (sum / lit) : 0;
        return (float)(Math.Round(Math.Clamp(stops, -Exposure.Limit, Exposure.Limit) * StepsPerStop) / StepsPerStop);
    }
}
