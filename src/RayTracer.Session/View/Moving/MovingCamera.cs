using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>Projects many points into the picture of a camera in which straight lines are straight.</summary>
internal sealed class MovingCamera
{
    private readonly Vector3 _right, _up, _forward;
    private readonly Vector2 _middle;

    /// <summary>Takes a camera, and the size of the picture in pixels.</summary>
    public MovingCamera(CameraFrame frame, int width, int height)
    {
        LaneMath.SinCosTurn(frame.FieldOfView / 720, out float sin, out float cos);
        float focal = height / 2f * cos / sin;
        (Eye, _right, _up, _forward) = (frame.Position, frame.Right * focal, frame.Up * -focal, frame.Forward);
        _middle = new(width / 2f, height / 2f);
    }

    /// <summary>Returns whether it sees everything where another does.</summary>
    public bool IsAt(MovingCamera other) =>
        (Eye, _right, _up, _forward, _middle) == (other.Eye, other._right, other._up, other._forward, other._middle);

    /// <summary>The position.</summary>
    public Vector3 Eye { get; }

    /// <summary>The position of a point in the picture, in pixels; false behind the eye.</summary>
    public bool TryProject(Vector3 point, out Vector2 place)
    {
        Vector3 away = point - Eye;
        float depth = Vector3.Dot(away, _forward);
        place = _middle + (new Vector2(Vector3.Dot(away, _right), Vector3.Dot(away, _up)) / depth);
        return depth > 1e-6f;
    }
}
