using System.Xml.Linq;

namespace RayTracer.Study;

/// <summary>Draws panels side by side as SVG.</summary>
internal static class SvgChart
{
    private const int PanelWidth = 520;
    private const int Height = 420;
    private const int Left = 78;
    private const int Right = PanelWidth - 22;
    private const int Top = 48;
    private const int Bottom = Height - 62;
    private const int CurveSteps = 100;
    private const int LegendWidth = 130;
    private const string Ink = "#222222";
    private const string GridColour = "#e2e2e2";
    private static readonly XNamespace Svg = "http://www.w3.org/2000/svg";

    /// <summary>Draws.</summary>
    /// <param name="panels">From left to right.</param>
    public static XDocument Draw(IReadOnlyList<ChartPanel> panels)
    {
        int width = panels.Sum(WidthOf);
        return new(new XElement(
            Svg + "svg",
            new XAttribute("width", width),
            new XAttribute("height", Height),
            new XAttribute("viewBox", $"0 0 {width} {Height}"),
            new XAttribute("font-family", "Helvetica, Arial, 'Liberation Sans', sans-serif"),
            new XAttribute("font-size", 13),
            Element("rect", ("width", width), ("height", Height), ("fill", "white")),
            panels.Select((p, i) => Panel(p, i, panels.Take(i).Sum(WidthOf)))));
    }

    private static int WidthOf(ChartPanel panel) => PanelWidth + (panel.HasLegendAside ? LegendWidth : 0);

    private static XElement Panel(ChartPanel panel, int index, int left)
    {
        IChartAxis x = Axis(panel, p => p.X);
        IChartAxis y = Axis(panel, p => p.Y);
        string clip = $"plot-{index}";
        return new(
            Svg + "g",
            new XAttribute("transform", $"translate({left} 0)"),
            new XElement(Svg + "clipPath", new XAttribute("id", clip), Element("rect", ("x", Left), ("y", Top), ("width", Right - Left), ("height", Bottom - Top))),
            Text(panel.Title, (Left + Right) / 2, Top - 20, "middle", ("font-weight", "bold"), ("font-size", 15)),
            Axes(x, y, panel),
            panel.Series.Select(s => Curve(s, x, y, clip)),
            panel.Series.SelectMany(s => s.Points.Select(p => Point(X(p.X, x), Y(p.Y, y), s.Colour))),
            panel.Series.SelectMany((s, i) => LegendEntry(s, i, panel.HasLegendAside ? Right : Left)));
    }

    private static IChartAxis Axis(ChartPanel panel, Func<(double X, double Y), double> coordinate)
    {
        double[] values = [.. panel.Series.SelectMany(s => s.Points).Select(coordinate)];
        return panel.IsLogarithmic ? new LogarithmicAxis(values.Min(), values.Max()) : new ChartAxis(values.Max());
    }

    private static IEnumerable<XElement> Axes(IChartAxis x, IChartAxis y, ChartPanel panel)
    {
        foreach ((double value, string label) in x.Ticks)
        {
            double at = X(value, x);
            yield return Line(at, Top, at, Bottom + 5, at <= Left ? Ink : GridColour);
            yield return Line(at, Bottom, at, Bottom + 5, Ink);
            yield return Text(label, at, Bottom + 20, "middle");
        }

        foreach ((double value, string label) in y.Ticks)
        {
            double at = Y(value, y);
            yield return Line(Left - 5, at, Right, at, at >= Bottom ? Ink : GridColour);
            yield return Line(Left - 5, at, Left, at, Ink);
            yield return Text(label, Left - 9, at + 4.5, "end");
        }

        yield return Text(panel.XTitle, (Left + Right) / 2, Bottom + 44, "middle");
        int middle = (Top + Bottom) / 2;
        yield return Text(panel.YTitle, 20, middle, "middle", ("transform", $"rotate(-90 20 {middle})"));
    }

