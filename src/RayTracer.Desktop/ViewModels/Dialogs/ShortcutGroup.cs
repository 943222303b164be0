namespace RayTracer.Desktop.ViewModels;

/// <summary>A part of the sheet of keys.</summary>
/// <param name="Title">What it is called.</param>
/// <param name="Rows">Its lines.</param>
internal sealed record ShortcutGroup(string Title, IReadOnlyList<ShortcutRow> Rows);
