using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>
/// A projection that also finds points of the scene in the picture: what light that starts at the lights needs to reach the camera.
/// As <see cref="CameraProjection.Rays"/>, it works in the camera's own space. A point of the lens moves the start of all rays by the
/// same vector, while each still passes its point in focus.
/// </summary>
public abstract class InvertibleProjection : CameraProjection
{
    /// <summary>
    /// The points of the picture whose rays pass given points of the scene. For a point behind the camera, any point of the picture, or NaN:
    /// the caller sees by the ray that it does not pass.
    /// </summary>
    /// <param name="point">The points of the scene.</param>
    /// <param name="shift">Points of the lens, relative to its middle.</param>
    /// <param name="x">Columns, in pixels from the left edge.</param>
    /// <param name="y">Rows, in pixels from the top edge.</param>
    public abstract void Find(in Vec3W point, in Vec3W shift, out FloatW x, out FloatW y);

    /// <summary>
    /// How dense rays are that belong to the same point of the lens, one for each pixel: rays per unit of area perpendicular to the ray.
    /// </summary>
    /// <param name="origin">The ray's origin on the lens.</param>
    /// <param name="direction">Its unit direction.</param>
    /// <param name="distance">The distance along the ray at which the density is asked for.</param>
    /// <param name="density">The density there.</param>
    public abstract void Density(in Vec3W origin, in Vec3W direction, in FloatW distance, out FloatW density);

    /// <summary>
    /// Takes points beyond an edge of the picture to the points within it that have the same rays, where there are such points; others stay.
    /// </summary>
    /// <param name="x">Columns, in pixels from the left edge.</param>
    /// <param name="y">Rows, in pixels from the top edge.</param>
    public virtual void Fold(ref FloatW x, ref FloatW y)
    {
    }
}
