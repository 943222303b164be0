namespace RayTracer.Session;

/// <summary>
/// All that a user works with, whatever shows it: plain data, methods that never wait for the renderer, and one counter of changes.
/// </summary>
public sealed class StudioSession : IDisposable
{
    /// <summary>Starts a session.</summary>
    public StudioSession()
    {
        Jobs = new(Notices);
        Notices.Changed += (_, _) => Changes.Advance();
        Jobs.Changed += (_, _) => Changes.Advance();
    }

    /// <summary>Counts the changes of all that the user sees but the picture.</summary>
    public ChangeCounter Changes { get; } = new();

    /// <summary>What there is to tell the user.</summary>
    public NoticeBoard Notices { get; } = new();

    /// <summary>What is being done beside the user's work.</summary>
    public JobList Jobs { get; }

    /// <summary>Ends all work.</summary>
    public void Dispose() => Jobs.Dispose();
}
