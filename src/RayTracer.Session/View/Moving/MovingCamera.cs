using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>Projects many points into the picture of a camera in which straight lines are straight.</summary>
internal sealed class MovingCamera
{
    private const float Nearest = 1e-6f;

    // Products of these with what leads from the eye to a point give its place across and down, times the depth, and the depth.
    private readonly Vector3 _right, _down, _forward;
    private readonly Vector2 _middle;

    /// <summary>Takes a camera, and the size of the picture in pixels.</summary>
    public MovingCamera(CameraFrame frame, int width, int height)
    {
        LaneMath.SinCosTurn(frame.FieldOfView / 720, out float sin, out float cos);
        float focal = height / 2f * cos / sin;
        (Eye, _right, _down, _forward, _middle) = (frame.Position, frame.Right * focal, frame.Up * -focal, frame.Forward, new(width / 2f, height / 2f));
    }

    /// <summary>Returns whether it sees everything where another does.</summary>
    public bool IsAt(MovingCamera other) =>
        (Eye, _right, _down, _forward, _middle) == (other.Eye, other._right, other._down, other._forward, other._middle);

    /// <summary>The position.</summary>
    public Vector3 Eye { get; }

    /// <summary>The positions of points in the picture, in pixels; false behind the eye.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MaskW Project(in Vec3W points, out FloatW x, out FloatW y)
    {
        Vec3W away = points - Eye;
        FloatW depth = Vec3W.Dot(away, _forward);
        FloatW scale = 1f / depth;
        x = FloatW.MultiplyAdd(Vec3W.Dot(away, _right), scale, _middle.X);
        y = FloatW.MultiplyAdd(Vec3W.Dot(away, _down), scale, _middle.Y);
        return depth > Nearest;
    }
}
