using System.Numerics;

namespace RayTracer.Session;

/// <summary>The movement of a camera by the user.</summary>
/// <param name="Kind">The kind of movement.</param>
/// <param name="Dx">To the right, in heights of the picture.</param>
/// <param name="Dy">Downwards.</param>
/// <param name="Dz">Forward.</param>
/// <param name="Gesture">Of which gesture it is a part.</param>
/// <param name="End">True if the gesture ends with it.</param>
/// <param name="Position">For <see cref="CameraMoveKind.Set"/>: the position of the eye; null leaves it.</param>
/// <param name="LookAt">For <see cref="CameraMoveKind.Set"/>: the point looked at; null leaves it.</param>
/// <param name="Up">For <see cref="CameraMoveKind.Set"/>: the upward direction; null leaves it.</param>
/// <param name="FieldOfView">For <see cref="CameraMoveKind.Set"/>: the field of view in degrees; null leaves it.</param>
/// <param name="Around">
/// For <see cref="CameraMoveKind.Orbit"/>: the pixel where the gesture began; what is seen there is turned around. Null for the point
/// looked at.
/// </param>
/// <param name="Pointer">For <see cref="CameraMoveKind.Frame"/>: the thing that is to fill the picture; null for all.</param>
public sealed record CameraMove(
    CameraMoveKind Kind, float Dx = 0, float Dy = 0, float Dz = 0, string? Gesture = null, bool End = false,
    Vector3? Position = null, Vector3? LookAt = null, Vector3? Up = null, float? FieldOfView = null, Vector2? Around = null, string? Pointer = null);

/// <summary>The kinds of camera movements; see <see cref="CameraMotion"/>.</summary>
public enum CameraMoveKind
{
    /// <summary>Around the point looked at.</summary>
    Orbit,

    /// <summary>Across the view.</summary>
    Pan,

    /// <summary>By the field of view.</summary>
    Zoom,

    /// <summary>Towards the point looked at.</summary>
    Dolly,

    /// <summary>Sideways, up and forward, with the point looked at.</summary>
    Translate,

    /// <summary>Turned where it stands.</summary>
    Rotate,

    /// <summary>Put somewhere.</summary>
    Set,

    /// <summary>To the scene's own camera.</summary>
    Home,

    /// <summary>So that a thing fills the picture.</summary>
    Frame,

    /// <summary>To where the point looked at is seen from a direction, (Dx, Dy, Dz) in the world, at the same distance.</summary>
    Along,
}
