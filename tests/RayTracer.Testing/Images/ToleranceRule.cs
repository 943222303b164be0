using System.Globalization;
using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>Differences of channels up to a limit.</summary>
internal sealed record ToleranceRule(double Absolute, double Relative, double OutlierShare) : ImageRule
{
    internal override ImageVerdict Judge(Picture image, Picture reference)
    {
        double[] excess = [.. image.Pixels.Zip(reference.Pixels, Excess)];
        int worst = Enumerable.Range(0, excess.Length).MaxBy(i => excess[i]);
        int pixels = image.Width * image.Height;
        int outliers = excess.Chunk(3).Count(pixel => pixel.Any(e => e > 0));
        bool unlike = double.IsPositiveInfinity(excess[worst]);
        string finding = string.Create(
            CultureInfo.InvariantCulture,
            $"{outliers} of {pixels} pixels are further off than {Absolute} + {Relative} of the reference, and {OutlierShare:P2} may be; the worst value is {ExactRule.Place(image, worst)}: {image.Pixels[worst]}, reference {reference.Pixels[worst]}");
        return new(!unlike && outliers <= OutlierShare * pixels, finding, worst / 3);
    }

    // By how much a value is beyond its limit.
    private double Excess(float value, float reference)
    {
        double off = ExactRule.Off(value, reference);
        return double.IsFinite(off) && float.IsFinite(reference) ? off - Absolute - (Relative * Math.Abs(reference)) : off;
    }
}
