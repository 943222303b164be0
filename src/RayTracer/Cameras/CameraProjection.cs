using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>Maps points of the picture to rays, in the camera's own space: before it is placed, and through the middle of its lens.</summary>
internal abstract class CameraProjection
{
    /// <summary>The rays through points of the picture.</summary>
    /// <param name="x">Columns, in pixels from the left edge.</param>
    /// <param name="y">Rows, in pixels from the top edge.</param>
    /// <param name="origin">Where they start.</param>
    /// <param name="toFocus">From there to the point in focus that they pass.</param>
    public abstract void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus);
}
