using System.Xml.Linq;

namespace RayTracer.Study;

/// <summary>The errors of integrators against the time of rendering, as a chart.</summary>
internal static class ConvergenceChart
{
    // Those who see no red or green tell them apart too.
    private static readonly string[] s_colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];

    /// <summary>Draws the chart; null where no error is above 0.</summary>
    /// <param name="title">The subject.</param>
    /// <param name="curves">The errors.</param>
    public static XDocument? Draw(string title, IEnumerable<ErrorCurve> curves)
    {
        ChartSeries[] series = [.. curves.Select(SeriesOf).Where(s => s.Points.Count > 0)];
        return series.Length == 0 ? null : SvgChart.Draw(
            [new(title, "rendering time in seconds", "relative mean squared error", series, IsLogarithmic: true) { HasLegendAside = true }]);
    }

    private static ChartSeries SeriesOf(ErrorCurve curve, int index)
    {
        IEnumerable<(double X, double Y)> points = curve.Points.Select(p => (p.Seconds, p.Error.Trimmed)).Where(p => p.Trimmed > 0);
        return new(curve.Integrator.Name, s_colours[index % s_colours.Length], [.. points], Fit: null) { IsJoined = true };
    }
}
