namespace RayTracer.Session;

/// <summary>What the view shows of the picture.</summary>
public enum ViewMap
{
    /// <summary>The light.</summary>
    Light,

    /// <summary>The light without most of its noise.</summary>
    Denoised,

    /// <summary>Number of samples in each pixel.</summary>
    Samples,

    /// <summary>Standard error of each pixel's luminance.</summary>
    Variance,

    /// <summary>Nodes and triangles that rays are tested against.</summary>
    BvhCost,

    /// <summary>Distance to the first surface.</summary>
    Depth,

    /// <summary>Shading normals of the first surface.</summary>
    Normal,

    /// <summary>Albedo of the first surface.</summary>
    Albedo,

    /// <summary>Surface coordinates of the first surface.</summary>
    Uv,

    /// <summary>A colour for each primitive.</summary>
    Primitive,
}
