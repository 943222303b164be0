namespace RayTracer.Session;

/// <summary>What is to be shown about a document beside its text.</summary>
/// <param name="Revision">The text's revision.</param>
/// <param name="Name">What the document is called.</param>
/// <param name="Path">The whole path of its file; null where it has none yet.</param>
/// <param name="IsDirty">Whether there are changes that were not saved.</param>
/// <param name="CanUndo">Whether there is a step to undo.</param>
/// <param name="CanRedo">Whether there is a step to do again.</param>
/// <param name="UndoLabel">What the step to undo changed; null where there is none.</param>
/// <param name="RedoLabel">What the step to do again changed; null where there is none.</param>
/// <param name="Diagnostics">What is wrong with the text that was built last.</param>
/// <param name="IsGood">Whether a scene could be built from that text.</param>
/// <param name="BuiltRevision">The revision of that text: that of the text itself once it is built.</param>
public sealed record DocumentStatus(
    int Revision, string Name, string? Path, bool IsDirty, bool CanUndo, bool CanRedo, string? UndoLabel, string? RedoLabel,
    IReadOnlyList<PlacedDiagnostic> Diagnostics, bool IsGood, int BuiltRevision);