    private static XElement? Curve(ChartSeries series, IChartAxis x, IChartAxis y, string clip)
    {
        IEnumerable<(double X, double Y)>? corners = series.IsJoined ? series.Points : series.Fit is { } fit ? Fitted(fit, series, x) : null;
        return corners is null ? null : Element(
            "polyline",
            ("points", string.Join(' ', corners.Select(c => $"{X(c.X, x):0.##},{Y(c.Y, y):0.##}"))),
            ("fill", "none"),
            ("stroke", series.Colour),
            ("stroke-width", 1.5),
            ("clip-path", $"url(#{clip})"));
    }

    private static IEnumerable<(double X, double Y)> Fitted(Func<double, double> fit, ChartSeries series, IChartAxis x)
    {
        double start = x.Place(series.Points.Min(p => p.X));
        double step = (x.Place(series.Points.Max(p => p.X)) - start) / CurveSteps;
        return Enumerable.Range(0, CurveSteps + 1).Select(i => x.ValueAt(start + (i * step))).Select(v => (v, fit(v)));
    }

    private static IEnumerable<XElement> LegendEntry(ChartSeries series, int index, int left)
    {
        int x = left + 16;
        int y = Top + 18 + (20 * index);
        yield return Line(x, y, x + 26, y, series.Colour, 1.5);
        yield return Element("rect", ("x", x + 9.5), ("y", y - 3.5), ("width", 7), ("height", 7), ("rx", 3.5), ("fill", series.Colour));
        yield return Text(series.Name, x + 34, y + 4.5, "start");
    }

    private static double X(double value, IChartAxis axis) => Left + ((Right - Left) * axis.Place(value));

    private static double Y(double value, IChartAxis axis) => Bottom - ((Bottom - Top) * axis.Place(value));

    private static XElement Point(double x, double y, string colour) =>
        Element("circle", ("cx", Round(x)), ("cy", Round(y)), ("r", 3.5), ("fill", colour));

    private static XElement Line(double x1, double y1, double x2, double y2, string colour, double width = 1) =>
        Element("line", ("x1", Round(x1)), ("y1", Round(y1)), ("x2", Round(x2)), ("y2", Round(y2)), ("stroke", colour), ("stroke-width", width));

    private static XElement Text(string text, double x, double y, string anchor, params (string, object)[] more)
    {
        XElement element = Element("text", [("x", Round(x)), ("y", Round(y)), ("text-anchor", anchor), ("fill", Ink), .. more]);
        element.Value = text;
        return element;
    }

    private static XElement Element(string name, params (string Name, object Value)[] attributes) =>
        new(Svg + name, attributes.Select(a => new XAttribute(a.Name, a.Value)));

    private static double Round(double value) => Math.Round(value, 2);
}

/// <summary>A pair of axes with what is drawn between them.</summary>
/// <param name="Title">The subject.</param>
/// <param name="XTitle">The horizontal axis and its unit.</param>
/// <param name="YTitle">The vertical axis and its unit.</param>
/// <param name="Series">The curves; at least one point is not at zero in x, and one in y.</param>
/// <param name="IsLogarithmic">True if both axes are logarithmic.</param>
internal sealed record ChartPanel(
    string Title, string XTitle, string YTitle, IReadOnlyList<ChartSeries> Series, bool IsLogarithmic = false)
{
    /// <summary>True if the legend stands beside the axes: curves that fall leave no room for it above them.</summary>
    public bool HasLegendAside { get; init; }
}

/// <summary>Points of a chart, and the curve through them.</summary>
/// <param name="Name">For the legend.</param>
/// <param name="Colour">As in CSS.</param>
/// <param name="Points">The points; neither coordinate is negative, nor zero on logarithmic axes.</param>
/// <param name="Fit">The curve; null for none.</param>
internal sealed record ChartSeries(string Name, string Colour, IReadOnlyList<(double X, double Y)> Points, Func<double, double>? Fit)
{
    /// <summary>True if straight lines join the points, in the place of a curve.</summary>
    public bool IsJoined { get; init; }
}
