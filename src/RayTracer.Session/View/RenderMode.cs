namespace RayTracer.Session;

/// <summary>Whether rendering goes on.</summary>
public enum RenderMode
{
    /// <summary>It goes on to the last sample.</summary>
    Running,

    /// <summary>It waits, and may go on.</summary>
    Paused,

    /// <summary>It has been ended by the user.</summary>
    Stopped,
}
