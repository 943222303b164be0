namespace RayTracer.Session;

/// <summary>All that a user sees of a session but the picture, the text and the outline.</summary>
/// <param name="Version">The number of changes that it has; what happens while it is read is reported again by the next one.</param>
/// <param name="Document">The document.</param>
/// <param name="Selection">The pointer of the thing that was selected last; null where there is none.</param>
/// <param name="Selected">The pointers of all selected things.</param>
/// <param name="Hidden">The pointers of the things that are left out of the view.</param>
/// <param name="Locked">The pointers of the things that cannot be picked or dragged in the picture.</param>
/// <param name="Render">The progress of the picture.</param>
/// <param name="Settings">The user's settings of the picture.</param>
/// <param name="Tone">The exposure and tone map of the screen.</param>
/// <param name="Stops">By how many stops the screen is brighter than the light, by the user or the picture.</param>
/// <param name="View">Through which camera the picture is seen.</param>
/// <param name="Snapshots">Earlier pictures, the oldest first.</param>
/// <param name="Recovery">Texts that were not saved.</param>
/// <param name="Notice">The newest message; null before there was one.</param>
/// <param name="Lights">The lights of the picture with factors on their light; null where they are not kept apart.</param>
/// <param name="Jobs">The jobs that run beside the user's work.</param>
public sealed record SessionState(
    long Version, DocumentStatus Document, string? Selection, IReadOnlyList<string> Selected, IReadOnlyList<string> Hidden, IReadOnlyList<string> Locked, RenderStatus Render, ViewSettings Settings, Tone Tone, float Stops, ViewStatus View, IReadOnlyList<Snapshot> Snapshots,
    IReadOnlyList<RecoveryEntry> Recovery, Notice? Notice, IReadOnlyList<MixedLight>? Lights, IReadOnlyList<Job> Jobs)
{
    /// <summary>The state of a session.</summary>
    public static SessionState Of(StudioSession session)
    {
        // The version first: what changes meanwhile is reported again.
        long version = session.Changes.Version;
        PictureView view = session.View;
        return new(
            version, session.Document.Status, session.Selection.Pointer, session.Selection.All, session.Document.Hidden, session.Document.Locked, view.Loop.Status, view.Settings, view.Tone, view.Stops,
            new(view.Shown is { } shown ? CameraPose.Of(shown.Camera) : null, view.IsSceneCamera, view.Shown?.Picture ?? 0, session.Bookmarks.All), session.Snapshots.All,
            session.Recovery.Entries, session.Notices.Newest, session.Mixer.Lights, session.Jobs.Running);
    }
}
