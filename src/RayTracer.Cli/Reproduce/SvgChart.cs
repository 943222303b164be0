using System.Xml.Linq;

namespace RayTracer.Cli.Reproduce;

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
    private const string Ink = "#222222";
    private const string GridColour = "#e2e2e2";
    private static readonly XNamespace Svg = "http://www.w3.org/2000/svg";

    /// <summary>Draws.</summary>
    /// <param name="panels">From left to right.</param>
    public static XDocument Draw(IReadOnlyList<ChartPanel> panels)
    {
        int width = PanelWidth * panels.Count;
        return new(new XElement(
            Svg + "svg",
            new XAttribute("width", width),
            new XAttribute("height", Height),
            new XAttribute("viewBox", $"0 0 {width} {Height}"),
            new XAttribute("font-family", "Helvetica, Arial, 'Liberation Sans', sans-serif"),
            new XAttribute("font-size", 13),
            Element("rect", ("width", width), ("height", Height), ("fill", "white")),
            panels.Select(Panel)));
    }

    private static XElement Panel(ChartPanel panel, int index)
    {
        ChartAxis x = new(panel.Series.Max(s => s.Points.Max(p => p.X)));
        ChartAxis y = new(panel.Series.Max(s => s.Points.Max(p => p.Y)));
        string clip = $"plot-{index}";
        return new(
            Svg + "g",
            new XAttribute("transform", $"translate({index * PanelWidth} 0)"),
            new XElement(Svg + "clipPath", new XAttribute("id", clip), Element("rect", ("x", Left), ("y", Top), ("width", Right - Left), ("height", Bottom - Top))),
            Text(panel.Title, (Left + Right) / 2, Top - 20, "middle", ("font-weight", "bold"), ("font-size", 15)),
            Axis(x, y, panel),
            panel.Series.Select(s => Curve(s, x, y, clip)),
            panel.Series.SelectMany(s => s.Points.Select(p => Point(X(p.X, x), Y(p.Y, y), s.Colour))),
            panel.Series.SelectMany(LegendEntry));
    }

    private static IEnumerable<XElement> Axis(ChartAxis x, ChartAxis y, ChartPanel panel)
    {
        for (int i = 0; i <= x.Count; i++)
        {
            double at = X(x.Step * i, x);
            yield return Line(at, Top, at, Bottom + 5, i == 0 ? Ink : GridColour);
            yield return Line(at, Bottom, at, Bottom + 5, Ink);
            yield return Text(x.Label(i), at, Bottom + 20, "middle");
        }

        for (int i = 0; i <= y.Count; i++)
        {
            double at = Y(y.Step * i, y);
            yield return Line(Left - 5, at, Right, at, i == 0 ? Ink : GridColour);
            yield return Line(Left - 5, at, Left, at, Ink);
            yield return Text(y.Label(i), Left - 9, at + 4.5, "end");
        }

        yield return Text(panel.XTitle, (Left + Right) / 2, Bottom + 44, "middle");
        int middle = (Top + Bottom) / 2;
        yield return Text(panel.YTitle, 20, middle, "middle", ("transform", $"rotate(-90 20 {middle})"));
    }

    private static XElement? Curve(ChartSeries series, ChartAxis x, ChartAxis y, string clip)
    {
        if (series.Fit is not { } fit)
        {
            return null;
        }

        double start = series.Points.Min(p => p.X);
        double step = (series.Points.Max(p => p.X) - start) / CurveSteps;
        IEnumerable<string> corners = Enumerable.Range(0, CurveSteps + 1).Select(i => start + (i * step)).Select(v => $"{X(v, x):0.##},{Y(fit.At(v), y):0.##}");
        return Element("polyline", ("points", string.Join(' ', corners)), ("fill", "none"), ("stroke", series.Colour), ("stroke-width", 1.5), ("clip-path", $"url(#{clip})"));
    }

    private static IEnumerable<XElement> LegendEntry(ChartSeries series, int index)
    {
        const int X = Left + 16;
        int y = Top + 18 + (20 * index);
        yield return Line(X, y, X + 26, y, series.Colour, 1.5);
        yield return Element("rect", ("x", X + 9.5), ("y", y - 3.5), ("width", 7), ("height", 7), ("rx", 3.5), ("fill", series.Colour));
        yield return Text(series.Name, X + 34, y + 4.5, "start");
    }

    private static double X(double value, ChartAxis axis) => Left + ((Right - Left) * value / axis.End);

    private static double Y(double value, ChartAxis axis) => Bottom - ((Bottom - Top) * value / axis.End);

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
