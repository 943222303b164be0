namespace RayTracer.Session;

/// <summary>A text that was not saved.</summary>
/// <param name="Name">What the document was called.</param>
/// <param name="Path">Its file; null where it had none.</param>
/// <param name="Folder">The folder from which the files that it names are looked for.</param>
/// <param name="LineEnd">What ends a line of its file.</param>
/// <param name="Time">When it was kept.</param>
/// <param name="Text">The text.</param>
public sealed record RecoveredText(string Name, string? Path, string Folder, string LineEnd, DateTime Time, string Text);
