using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>An image less its reference.</summary>
internal sealed class SignedDifference
{
    public SignedDifference(Picture image, Picture reference)
    {
        Numbers = new(image.Width, image.Height, [.. image.Pixels.Zip(reference.Pixels, (a, b) => a.Equals(b) ? 0 : a - b)]);
        Largest = Numbers.Pixels.Where(float.IsFinite).Select(Math.Abs).DefaultIfEmpty().Max();
    }

    /// <summary>The differences.</summary>
    public Picture Numbers { get; }

    /// <summary>The largest finite one's absolute value.</summary>
    public float Largest { get; }

    /// <summary>As a picture to look at: zero is middle grey, the largest differences are black and white.</summary>
    public Picture Shown()
    {
        float[] pixels = [.. Numbers.Pixels.Select(d => (float)SrgbCurve.Decode(0.5 + (Largest > 0 ? 0.5 * d / Largest : 0)))];
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
