using System.Globalization;
using RayTracer.Imaging;

namespace RayTracer.RenderTests.References;

/// <summary>Renders of a scene beside the image of the other renderer.</summary>
/// <param name="Name">Name of the scene, and which bound of the truth the images are where they are one.</param>
/// <param name="Images">The renders.</param>
/// <param name="Reference">Estimates a channel of a block of what their expectation should be.</param>
public sealed record ReferenceComparison(string Name, ImageSamples Images, Func<Block, int, BlockEstimate> Reference)
{
    private const int Seeds = 32;

    /// <summary>
    /// Reads the image of a scene and its variance. The other renderer drew the samples of each pixel independently of all other pixels
    /// and filtered them with a box as wide as a pixel, so errors of pixels are independent; each variance is that of the mean of
    /// 32 images, estimated from their spread.
    /// </summary>
    /// <param name="folder">The folder of the references.</param>
    /// <param name="name">Name of the scene.</param>
    public static ReferenceMoments Read(string folder, string name) => new(
        ImageFile.Read(Path.Combine(folder, "images", $"{name}.pfm")),
        ImageFile.Read(Path.Combine(folder, "images", $"{name}.variance.pfm")),
        Seeds - 1);

    /// <summary>
    /// What is compared of a case. Images that are an exact estimate must have the expectation of the reference. Lower bounds must not
    /// lie above it: where they lie below, the reference is taken to be as they are, and p is 1. Upper bounds the other way round.
    /// </summary>
    public static IReadOnlyList<ReferenceComparison> Of(ReferenceRenders renders, ReferenceMoments reference)
    {
        ImageSamples lower = renders.Lower;
        if (renders.Upper is not { } upper)
        {
            return [new(renders.Name, lower, reference.Estimate)];
        }

        return
        [
            new($"{renders.Name}, lower bound", lower, (block, channel) => Bounded(lower, block, channel, Math.Min)),
            new($"{renders.Name}, upper bound", upper, (block, channel) => Bounded(upper, block, channel, Math.Max)),
        ];

        BlockEstimate Bounded(ImageSamples images, Block block, int channel, Func<double, double, double> bound)
        {
            BlockEstimate estimate = reference.Estimate(block, channel);
            return estimate with { Mean = bound(estimate.Mean, images.Estimate(block, channel).Mean) };
        }
    }

    /// <summary>Tests blocks of all sizes.</summary>
    public BlockTest Test() => BlockTest.Compare(Images.Width, Images.Height, Images.Estimate, Reference);

    /// <summary>For whom a failure makes look closer: ratio and z of the image means, and the root mean square of z over single pixels.</summary>
    public string Describe()
    {
        Block all = new(0, 0, Images.Width, Images.Height);
        double ratio = Enumerable.Range(0, 3).Average(c => Images.Estimate(all, c).Mean / Reference(all, c).Mean);
        double[] noisy =
        [
            .. from pixel in Block.Cut(Images.Width, Images.Height, 1)
               from channel in Enumerable.Range(0, 3)
               where Reference(pixel, channel).Variance > BlockTest.AbsoluteTolerance * BlockTest.AbsoluteTolerance
               select Z(pixel, channel),
        ];
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{Name}: ratio of means {ratio:F5}, z {Z(all, 0):F2} {Z(all, 1):F2} {Z(all, 2):F2}; rms z of {noisy.Length} noisy values of pixels {Math.Sqrt(noisy.Average(z => z * z)):F3}");
    }

    private double Z(Block block, int channel)
    {
        BlockEstimate a = Images.Estimate(block, channel);
        BlockEstimate b = Reference(block, channel);
        double off = a.Mean - b.Mean;
        double rounding = BlockTest.AbsoluteTolerance + (BlockTest.RelativeTolerance * Math.Abs(b.Mean));
        return Math.Abs(off) <= rounding ? 0 : (off - Math.CopySign(rounding, off)) / Math.Sqrt(a.Variance + b.Variance);
    }
}
