namespace RayTracer.Textbook;

/// <summary>Makes the first ray of each path, and answers where in the picture a point is seen.</summary>
public interface ICamera
{
    /// <summary>A ray through a point of the picture, which was chosen uniformly within a pixel.</summary>
    /// <param name="x">Column, in pixels from the left edge.</param>
    /// <param name="y">Row, in pixels from the top edge.</param>
    /// <param name="sampler">Chooses the point of the lens.</param>
    Ray RayThrough(double x, double y, ISampler sampler);

    /// <summary>The way from a point of the scene into the camera, for paths that come from the lights; null where it is not seen.</summary>
    /// <param name="point">The point.</param>
    /// <param name="sampler">Chooses the point of the lens.</param>
    Sight? Find(Vector point, ISampler sampler);
}

/// <summary>The way from a point into the camera.</summary>
/// <param name="Eye">Where the ray meets the lens.</param>
/// <param name="X">Column, in pixels from the left edge.</param>
/// <param name="Y">Row, in pixels from the top edge.</param>
/// <param name="Density">How many rays of one that goes through each pixel pass the point, for a unit of area across them.</param>
public readonly record struct Sight(Vector Eye, double X, double Y, double Density);
