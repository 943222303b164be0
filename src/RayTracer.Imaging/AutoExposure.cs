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

    // Of what is lit, one part in so many may be brighter than a display.
    private const int TooBright = 4;

    /// <summary>
    /// The stops of an exposure; of an automatic one those that make the geometric mean of the luminance of all pixels that are not
    /// black (Reinhard et al. 2002, Equation 1) a middle grey; of a limited one those that leave at most a quarter of these pixels brighter
    /// than 1, and 0 where that is so already. They depend on the pixels alone, in their order.
    /// </summary>
    /// <param name="exposure">The exposure.</param>
    /// <param name="image">Linear light.</param>
    /// <returns>Stops in steps of a hundredth; 0 for an image that is black.</returns>
    public static float StopsFor(this Exposure exposure, IImageRows image)
    {
        if (exposure.Rule == ExposureRule.Stops)
        {
            return exposure.Stops;
        }

        Brightness brightness = new(needsMean: exposure.Rule == ExposureRule.Auto);
        float[] row = new float[3 * image.Width];
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, row);
            for (int i = 0; i < row.Length; i += 3)
            {
                brightness.Add(new Rgb(row[i], row[i + 1], row[i + 2]).Luminance);
            }
        }

        return (exposure.Rule == ExposureRule.Auto ? brightness.StopsToGrey : brightness.StopsToLimit) / (float)StepsPerStop;
    }

    /// <summary>How bright pixels are: the mean of their logarithms, and how many are how much too bright.</summary>
    private sealed class Brightness(bool needsMean)
    {
        private readonly long[] _above = new long[(StepsPerStop * (int)Exposure.Limit) + 1];
        private long _lit;

        // The product of all luminances, from 1 up to 2, and its binary exponent: one logarithm serves for all.
        private double _product = 1;
        private long _exponent;

        // Both in steps.
        public int StopsToGrey => _lit == 0 ? 0
            : (int)Math.Round(StepsPerStop * Math.Clamp(PortableMath.Log2(MiddleGrey) - ((_exponent + PortableMath.Log2(_product)) / _lit), -Exposure.Limit, Exposure.Limit));

        public int StopsToLimit
        {
            get
            {
                int steps = _above.Length - 1;
                for (long brighter = 0; steps > 0 && (brighter += _above[steps]) <= _lit / TooBright; steps--)
                {
                }

                return -steps;
            }
        }

        public void Add(float luminance)
        {
            if (!(luminance > 0) || !float.IsFinite(luminance))
            {
                return;
            }

            _lit++;
            if (needsMean)
            {
                Multiply(luminance);
            }
            else if (luminance > 1)
            {
                // White is 1 but for rounding.
                _above[Math.Min((int)Math.Round(StepsPerStop * PortableMath.Log2(luminance)), _above.Length - 1)]++;
            }
        }

        private void Multiply(double luminance)
        {
            const int mantissaBits = 52;
            long bits = BitConverter.DoubleToInt64Bits(_product * luminance);
            long exponent = (bits >> mantissaBits) - 1023;
            _exponent += exponent;
            _product = BitConverter.Int64BitsToDouble(bits - (exponent << mantissaBits));
        }
    }
}
