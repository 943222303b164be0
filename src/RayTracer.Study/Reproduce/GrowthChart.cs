using System.Xml.Linq;

namespace RayTracer.Study;

/// <summary>The report's figure 6.6: time against samples a pixel, here and there.</summary>
internal static class GrowthChart
{
    /// <summary>
    /// The degree of the report's polynomials. Three points, which is what it has of scenes 1 and 3, determine no more than 2.
    /// </summary>
    public const int Degree = 3;

    private static readonly string[] Colours = ["#1f5fa8", "#c1440e", "#2e7d32"];

    /// <summary>Draws the chart.</summary>
    public static XDocument Draw(IReadOnlyList<ReproducedScene> scenes) => SvgChart.Draw(
    [
        Panel("This machine", scenes, s => s.Points),
        Panel($"The report ({ReportScene.Machine})", scenes, s => s.ReportPoints),
    ]);

    private static ChartPanel Panel(
        string title, IReadOnlyList<ReproducedScene> scenes, Func<ReproducedScene, IReadOnlyList<(double X, double Y)>> points)
    {
        IEnumerable<ChartSeries> series = scenes.Select(s =>
        {
            int degree = Math.Min(Degree, points(s).Count - 1);
            string name = $"scene {s.Scene.Number}, {(degree == Degree ? "cubic" : "parabola")}";
            return new ChartSeries(name, Colours[s.Scene.Number - 1], points(s), PolynomialFit.Of(degree, points(s)).At);
        });
        return new(title, "samples a pixel", "time in seconds", [.. series]);
    }
}
