using System.Globalization;

namespace RayTracer.Testing;

/// <summary>
/// Tests whether two estimates of an image agree: Welch's t test (1947), of each channel, on the image mean, on blocks of 16×16
/// and of 4×4 pixels. Blocks see small errors of energy that single pixels drown in noise, and trouble of a few pixels that the
/// mean drowns.
/// </summary>
/// <param name="P">p-value of the whole comparison: the smallest of all times their number.</param>
/// <param name="Worst">The block with the smallest p-value.</param>
/// <param name="Channel">Its channel: 0 red, 1 green, 2 blue.</param>
/// <param name="Image">Estimate of that block in the image.</param>
/// <param name="Reference">Estimate of that block in the reference.</param>
public sealed record BlockTest(double P, Block Worst, int Channel, BlockEstimate Image, BlockEstimate Reference)
{
    /// <summary>Relative error that float arithmetic may make; what is less is no difference.</summary>
    public const double RelativeTolerance = 1e-5;

    /// <summary>As <see cref="RelativeTolerance"/>, for what is all but black.</summary>
    public const double AbsoluteTolerance = 1e-7;

    /// <summary>Sides of the blocks, in pixels; the largest is the whole image.</summary>
    public static readonly int[] Edges = [4, 16, 1 << 20];

    /// <summary>Compares two sets of independent images.</summary>
    public static BlockTest Compare(ImageSamples image, ImageSamples reference) =>
        Compare(image.Width, image.Height, image.Estimate, reference.Estimate);

    /// <summary>Compares two ways to estimate blocks.</summary>
    /// <param name="width">Width in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    /// <param name="image">Estimates a channel of a block of the image.</param>
    /// <param name="reference">Estimates a channel of a block of the reference.</param>
    public static BlockTest Compare(int width, int height, Func<Block, int, BlockEstimate> image, Func<Block, int, BlockEstimate> reference)
    {
        double smallest = double.PositiveInfinity;
        (Block Block, int Channel, BlockEstimate Image, BlockEstimate Reference) worst = default;
        int tests = 0;
        foreach (Block block in Edges.SelectMany(edge => Block.Cut(width, height, edge)).Distinct())
        {
            for (int channel = 0; channel < 3; channel++)
            {
                BlockEstimate a = image(block, channel);
                BlockEstimate b = reference(block, channel);
                double p = Welch(a, b);
                tests++;
                if (!(p >= smallest))
                {
                    smallest = p;
                    worst = (block, channel, a, b);
                }
            }
        }

        return new(Math.Min(1, smallest * tests), worst.Block, worst.Channel, worst.Image, worst.Reference);
    }

    /// <summary>p-value of the difference of two means of unequal variances, beyond what rounding explains; NaN is 0.</summary>
    public static double Welch(in BlockEstimate a, in BlockEstimate b)
    {
        double off = Math.Abs(a.Mean - b.Mean) - AbsoluteTolerance - (RelativeTolerance * Math.Abs(b.Mean));
        double variance = a.Variance + b.Variance;
        if (off <= 0)
        {
            return 1;
        }

        if (!(variance > 0))
        {
            return 0;
        }

        double freedom = variance * variance / ((a.Variance * a.Variance / a.Freedom) + (b.Variance * b.Variance / b.Freedom));
        double p = PValues.StudentT(off / Math.Sqrt(variance), freedom);
        return double.IsNaN(p) ? 0 : p;
    }

    /// <summary>What differs most, for messages.</summary>
    public override string ToString() => string.Create(
        CultureInfo.InvariantCulture,
        $"p = {P:G3}; worst: {"red green blue".Split(' ')[Channel]} of the {Worst.Width}×{Worst.Height} block at {Worst.X},{Worst.Y}: {Image.Mean:G7} ± {Math.Sqrt(Image.Variance):G2}, reference {Reference.Mean:G7} ± {Math.Sqrt(Reference.Variance):G2}");
}
