using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>Projects many points into the picture of a camera in which straight lines are straight.</summary>
internal sealed class MovingCamera
{
    // The columns of the matrix that gives the places across and down, and the depth.
    private readonly Vector4 _x, _y, _z;
    private readonly Vector2 _middle;

    /// <summary>Takes a camera, and the size of the picture in pixels.</summary>
    public MovingCamera(CameraFrame frame, int width, int height)
    {
        LaneMath.SinCosTurn(frame.FieldOfView / 720, out float sin, out float cos);
        float focal = height / 2f * cos / sin;
        (Vector3 right, Vector3 down, Vector3 forward) = (frame.Right * focal, frame.Up * -focal, frame.Forward);
        Eye = frame.Position;
        (_x, _y, _z) = (new(right.X, down.X, forward.X, 0), new(right.Y, down.Y, forward.Y, 0), new(right.Z, down.Z, forward.Z, 0));
        _middle = new(width / 2f, height / 2f);
    }

    /// <summary>Returns whether it sees everything where another does.</summary>
    public bool IsAt(MovingCamera other) =>
        (Eye, _x, _y, _z, _middle) == (other.Eye, other._x, other._y, other._z, other._middle);

    /// <summary>The position.</summary>
    public Vector3 Eye { get; }

    /// <summary>The position of a point in the picture, in pixels; false behind the eye.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryProject(Vector3 point, out Vector2 place)
    {
        Vector3 away = point - Eye;
        Vector4 seen = (_x * away.X) + (_y * away.Y) + (_z * away.Z);
        place = _middle + (seen.AsVector2() / seen.Z);
        return seen.Z > 1e-6f;
    }
}
