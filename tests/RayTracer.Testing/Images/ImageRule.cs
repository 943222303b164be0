using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>When an image counts as equal to its reference.</summary>
public abstract record ImageRule
{
    /// <summary>Every value has the same bits.</summary>
    public static ImageRule Exact { get; } = new ExactRule();

    /// <summary>Every channel of every pixel is near its reference, but for a share of outliers.</summary>
    /// <param name="absolute">Largest difference, in units of linear light …</param>
    /// <param name="relative">… to which this part of the reference's absolute value is added.</param>
    /// <param name="outlierShare">Share of the pixels, 0 to 1, that may be further off. A NaN or an infinity is never forgiven unless the reference has the same.</param>
    public static ImageRule Within(double absolute, double relative = 0, double outlierShare = 0) => new ToleranceRule(absolute, relative, outlierShare);

    /// <summary>The image looks like its reference: the structural similarity of luma, and of each channel taken alone, is high.</summary>
    /// <param name="leastSsim">The least value, up to 1 for equal images; both sides must have at least 11 pixels.</param>
    public static ImageRule LooksLike(double leastSsim) => new SimilarityRule(leastSsim);

    /// <summary>Compares two images of one size.</summary>
    internal abstract ImageVerdict Judge(Picture image, Picture reference);
}

/// <summary>What a comparison came to.</summary>
/// <param name="Passes">Whether the images count as equal.</param>
/// <param name="Finding">What was found, in one line.</param>
/// <param name="Worst">Number of the worst pixel, from the top left, row by row.</param>
internal readonly record struct ImageVerdict(bool Passes, string Finding, int Worst);
