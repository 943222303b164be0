namespace RayTracer.Desktop.ViewModels;

/// <summary>A number at an axis of a plot.</summary>
/// <param name="Text">The number.</param>
/// <param name="X">Where, from the left.</param>
/// <param name="Y">Where, from the top.</param>
internal sealed record PlotTick(string Text, double X, double Y);
