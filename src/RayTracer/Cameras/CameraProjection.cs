using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>
/// Maps points of the picture to rays, in the camera's own space: before it is placed, and through the middle of its lens.
/// </summary>
public abstract class CameraProjection
{
    /// <summary>The rays through points of the picture.</summary>
    /// <param name="x">Columns, in pixels from the left edge.</param>
    /// <param name="y">Rows, in pixels from the top edge.</param>
    /// <param name="origin">The points from which they start.</param>
    /// <param name="toFocus">From there to the point in focus that they pass.</param>
    public abstract void Rays(in FloatW x, in FloatW y, out Vec3W origin, out Vec3W toFocus);
}

/// <summary>A camera and its picture.</summary>
/// <param name="Camera">The camera.</param>
/// <param name="Forward">Unit viewing direction.</param>
/// <param name="Right">Unit direction to the right in the picture.</param>
/// <param name="Up">Unit direction upwards in the picture.</param>
/// <param name="Width">Width of the picture in pixels.</param>
/// <param name="Height">Height of the picture in pixels.</param>
public readonly record struct CameraView(CameraDescription Camera, Vector3 Forward, Vector3 Right, Vector3 Up, int Width, int Height)
{
    /// <summary>The distance of the plane in focus.</summary>
    public float Focus => Camera.Lens.FocusDistance > 0 ? Camera.Lens.FocusDistance : (Camera.LookAt - Camera.Position).Dot(Forward);

    /// <summary>The upper left corner of the picture on a plane across the view, and the steps from pixel to pixel there.</summary>
    /// <param name="middle">The point of the plane in the viewing direction.</param>
    /// <param name="shown">The part of the plane that is shown by the extent of the whole picture that the field of view measures.</param>
    public (Vector3 Corner, Vector3 StepX, Vector3 StepY) OnPlane(Vector3 middle, float shown)
    {
        (float width, float height, float middleX, float middleY) = Whole;
        float pixel = shown / ViewPlane.Extent(Camera.FieldOfViewAxis, width, height);
        (Vector3 stepX, Vector3 stepY) = (Right * pixel, Up * -pixel);
        return (middle - stepX * middleX - stepY * middleY, stepX, stepY);
    }

    // The size of the whole of which a window is seen, in the pixels of the window, and where its middle is from the window's upper left
    // corner.
    private (float Width, float Height, float MiddleX, float MiddleY) Whole
    {
        get
        {
            if (Camera.Window is not [var x, var y, var width, var height])
            {
                return (Width, Height, 0.5f * Width, 0.5f * Height);
            }

            (float wholeWidth, float wholeHeight) = (Width / width, Height / height);
            return (wholeWidth, wholeHeight, (0.5f - x) * wholeWidth, (0.5f - y) * wholeHeight);
        }
    }
}
