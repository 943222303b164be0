using RayTracer.Imaging;

namespace RayTracer.Session;

/// <summary>How much two pictures differ.</summary>
/// <param name="Rmse">Root mean squared difference of linear light, as <c>raytracer compare</c> finds it for OpenEXR files of them.</param>
/// <param name="LargestDifference">The largest difference of a channel; it is white in the difference picture.</param>
/// <param name="LargestX">Column of the pixel that has it.</param>
/// <param name="LargestY">Its row.</param>
/// <param name="Flip">Mean FLIP error of what is shown, as <c>raytracer compare</c> finds it for PNG files of them.</param>
public sealed record PictureComparison(double Rmse, double LargestDifference, int LargestX, int LargestY, double Flip)
{
    internal FlipError? Errors { get; init; }
}

/// <summary>What is shown of two pictures.</summary>
public enum ComparisonMap
{
    /// <summary>The absolute difference of linear light, as bright as possible.</summary>
    Difference,

    /// <summary>The FLIP error of each pixel, from 0 to 1.</summary>
    Flip,
}
