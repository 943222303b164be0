using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>The projection of the camera, for drawing over the picture.</summary>
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
    /// <exception cref="SessionException">Straight lines are not straight in the picture.</exception>
    public static CameraFrame Of(ViewportScene shown)
    {
        Projection kind = shown.Camera.Projection;
        if (!kind.IsStraight)
        {
            throw new SessionException("Lines and handles cannot be drawn over the picture of this camera, in which straight lines are bent.");
        }

        (Vector3 right, Vector3 up, Vector3 forward) = CameraMotion.Axes(shown.Camera);
        float height = CameraMotion.HeightAt(shown.Camera, 1, shown.Aspect);
        Vector3 position = kind.IsParallel ? shown.Camera.Position - (forward * (Far * height)) : shown.Camera.Position;
        float degrees = LaneMath.Atan2(kind.IsParallel ? 0.5f / Far : height / 2, 1) * (360 / float.Pi);
        return new(position, right, up, forward, degrees, shown.Scene.Render.Width, shown.Scene.Render.Height) { LookAt = shown.Camera.LookAt };
    }

    /// <summary>The position of a point of the world in the picture, in pixels; null behind the eye.</summary>
    public Vector2? Project(Vector3 point)
    {
        Vector3 away = point - Position;
        float depth = away.Dot(Forward);
        if (!(depth > 1e-6f))
        {
            return null;
        }

        float scale = FocalLength() / depth;
        return new((Width / 2f) + (away.Dot(Right) * scale), (Height / 2f) - (away.Dot(Up) * scale));
    }

    /// <summary>The unit direction from the eye through a point of the picture, in pixels.</summary>
    public Vector3 Through(Vector2 pixel)
    {
        float focal = FocalLength();
        return (Forward + (Right * ((pixel.X - (Width / 2f)) / focal)) + (Up * (((Height / 2f) - pixel.Y) / focal))).Unit();
    }

    /// <summary>The length that covers some pixels at a point.</summary>
    public float LengthOf(float pixels, Vector3 point) => pixels * MathF.Max(1e-3f, (point - Position).Dot(Forward)) / FocalLength();

    // The distance between eye and picture, in pixels.
    private float FocalLength()
    {
        LaneMath.SinCosTurn(FieldOfView / 720, out float sin, out float cos);
        return Height / 2f * cos / sin;
    }
}
