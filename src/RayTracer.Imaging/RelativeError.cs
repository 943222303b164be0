using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// The relative mean squared error (<see cref="ImageComparison.RelativeMse"/>) of an image of few samples, where single pixels that are far too
/// bright may outweigh all others. Pixels with a value that is NaN or infinite in either image are left out; NaN if no other is there.
/// </summary>
/// <param name="Trimmed">The mean over all pixels but the worst thousandth.</param>
/// <param name="Whole">The mean over all pixels.</param>
internal readonly record struct RelativeError(double Trimmed, double Whole)
{
    private const int PixelsForOneLeftOut = 1000;

    /// <summary>Compares two images of one size.</summary>
    /// <param name="image">The image to judge; linear RGB.</param>
    /// <param name="reference">The reference image; linear RGB.</param>
    /// <exception cref="PictureException">The images differ in size.</exception>
    public static RelativeError Of(IImageRows image, IImageRows reference)
    {
        ImageComparison.CheckSameSize(image, reference);
        List<double> pixels = new(image.Width * image.Height);
        float[] a = new float[3 * image.Width];
        float[] b = new float[a.Length];
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, a);
            reference.ReadRow(y, b);
            for (int i = 0; i < a.Length; i += 3)
            {
                pixels.Add((ImageComparison.RelativeSquare(a[i], b[i]) + ImageComparison.RelativeSquare(a[i + 1], b[i + 1]) + ImageComparison.RelativeSquare(a[i + 2], b[i + 2])) / 3);
            }
        }

        pixels.RemoveAll(p => !double.IsFinite(p));
        pixels.Sort();
        return new(Mean(pixels.SkipLast(pixels.Count / PixelsForOneLeftOut)), Mean(pixels));
    }

    private static double Mean(IEnumerable<double> values) => values.DefaultIfEmpty(double.NaN).Average();
}
