using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>Maps points of the picture to rays, in the camera's own space: before it is placed, and through the middle of its lens.</summary>
internal abstract class CameraProjection
{
    /// <summary>Makes the projection that a description asks for.</summary>
    /// <param name="camera">The description.</param>
    /// <param name="forward">Unit viewing direction.</param>
    /// <param name="right">Unit direction to the right in the picture.</param>
    /// <param name="up">Unit direction upwards in the picture.</param>
    /// <param name="focus">Distance of the plane in focus.</param>
    /// <param name="width">Width of the picture in pixels.</param>
    /// <param name="height">Height of the picture in pixels.</param>
    public static CameraProjection Create(CameraDescription camera, Vector3 forward, Vector3 right, Vector3 up, float focus, int width, int height)
    {
        float extent = ViewPlane.Extent(camera.FieldOfViewAxis, width, height);
        switch (camera.Projection)
        {
            case Projection.Orthographic:
                return new OrthographicProjection(camera.Position, forward * focus, right, up, camera.ViewSize / extent, width, height);
            case Projection.Spherical:
                return new SphericalProjection(camera.Position, forward, right, up, width, height);
            default:
                float pixel = 2 * focus * LaneMath.Tan(camera.FieldOfView * (float.Pi / 360)) / extent;
                return new PerspectiveProjection(camera.Position, forward * focus, right, up, pixel, width, height);
        }
    }

    /// <summary>The rays through points of the picture.</summary>
    /// <param name="x">Columns, in pixels from the left edge.</param>
    /// <param name="y">Rows, in pixels from the top edge.</param>
    /// <param name="origin">Where they start.</param>
    /// <param name="toFocus">From there to the point in focus that they pass.</param>
    public abstract void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus);
}
