using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>How the camera projects, for whoever draws over the picture.</summary>
/// <param name="Position">Where the eye is.</param>
/// <param name="Right">Unit direction to the right in the picture.</param>
/// <param name="Up">Unit direction up in the picture.</param>
/// <param name="Forward">Unit viewing direction.</param>
/// <param name="FieldOfView">Angle over the picture's height, in degrees.</param>
/// <param name="Width">Width of the picture in pixels.</param>
/// <param name="Height">Height of the picture in pixels.</param>
public sealed record CameraFrame(Vector3 Position, Vector3 Right, Vector3 Up, Vector3 Forward, float FieldOfView, int Width, int Height)
{
    /// <summary>The point that the middle of the picture shows.</summary>
    public Vector3 LookAt { get; init; }

    /// <summary>That of a scene. What moves the camera besides is left out.</summary>
    public static CameraFrame Of(ShownScene shown)
    {
        (Vector3 right, Vector3 up, Vector3 forward) = CameraMotion.Axes(shown.Camera);
        float degrees = LaneMath.Atan2(CameraMotion.HeightAt(shown.Camera, 1, shown.Aspect) / 2, 1) * (360 / float.Pi);
        return new(shown.Camera.Position, right, up, forward, degrees, shown.Scene.Render.Width, shown.Scene.Render.Height) { LookAt = shown.Camera.LookAt };
    }
}
