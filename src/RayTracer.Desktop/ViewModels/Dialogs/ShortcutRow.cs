namespace RayTracer.Desktop.ViewModels;

/// <summary>A line of the sheet of keys.</summary>
/// <param name="What">What happens.</param>
/// <param name="Keys">By which keys or gesture.</param>
internal sealed record ShortcutRow(string What, string Keys);
