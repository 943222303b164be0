using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>How the camera projects, for whoever draws over the picture.</summary>
/// <param name="Position">The position of the eye.</param>
/// <param name="Right">Unit direction to the right in the picture.</param>
/// <param name="Up">Unit direction up in the picture.</param>
/// <param name="Forward">Unit viewing direction.</param>
/// <param name="FieldOfView">Angle over the picture's height, in degrees.</param>
/// <param name="Width">Width of the picture in pixels.</param>
/// <param name="Height">Height of the picture in pixels.</param>
public sealed record CameraFrame(Vector3 Position, Vector3 Right, Vector3 Up, Vector3 Forward, float FieldOfView, int Width, int Height)
{
    /// <summary>The point shown in the middle of the picture.</summary>
    public Vector3 LookAt { get; init; }

    // How many picture heights away an eye stands for parallel rays.
    private const float Far = 3000;

    /// <summary>That of a scene. What moves the camera besides is left out; parallel rays come from an eye far behind.</summary>
    /// <exception cref="SessionException">The camera is spherical, where straight lines are not straight in the picture.</exception>
    public static CameraFrame Of(ShownScene shown)
    {
        if (shown.Camera.Projection == Projection.Spherical)
        {
            throw new SessionException("Lines and handles cannot be drawn over the picture of a spherical camera.");
        }

        bool isParallel = shown.Camera.Projection == Projection.Orthographic;
        (Vector3 right, Vector3 up, Vector3 forward) = CameraMotion.Axes(shown.Camera);
        float height = CameraMotion.HeightAt(shown.Camera, 1, shown.Aspect);
        Vector3 position = isParallel ? shown.Camera.Position - (forward * (Far * height)) : shown.Camera.Position;
        float degrees = LaneMath.Atan2(isParallel ? 0.5f / Far : height / 2, 1) * (360 / float.Pi);
        return new(position, right, up, forward, degrees, shown.Scene.Render.Width, shown.Scene.Render.Height) { LookAt = shown.Camera.LookAt };
    }
}
