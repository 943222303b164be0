namespace RayTracer.Session;

/// <summary>What one press of undo takes back.</summary>
/// <param name="Change">The change of the text.</param>
/// <param name="Label">What was changed, in a word or two.</param>
/// <param name="Gesture">The drag or the burst of typing that it came from; null where it stands alone.</param>
public sealed record UndoStep(TextChange Change, string Label, string? Gesture);
