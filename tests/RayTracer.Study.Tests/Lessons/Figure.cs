using System.Xml.Linq;

namespace RayTracer.Study.Tests.Lessons;

/// <summary>A drawing of a lesson as SVG, on a white ground, so that it can be read in light and dark windows. Lengths are in pixels from the upper left corner.</summary>
internal sealed class Figure
{
    public const string Ink = "#222222";
    public const string Faint = "#c4c4c4";
    public const string Blue = "#0072b2";
    public const string Red = "#d55e00";
    public const string Green = "#00795a";
    public const string Purple = "#a8457f";
    public const string Amber = "#e69f00";
    private static readonly XNamespace s_svg = "http://www.w3.org/2000/svg";
    private readonly XElement _root;

    /// <summary>An empty one.</summary>
    public Figure(int width, int height) => _root = new(
        s_svg + "svg",
        Attributes(("width", width), ("height", height), ("viewBox", $"0 0 {width} {height}"), ("font-family", "Helvetica, Arial, 'Liberation Sans', sans-serif"), ("font-size", 14)),
        new XElement(s_svg + "rect", Attributes(("width", width), ("height", height), ("rx", 6), ("fill", "#ffffff"))));

    /// <summary>The whole drawing.</summary>
    public XDocument Document => new(_root);

    public void Line((double X, double Y) from, (double X, double Y) to, string colour = Ink, double width = 1.5, string? dash = null) =>
        Add("line", ("x1", from.X), ("y1", from.Y), ("x2", to.X), ("y2", to.Y), ("stroke", colour), ("stroke-width", width), ("stroke-dasharray", dash));

    public void Arrow((double X, double Y) from, (double X, double Y) to, string colour = Ink, double width = 1.5)
    {
        Line(from, to, colour, width);
        double length = Math.Sqrt(Math.Pow(to.X - from.X, 2) + Math.Pow(to.Y - from.Y, 2));
        (double x, double y) = ((to.X - from.X) / length, (to.Y - from.Y) / length);
        Polygon([to, (to.X - (9 * x) - (4 * y), to.Y - (9 * y) + (4 * x)), (to.X - (9 * x) + (4 * y), to.Y - (9 * y) - (4 * x))], colour);
    }

    public void Circle((double X, double Y) centre, double radius, string? stroke = Ink, string fill = "none", double width = 1.5) =>
        Add("circle", ("cx", centre.X), ("cy", centre.Y), ("r", radius), ("stroke", stroke), ("stroke-width", stroke is null ? null : width), ("fill", fill));

    public void Dot((double X, double Y) centre, string colour = Ink, double radius = 3.5) => Circle(centre, radius, null, colour);

    public void Rectangle(double x, double y, double width, double height, string fill, string? stroke = null) =>
        Add("rect", ("x", x), ("y", y), ("width", width), ("height", height), ("fill", fill), ("stroke", stroke));

    public void Polyline(IEnumerable<(double X, double Y)> points, string colour, double width = 2, string? dash = null) =>
        Add("polyline", ("points", Joined(points)), ("fill", "none"), ("stroke", colour), ("stroke-width", width), ("stroke-dasharray", dash));

    public void Polygon(IEnumerable<(double X, double Y)> points, string fill, string? stroke = null, double opacity = 1) =>
        Add("polygon", ("points", Joined(points)), ("fill", fill), ("stroke", stroke), ("fill-opacity", opacity == 1 ? null : opacity));

    public void Text(string text, (double X, double Y) at, string anchor = "middle", string colour = Ink, bool isBold = false, double turn = 0) =>
        Add("text", ("x", at.X), ("y", at.Y), ("text-anchor", anchor), ("fill", colour), ("font-weight", isBold ? "bold" : null),
            ("transform", turn == 0 ? null : FormattableString.Invariant($"rotate({turn} {at.X} {at.Y})"))).Value = text;

    private static string Joined(IEnumerable<(double X, double Y)> points) => string.Join(' ', points.Select(p => FormattableString.Invariant($"{p.X:0.##},{p.Y:0.##}")));

    private XElement Add(string name, params (string Name, object? Value)[] attributes)
    {
        XElement element = new(s_svg + name, Attributes(attributes));
        _root.Add(element);
        return element;
    }

    private static IEnumerable<XAttribute> Attributes(params (string Name, object? Value)[] attributes) =>
        attributes.Where(a => a.Value is not null).Select(a => new XAttribute(a.Name, a.Value is double number ? Math.Round(number, 2) : a.Value!));
}
