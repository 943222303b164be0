using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// The difference of an image from a reference. Values that are NaN or infinite in either image are left out of every measure and
/// counted (SSIM takes them as black in both); all numbers are computed in double precision in one fixed order.
/// </summary>
public sealed record ImageComparison
{
    /// <summary>
    /// Root of the mean squared difference over all pixels and channels, in units of linear light; NaN if nothing can be compared.
    /// </summary>
    public required double Rmse { get; init; }

    /// <summary>
    /// Mean of (a − b)²/(b² + 0.01), b being the reference (Rousselle, Knaus, Zwicker 2011, section 3); NaN if nothing can be compared.
    /// </summary>
    public required double RelativeMse { get; init; }

    /// <summary>
    /// Peak signal-to-noise ratio in decibels, −10 log₁₀ of the mean squared difference, the peak being linear light of 1; infinite for
    /// equal images.
    /// </summary>
    public required double Psnr { get; init; }

    /// <summary>
    /// Structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004, Equation 13) of the sRGB-encoded luma; 1 for equal images; NaN if a
    /// side has less than 11 pixels.
    /// </summary>
    public required double Ssim { get; init; }

    /// <summary>The largest absolute difference of one channel.</summary>
    public required double LargestDifference { get; init; }

    /// <summary>Column of the largest difference, the first one from the top left.</summary>
    public required int LargestX { get; init; }

    /// <summary>Row of the largest difference.</summary>
    public required int LargestY { get; init; }

    /// <summary>Channel of the largest difference: 0 red, 1 green, 2 blue.</summary>
    public required int LargestChannel { get; init; }

    /// <summary>The number of values left out because they are NaN or infinite in one or both images.</summary>
    public required long NotFinite { get; init; }

    /// <summary>Compares two images of one size, row by row.</summary>
    /// <param name="image">The image to judge; linear RGB.</param>
    /// <param name="reference">The reference image; linear RGB.</param>
    /// <exception cref="PictureException">The images differ in size.</exception>
    public static ImageComparison Compare(IImageRows image, IImageRows reference)
    {
        CheckSameSize(image, reference);
        var a = new float[3 * image.Width];
        var b = new float[a.Length];
        var ssim = new StructuralSimilarity(image.Width);
        double squares = 0;
        double relative = 0;
        double largest = 0;
        (int X, int Y, int Channel) where = default;
        long count = 0;
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, a);
            reference.ReadRow(y, b);
            for (int i = 0; i < a.Length; i++)
            {
                if (!float.IsFinite(a[i]) || !float.IsFinite(b[i]))
                {
                    a[i] = b[i] = 0;
                    continue;
                }

                double difference = Math.Abs((double)a[i] - b[i]);
                count++;
                squares += difference * difference;
                relative += RelativeSquare(a[i], b[i]);
                if (difference > largest)
                {
                    largest = difference;
                    where = (i / 3, y, i % 3);
                }
            }

            ssim.Add(a, b);
        }

        double mse = squares / count;
        return new ImageComparison
        {
            Rmse = Math.Sqrt(mse),
            RelativeMse = relative / count,
            Psnr = mse == 0 ? double.PositiveInfinity : -10 * PortableMath.Log2(mse) / PortableMath.Log2(10),
            Ssim = ssim.Mean,
            LargestDifference = largest,
            LargestX = where.X,
            LargestY = where.Y,
            LargestChannel = where.Channel,
            NotFinite = (3L * image.Width * image.Height) - count,
        };
    }

    /// <summary>What one value of an image adds to <see cref="RelativeMse"/>.</summary>
    internal static double RelativeSquare(double value, double reference) =>
        (value - reference) * (value - reference) / ((reference * reference) + 0.01);

    internal static void CheckSameSize(IImageRows image, IImageRows reference)
    {
        if (image.Width != reference.Width || image.Height != reference.Height)
        {
            throw new PictureException(
                $"Images of different sizes cannot be compared: {image.Width}×{image.Height} and {reference.Width}×{reference.Height} pixels.");
        }
    }
}
