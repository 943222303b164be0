using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>An image less its reference.</summary>
internal sealed class SignedDifference
{
    // A few differences, as of highlights, may be far larger than those that matter.
    private const double Quantile = 0.98;

    public SignedDifference(Picture image, Picture reference)
    {
        Numbers = new(image.Width, image.Height, [.. image.Pixels.Zip(reference.Pixels, (a, b) => a.Equals(b) ? 0 : a - b)]);
        float[] sizes = [.. Numbers.Pixels.Where(d => float.IsFinite(d) && d != 0).Select(Math.Abs).Order()];
        Range = sizes.Length == 0 ? 0 : sizes[(int)Math.Ceiling(Quantile * (sizes.Length - 1))];
    }

    /// <summary>The differences.</summary>
    public Picture Numbers { get; }

    /// <summary>Differences of this absolute value, and beyond, are black and white in <see cref="Shown"/>.</summary>
    public float Range { get; }

    /// <summary>As a picture to look at: zero is middle grey.</summary>
    public Picture Shown()
    {
        float[] pixels = [.. Numbers.Pixels.Select(d => (float)SrgbCurve.Decode(Math.Clamp(0.5 + (Range > 0 ? 0.5 * d / Range : 0), 0, 1)))];
        for (int i = 0; i < pixels.Length; i += 3)
        {
            if (!Numbers.Pixels.Skip(i).Take(3).All(float.IsFinite))
            {
                (pixels[i], pixels[i + 1], pixels[i + 2]) = (1, 0, 1);
            }
        }

        return new(Numbers.Width, Numbers.Height, pixels);
    }
}
