using System.Xml.Linq;
using RayTracer.Numerics;

namespace RayTracer.Labs;

/// <summary>Draws the cells of an area as SVG: what was counted, what was expected, and how far they are apart.</summary>
internal static class CellChart
{
    private const int Side = 260;
    private const int Gap = 30;
    private const int Top = 64;
    private static readonly XNamespace s_svg = "http://www.w3.org/2000/svg";

    /// <summary>Draws.</summary>
    /// <param name="title">The title.</param>
    /// <param name="x">The name of the first coordinate.</param>
    /// <param name="y">The name of the second coordinate.</param>
    /// <param name="cells">The cells.</param>
    /// <param name="observed">What was counted in each.</param>
    /// <param name="expected">What was expected in each.</param>
    /// <param name="residual">How far that is apart, in standard deviations.</param>
    public static XDocument Draw(
        string title, string x, string y, IReadOnlyList<Area> cells, IReadOnlyList<double> observed, IReadOnlyList<double> expected, Func<int, double> residual)
    {
        Area all = new(cells.Min(c => c.Left), cells.Max(c => c.Right), cells.Min(c => c.Low), cells.Max(c => c.High));
        double Density(IReadOnlyList<double> counts, int i) => counts[i] / (cells[i].Width * cells[i].Height);

        // The brightest are few; the square root lets the others be seen.
        double most = Math.Sqrt(Enumerable.Range(0, cells.Count).Max(i => Math.Max(Density(observed, i), Density(expected, i))));
        int width = (3 * Side) + (4 * Gap);
        return new(new XElement(
            s_svg + "svg", new XAttribute("width", width), new XAttribute("height", Top + Side + 56), new XAttribute("viewBox", $"0 0 {width} {Top + Side + 56}"),
            new XAttribute("font-family", "Helvetica, Arial, 'Liberation Sans', sans-serif"), new XAttribute("font-size", 13),
            Element("rect", ("width", width), ("height", Top + Side + 56), ("fill", "white")),
            Text(title, width / 2, 22, "middle"),
            Panel(0, "samples", i => Hex(HeatMap.Color(Math.Sqrt(Density(observed, i)) / most))),
            Panel(1, "expected", i => Hex(HeatMap.Color(Math.Sqrt(Density(expected, i)) / most))),
            Panel(2, "red: too many, blue: too few", i => Difference(residual(i)))));

        XElement Panel(int number, string name, Func<int, string> colour)
        {
            int left = Gap + (number * (Side + Gap));
            return new(
                s_svg + "g",
                Text(name, left + (Side / 2), Top - 12, "middle"),
                cells.Select((c, i) => Element(
                    "rect", ("x", Round(left + (Side * (c.Left - all.Left) / all.Width))), ("y", Round(Top + (Side * (all.High - c.High) / all.Height))),
                    ("width", Round((Side * c.Width / all.Width) + 0.3)), ("height", Round((Side * c.Height / all.Height) + 0.3)), ("fill", colour(i)))),
                Text($"{x}: {Fact.Text(all.Left)} to {Fact.Text(all.Right)}", left + (Side / 2), Top + Side + 20, "middle"),
                Text($"{y}, upwards: {Fact.Text(all.Low)} to {Fact.Text(all.High)}", left + (Side / 2), Top + Side + 40, "middle"));
        }
    }

    // White where both agree; six standard deviations have the full colour.
    private static string Difference(double deviations)
    {
        float rest = 1 - (float)Math.Min(1, Math.Abs(deviations) / Histogram.MostDeviations);
        return Hex(deviations > 0 ? new(1, rest, rest) : new(rest, rest, 1));
    }

    private static string Hex(Rgb color) => $"#{Byte(color.R):x2}{Byte(color.G):x2}{Byte(color.B):x2}";

    private static int Byte(float value) => (int)MathF.Round(255 * Math.Clamp(value, 0, 1));

    private static XElement Text(string text, double x, double y, string anchor)
    {
        XElement element = Element("text", ("x", Round(x)), ("y", Round(y)), ("text-anchor", anchor), ("fill", "#222222"));
        element.Value = text;
        return element;
    }

    private static XElement Element(string name, params (string Name, object Value)[] attributes) => new(s_svg + name, attributes.Select(a => new XAttribute(a.Name, a.Value)));

    private static double Round(double value) => Math.Round(value, 2);
}
