namespace RayTracer.Rendering;

/// <summary>What is known of a pixel besides its light ("arbitrary output variables"), of the first surface that camera rays meet.</summary>
public enum Aov
{
    /// <summary>Distance along the camera ray, in scene units: mean over the samples that meet something, infinite where none does.</summary>
    Depth,

    /// <summary>Unit normal with which the surface is shaded, in the world and on the ray's side: mean over all samples, zero where they meet nothing.</summary>
    Normal,

    /// <summary>Fraction of the light that the surface sends on (<see cref="Materials.Material.Albedo"/>): mean over all samples, zero where they meet nothing.</summary>
    Albedo,

    /// <summary>Surface coordinates: mean over the samples that meet something, zero where none does.</summary>
    Uv,

    /// <summary>Number, from 1, of the shape or triangle that the pixel's first sample meets; 0 where it meets nothing.</summary>
    Primitive,

    /// <summary>Nodes visited and triangles tested to find what a ray meets, one ray by itself: mean over all samples.</summary>
    BvhCost,

    /// <summary>Number of samples in the pixel's sums of light.</summary>
    Samples,
}
