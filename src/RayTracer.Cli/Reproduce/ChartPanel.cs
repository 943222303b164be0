namespace RayTracer.Cli.Reproduce;

/// <summary>A pair of axes with what is drawn between them.</summary>
/// <param name="Title">What the panel shows.</param>
/// <param name="XTitle">The horizontal axis and its unit.</param>
/// <param name="YTitle">The vertical axis and its unit.</param>
/// <param name="Series">What is drawn; at least one point is not at zero in x, and one in y.</param>
/// <param name="IsLogarithmic">Whether both axes are logarithmic.</param>
internal sealed record ChartPanel(string Title, string XTitle, string YTitle, IReadOnlyList<ChartSeries> Series, bool IsLogarithmic = false);
