using System.Numerics;
using RayTracer.Description;

namespace RayTracer.Session;

/// <summary>What of a camera changes when a user looks around.</summary>
/// <param name="Position">The position of the eye.</param>
/// <param name="LookAt">The point looked at.</param>
/// <param name="Up">The upward direction.</param>
/// <param name="FieldOfView">The field of view in degrees.</param>
/// <param name="ViewSize">The extent that an orthographic camera shows.</param>
public sealed record CameraPose(Vector3 Position, Vector3 LookAt, Vector3 Up, float FieldOfView, float ViewSize)
{
    /// <summary>That of a camera.</summary>
    public static CameraPose Of(CameraDescription camera) => new(camera.Position, camera.LookAt, camera.Up, camera.FieldOfView, camera.ViewSize);

    /// <summary>A camera in this pose.</summary>
    public CameraDescription On(CameraDescription camera) => camera with
    {
        Position = Position,
        LookAt = LookAt,
        Up = Up,
        FieldOfView = FieldOfView,
        ViewSize = ViewSize,
    };
}

/// <summary>
/// The camera that the picture is seen through: the scene's, or one of the user's beside it, which no text knows. The user's ends when the
/// scene's is put somewhere else, so that a change of it is always seen; its lens and projection are the scene's.
/// </summary>
internal sealed class ViewCamera
{
    private CameraPose? _own;
    private CameraPose? _scenes;

    /// <summary>The camera to look through.</summary>
    /// <param name="scenes">The scene's camera.</param>
    public CameraDescription Of(CameraDescription scenes)
    {
        _own = CameraPose.Of(scenes) == _scenes ? _own : null;
        return _own?.On(scenes) ?? scenes;
    }

    /// <summary>Looks through a camera of the user's.</summary>
    /// <param name="own">That camera; null for the scene's.</param>
    /// <param name="scenes">The scene's camera.</param>
    public void Set(CameraPose? own, CameraDescription scenes)
    {
        _scenes = CameraPose.Of(scenes);
        _own = own == _scenes ? null : own;
    }

    /// <summary>The user's camera as it is now, to return to.</summary>
    public CameraPose? Own => _own;
}
