using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>
/// Moves cameras as hands do. Movements across the picture are fractions of its height, to the right and downwards. A camera with a
/// transform is moved in its local coordinates.
/// </summary>
public static class CameraMotion
{
    // A drag over the whole height turns by half a circle, and makes things four times as large.
    private const float DegreesOfHeight = 180;
    private const float DoublingsOfHeight = 2;

    // The nearest that the view comes to straight up and down, where right and left have no meaning.
    private const float LeastDegreesToPole = 0.5f;

    /// <summary>Turns the camera around a point; what is up stays.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="dx">To the right.</param>
    /// <param name="dy">Downwards.</param>
    /// <param name="pivot">The point; null for the one looked at.</param>
    public static CameraDescription Orbit(CameraDescription camera, float dx, float dy, Vector3? pivot = null)
    {
        Vector3 arm = camera.Position - camera.LookAt;
        Transform turn = Turn(camera, arm, -dx * DegreesOfHeight, -dy * DegreesOfHeight);
        Vector3 around = pivot ?? camera.LookAt;
        Vector3 lookAt = pivot is null ? camera.LookAt : around + turn.Vector(camera.LookAt - around);
        return camera with { LookAt = lookAt, Position = lookAt + Scaled(turn.Vector(arm), arm.Norm()) };
    }

    /// <summary>Turns the camera where it stands.</summary>
    public static CameraDescription Rotate(CameraDescription camera, float dx, float dy)
    {
        Vector3 view = camera.LookAt - camera.Position;
        float degrees = camera.Projection.DegreesOfHeight(camera);
        return camera with { LookAt = camera.Position + Scaled(Turn(camera, view, -dx * degrees, dy * degrees).Vector(view), view.Norm()) };
    }

    /// <summary>Moves the camera across its view, so that what lies in the distance of the point looked at goes with the hand.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="dx">To the right.</param>
    /// <param name="dy">Downwards.</param>
    /// <param name="aspect">Width of the picture over its height.</param>
    public static CameraDescription Pan(CameraDescription camera, float dx, float dy, float aspect)
    {
        (Vector3 right, Vector3 up, _) = Axes(camera);
        float height = HeightAt(camera, (camera.LookAt - camera.Position).Norm(), aspect);
        return Moved(camera, (right * (-dx * height)) + (up * (dy * height)));
    }

    /// <summary>Narrows the field of view (upwards) or widens it; the camera stays.</summary>
    /// <exception cref="SessionException">The camera sees everything.</exception>
    public static CameraDescription Zoom(CameraDescription camera, float dy) => camera.Projection.Zoomed(camera, Factor(dy))
        ?? throw new SessionException("This camera sees all directions: there is no field of view to change.");

    /// <summary>
    /// Moves the camera towards the point that it looks at (upwards) or away from it; it never gets there. Of an orthographic one, nearness
    /// is what it shows.
    /// </summary>
    public static CameraDescription Dolly(CameraDescription camera, float dy) => camera.Projection.IsParallel
        ? Zoom(camera, dy)
        : camera with { Position = camera.LookAt + ((camera.Position - camera.LookAt) * Factor(dy)) };

    /// <summary>Moves the camera, and the point that it looks at with it, to the right, downwards and forward.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="dx">To the right, in distances to the point looked at.</param>
    /// <param name="dy">Downwards.</param>
    /// <param name="dz">Forward.</param>
    public static CameraDescription Translate(CameraDescription camera, float dx, float dy, float dz)
    {
        (Vector3 right, Vector3 up, Vector3 forward) = Axes(camera);
        float distance = (camera.LookAt - camera.Position).Norm();
        return Moved(camera, ((right * dx) - (up * dy) + (forward * dz)) * distance);
    }

    /// <summary>Unit directions to the right, up and forward in the picture.</summary>
    public static (Vector3 Right, Vector3 Up, Vector3 Forward) Axes(CameraDescription camera)
    {
        Vector3 forward = (camera.LookAt - camera.Position).Unit();
        Vector3 right = forward.Cross(camera.Up).Unit();
        return (right, right.Cross(forward), forward);
    }

    /// <summary>The height of the part of a plane across the view that the picture shows.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="distance">The distance of the plane from the camera.</param>
    /// <param name="aspect">Width of the picture over its height.</param>
    public static float HeightAt(CameraDescription camera, float distance, float aspect) =>
        camera.Projection.HeightAt(camera, distance, aspect);

    private static CameraDescription Moved(CameraDescription camera, Vector3 by) =>
        camera with { Position = camera.Position + by, LookAt = camera.LookAt + by };

    private static float Factor(float dy) => LaneMath.Pow(2, dy * DoublingsOfHeight);

    private static Vector3 Scaled(Vector3 v, float length) => v * (length / v.Norm());

    // Turns an arm about what is up, and tilts it, but not over the pole.
    private static Transform Turn(CameraDescription camera, Vector3 arm, float aroundDegrees, float tiltDegrees)
    {
        Vector3 up = camera.Up.Unit();
        Vector3 across = up.Cross(arm).Unit();
        float toPole = LaneMath.Acos(float.Clamp(arm.Unit().Dot(up), -1, 1)) * (180 / float.Pi);
        float tilt = float.Clamp(toPole + tiltDegrees, LeastDegreesToPole, 180 - LeastDegreesToPole) - toPole;
        return Transform.Rotation(up, aroundDegrees) * Transform.Rotation(across, tilt);
    }
}
