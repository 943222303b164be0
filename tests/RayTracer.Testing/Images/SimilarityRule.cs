using System.Globalization;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>
/// Structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004) of luma, as in <see cref="ImageComparison.Ssim"/>, and of red, green and blue, each
/// taken as a grey image; so that a wrong hue of the right luma is seen, too. The worst of the four counts.
/// </summary>
internal sealed record SimilarityRule(double LeastSsim) : ImageRule
{
    private const int SmallestSide = 11;

    internal override ImageVerdict Judge(Picture image, Picture reference)
    {
        if (Math.Min(image.Width, image.Height) < SmallestSide)
        {
            return new(false, $"structural similarity needs {SmallestSide}×{SmallestSide} pixels; the image has {image.Width}×{image.Height}", 0);
        }

        ImageComparison whole = ImageComparison.Compare(image, reference);
        (string What, double Ssim)[] all =
        [
            ("luma", whole.Ssim),
            .. "red green blue".Split(' ').Select((what, channel) => (what, ImageComparison.Compare(Grey(image, channel), Grey(reference, channel)).Ssim)),
        ];
        (string worst, double ssim) = all.MinBy(s => s.Ssim);
        string notFinite = whole.NotFinite > 0 ? $", and {whole.NotFinite} values are NaN or infinite" : "";
        string finding = string.Create(
            CultureInfo.InvariantCulture,
            $"structural similarity of {worst} is {ssim:F5}, to be at least {LeastSsim}{notFinite}; the largest difference is {whole.LargestDifference:G4}, at {whole.LargestX},{whole.LargestY}");
        int pixel = whole.NotFinite > 0 ? Array.FindIndex(image.Pixels, v => !float.IsFinite(v)) / 3 : (whole.LargestY * image.Width) + whole.LargestX;
        return new(whole.NotFinite == 0 && ssim >= LeastSsim, finding, Math.Max(0, pixel));
    }

    private static Picture Grey(Picture picture, int channel) =>
        new(picture.Width, picture.Height, [.. picture.Pixels.Select((_, i) => picture.Pixels[i - (i % 3) + channel])]);
}
