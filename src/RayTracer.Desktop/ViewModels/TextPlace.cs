namespace RayTracer.Desktop.ViewModels;

/// <summary>A part of a text.</summary>
/// <param name="From">Offset of its first character.</param>
/// <param name="To">Offset behind its last character.</param>
internal sealed record TextPlace(int From, int To);
