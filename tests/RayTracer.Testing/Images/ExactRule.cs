using System.Globalization;
using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>Equal bits.</summary>
internal sealed record ExactRule : ImageRule
{
    internal override ImageVerdict Judge(Picture image, Picture reference)
    {
        int[] differing = [.. Enumerable.Range(0, image.Pixels.Length).Where(i => Bits(image, i) != Bits(reference, i))];
        if (differing.Length == 0)
        {
            return new(true, "all bits are equal", 0);
        }

        int worst = differing.MaxBy(i => Off(image.Pixels[i], reference.Pixels[i]));
        string finding = string.Create(
            CultureInfo.InvariantCulture,
            $"{differing.Select(i => i / 3).Distinct().Count()} of {image.Width * image.Height} pixels have other bits; the worst value is {Place(image, worst)}: {image.Pixels[worst]}, reference {reference.Pixels[worst]}");
        return new(false, finding, worst / 3);
    }

    /// <summary>The absolute difference; infinite where one of two unlike values is not finite.</summary>
    internal static double Off(float a, float b) =>
        a.Equals(b) ? 0 : float.IsFinite(a) && float.IsFinite(b) ? Math.Abs((double)a - b) : double.PositiveInfinity;

    /// <summary>Names a value for messages.</summary>
    internal static string Place(Picture image, int i) =>
        string.Create(CultureInfo.InvariantCulture, $"{"red green blue".Split(' ')[i % 3]} at {i / 3 % image.Width},{i / 3 / image.Width}");

    private static int Bits(Picture picture, int i) => BitConverter.SingleToInt32Bits(picture.Pixels[i]);
}
