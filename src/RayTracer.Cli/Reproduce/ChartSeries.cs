namespace RayTracer.Cli.Reproduce;

/// <summary>Points of a chart, and the curve through them.</summary>
/// <param name="Name">For the legend.</param>
/// <param name="Colour">As in CSS.</param>
/// <param name="Points">The points; neither coordinate is negative, nor zero on logarithmic axes.</param>
/// <param name="Fit">The curve; null for none.</param>
internal sealed record ChartSeries(string Name, string Colour, IReadOnlyList<(double X, double Y)> Points, Func<double, double>? Fit);
