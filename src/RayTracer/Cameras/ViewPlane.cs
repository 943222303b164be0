using RayTracer.Description;

namespace RayTracer.Cameras;

/// <summary>The part of a plane across the view that a picture shows.</summary>
internal static class ViewPlane
{
    /// <summary>The extent of a picture that a field of view measures.</summary>
    /// <param name="axis">Which extent.</param>
    /// <param name="width">Width of the picture, in any unit.</param>
    /// <param name="height">Height of the picture, in the same unit.</param>
    /// <returns>The extent in that unit.</returns>
    public static float Extent(FieldOfViewAxis axis, float width, float height) => axis switch
    {
        FieldOfViewAxis.Vertical => height,
        FieldOfViewAxis.Horizontal => width,
        FieldOfViewAxis.Smaller => float.Min(width, height),
        FieldOfViewAxis.Larger => float.Max(width, height),
        _ => (float)double.Sqrt(((double)width * width) + ((double)height * height)),
    };
}
