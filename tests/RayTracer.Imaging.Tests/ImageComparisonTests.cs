using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

public class ImageComparisonTests
{
    [Fact]
    public void Equal_images_differ_in_nothing()
    {
        ImageComparison result = ImageComparison.Compare(TestPictures.Noise(20, 15), TestPictures.Noise(20, 15));
        Assert.Equal((0, 0, double.PositiveInfinity, 0), (result.Rmse, result.RelativeMse, result.Psnr, result.LargestDifference));
        Assert.Equal(1, result.Ssim, 1e-12);
    }

    [Fact]
    public void One_difference_is_measured_and_found()
    {
        var reference = new Picture(4, 3);
        Array.Fill(reference.Pixels, 0.5f);
        var image = new Picture(4, 3, [.. reference.Pixels]);
        image.Pixels[(3 * ((2 * 4) + 1)) + 2] = 0.75f;
        image.Pixels[0] = 0.375f;
        ImageComparison result = ImageComparison.Compare(image, reference);
        double squares = 0.0625 + 0.015625;
        Assert.Equal(Math.Sqrt(squares / 36), result.Rmse, 1e-12);
        Assert.Equal(squares / 36 / 0.26, result.RelativeMse, 1e-12);
        Assert.Equal(-10 * Math.Log10(squares / 36), result.Psnr, 1e-12);
        Assert.Equal((0.25, 1, 2, 2), (result.LargestDifference, result.LargestX, result.LargestY, result.LargestChannel));
        Assert.Equal(0, result.NotFinite);
        Assert.True(double.IsNaN(result.Ssim));
    }

    [Fact]
    public void Relative_error_is_known_with_and_without_the_worst_thousandth()
    {
        Picture reference = new(40, 50);
        Array.Fill(reference.Pixels, 0.5f);
        Picture image = new(40, 50, [.. reference.Pixels]);
        Assert.Equal(new(0, 0), RelativeError.Of(image, reference));

        // Squares of 4, 1 and 1/16, by 0.5² + 0.01 and three channels; the worst two of 2,000 pixels are left out.
        (image.Pixels[0], image.Pixels[3000], image.Pixels[5999]) = (2.5f, -0.5f, 0.75f);
        RelativeError error = RelativeError.Of(image, reference);
        Assert.Equal((4 + 1 + 0.0625) / 0.26 / 6000, error.Whole, 1e-12);
        Assert.Equal(0.0625 / 0.26 / (3 * 1998), error.Trimmed, 1e-12);
        Assert.Equal(ImageComparison.Compare(image, reference).RelativeMse, error.Whole, 1e-12);
    }

    [Fact]
    public void Relative_error_leaves_out_pixels_that_are_not_finite()
    {
        Picture reference = new(2, 1, [0, 0, 0, 0, 0, 0]);
        Assert.Equal(0.01 / 0.01 / 3, RelativeError.Of(new Picture(2, 1, [0.1f, 0, 0, float.NaN, 5, 5]), reference).Whole, 1e-6);
        Assert.True(double.IsNaN(RelativeError.Of(reference, new Picture(2, 1, [.. Enumerable.Repeat(float.PositiveInfinity, 6)])).Trimmed));
        Assert.Throws<PictureException>(() => RelativeError.Of(reference, new Picture(1, 2)));
    }

    [Fact]
    public void Ssim_is_the_mean_over_all_windows()
    {
        Picture a = TestPictures.Noise(17, 13, 1);
        Picture b = TestPictures.Noise(17, 13, 2);
        Assert.Equal(DirectSsim(a, b), ImageComparison.Compare(a, b).Ssim, 1e-10);
    }

    [Fact]
    public void Values_that_are_not_finite_are_counted_and_left_out()
    {
        Picture reference = TestPictures.Noise(12, 12);
        var image = new Picture(12, 12, [.. reference.Pixels]);
        image.Pixels[5] = float.NaN;
        image.Pixels[6] = float.PositiveInfinity;
        reference.Pixels[6] = float.PositiveInfinity;
        ImageComparison result = ImageComparison.Compare(image, reference);
        Assert.Equal((2, 0), (result.NotFinite, result.Rmse));
        Assert.Equal(1, result.Ssim, 1e-12);
        Array.Fill(image.Pixels, float.NaN);
        Assert.True(double.IsNaN(ImageComparison.Compare(image, reference).Rmse));
    }

    [Fact]
    public void Different_sizes_are_refused()
    {
        string message = Assert.Throws<PictureException>(() => ImageComparison.Compare(new Picture(2, 3), new Picture(3, 2))).Message;
        Assert.Equal("Images of different sizes cannot be compared: 2×3 and 3×2 pixels.", message);
        Assert.Throws<PictureException>(() => new DifferenceRows(new Picture(2, 3), new Picture(3, 2)));
    }

    [Fact]
    public void The_difference_is_an_image()
    {
        var row = new float[6];
        new DifferenceRows(new Picture(2, 1, [1, 2, 3, float.NaN, 5, 6]), new Picture(2, 1, [3, 2, 1, 0, float.PositiveInfinity, 5]), 4).ReadRow(0, row);
        Assert.Equal([8, 0, 8, 1, 1, 4], row);
    }

    // Wang et al. 2004, Equations 6, 13 and the weighted statistics of section III-C, window by window in two dimensions.
    private static double DirectSsim(Picture a, Picture b)
    {
        static double Luma(Picture picture, int x, int y)
        {
            int i = 3 * ((y * picture.Width) + x);
            return ((0.2126 * SrgbCurve.Encode16(picture.Pixels[i])) + (0.7152 * SrgbCurve.Encode16(picture.Pixels[i + 1]))
                + (0.0722 * SrgbCurve.Encode16(picture.Pixels[i + 2]))) / 65535;
        }

        var similarities = new List<double>();
        for (int y0 = 0; y0 + 11 <= a.Height; y0++)
        {
            for (int x0 = 0; x0 + 11 <= a.Width; x0++)
            {
                (double A, double B, double Weight)[] window = [.. from y in Enumerable.Range(0, 11)
                                                                   from x in Enumerable.Range(0, 11)
                                                                   let weight = Math.Exp(-(((x - 5) * (x - 5)) + ((y - 5) * (y - 5))) / 4.5)
                                                                   select (Luma(a, x0 + x, y0 + y), Luma(b, x0 + x, y0 + y), weight)];
                double total = window.Sum(p => p.Weight);
                double meanA = window.Sum(p => p.Weight * p.A) / total;
                double meanB = window.Sum(p => p.Weight * p.B) / total;
                double varianceA = window.Sum(p => p.Weight * (p.A - meanA) * (p.A - meanA)) / total;
                double varianceB = window.Sum(p => p.Weight * (p.B - meanB) * (p.B - meanB)) / total;
                double covariance = window.Sum(p => p.Weight * (p.A - meanA) * (p.B - meanB)) / total;
                similarities.Add(((2 * meanA * meanB) + 1e-4) * ((2 * covariance) + 9e-4)
                    / (((meanA * meanA) + (meanB * meanB) + 1e-4) * (varianceA + varianceB + 9e-4)));
            }
        }

        return similarities.Average();
    }
}
