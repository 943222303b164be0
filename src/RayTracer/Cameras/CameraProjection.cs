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
        (float wholeWidth, float wholeHeight, float middleX, float middleY) = Whole(camera.Window, width, height);
        float extent = ViewPlane.Extent(camera.FieldOfViewAxis, wholeWidth, wholeHeight);
        switch (camera.Projection)
        {
            case Projection.Orthographic:
                return new OrthographicProjection(camera.Position, forward * focus, right, up, camera.ViewSize / extent, middleX, middleY);
            case Projection.Spherical:
                return new SphericalProjection(camera.Position, forward, right, up, width, height);
            default:
                float pixel = 2 * focus * LaneMath.Tan(camera.FieldOfView * (float.Pi / 360)) / extent;
                return new PerspectiveProjection(camera.Position, forward * focus, right, up, pixel, middleX, middleY);
        }
    }

    // The size of the whole of which a window is seen, in the pixels of the window, and where its middle is from the window's upper left corner.
    private static (float Width, float Height, float MiddleX, float MiddleY) Whole(IReadOnlyList<float> window, int width, int height)
    {
        if (window.Count != 4)
        {
            return (width, height, 0.5f * width, 0.5f * height);
        }

        (float wholeWidth, float wholeHeight) = (width / window[2], height / window[3]);
        return (wholeWidth, wholeHeight, (0.5f - window[0]) * wholeWidth, (0.5f - window[1]) * wholeHeight);
    }

    /// <summary>The rays through points of the picture.</summary>
    /// <param name="x">Columns, in pixels from the left edge.</param>
    /// <param name="y">Rows, in pixels from the top edge.</param>
    /// <param name="origin">Where they start.</param>
    /// <param name="toFocus">From there to the point in focus that they pass.</param>
    public abstract void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus);
}
