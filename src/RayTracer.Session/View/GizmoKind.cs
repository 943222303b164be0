namespace RayTracer.Session;

/// <summary>What the handles around a thing do.</summary>
public enum GizmoKind
{
    /// <summary>Move it.</summary>
    Move,

    /// <summary>Turn it.</summary>
    Rotate,

    /// <summary>Change its size.</summary>
    Scale,
}
