namespace RayTracer.Session;

/// <summary>How a camera is moved; see <see cref="CameraMotion"/>.</summary>
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
    Fly,

    /// <summary>Turned where it stands.</summary>
    Look,

    /// <summary>Put somewhere.</summary>
    Set,

    /// <summary>Back to where it was when the document was opened.</summary>
    Home,
}
