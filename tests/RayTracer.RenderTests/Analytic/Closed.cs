using System.Globalization;

namespace RayTracer.RenderTests.Analytic;

/// <summary>Compares renders with closed forms.</summary>
internal static class Closed
{
    /// <summary>
    /// Fails if the mean of renders with many seeds is not the closed form: Student's t test of every pixel and of the whole
    /// image, each channel, through the budget of <see cref="ErrorBudget.Analytic"/>.
    /// </summary>
    /// <param name="what">What it is, for the message.</param>
    /// <param name="images">The renders.</param>
    /// <param name="expected">Expected mean of a channel (last) in a pixel (column, row).</param>
    /// <param name="pixelTolerance">
    /// What a single pixel may be off: where edges of shapes graze a pixel, hits are too rare for Student's distribution. The
    /// image's mean has no such tolerance.
    /// </param>
    /// <param name="tolerance">What all may be off: the step of a mean of few values, which may come out alike with all seeds.</param>
    public static void Check(string what, ImageSamples images, Func<int, int, int, double> expected, double pixelTolerance = 0, double tolerance = 0)
    {
        List<(double P, string Where)> tests = [];
        for (int channel = 0; channel < 3; channel++)
        {
            double sum = 0;
            for (int y = 0; y < images.Height; y++)
            {
                for (int x = 0; x < images.Width; x++)
                {
                    double value = expected(x, y, channel);
                    sum += value;
                    tests.Add(Test(images, new(x, y, 1, 1), channel, value, Math.Max(pixelTolerance, tolerance)));
                }
            }

            tests.Add(Test(images, new(0, 0, images.Width, images.Height), channel, sum / (images.Width * images.Height), tolerance));
        }

        ErrorBudget.Analytic.Check(PValues.Smallest(tests.Select(t => t.P)), $"{what}: {tests.MinBy(t => t.P).Where}");
    }

    private static (double P, string Where) Test(ImageSamples images, Block block, int channel, double expected, double tolerance)
    {
        BlockEstimate seen = images.Estimate(block, channel);

        // What a float cannot tell is no difference.
        double off = Math.Abs(seen.Mean - expected) - Math.Max(tolerance, BlockTest.AbsoluteTolerance + (BlockTest.RelativeTolerance * Math.Abs(expected)));
        double p = off <= 0 ? 1 : PValues.StudentT(off / Math.Sqrt(seen.Variance), seen.Freedom);
        string where = block.Width * block.Height == 1 ? $"pixel {block.X},{block.Y}" : "mean of the image";
        return (p, string.Create(CultureInfo.InvariantCulture, $"{"red green blue".Split(' ')[channel]}, {where}: {seen.Mean:G7} ± {Math.Sqrt(seen.Variance):G2} instead of {expected:G7}"));
    }
}
