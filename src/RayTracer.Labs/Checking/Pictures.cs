using System.Text;
using RayTracer.Imaging;
using RayTracer.Study;
using RayTracer.Textbook;
using RayTracer.Textures;

namespace RayTracer.Labs;

/// <summary>Makes pictures to look at.</summary>
public static class Pictures
{
    private const int Gap = 4;

    /// <summary>Pictures of one size, side by side.</summary>
    /// <param name="title">What they are.</param>
    /// <param name="width">Width of each in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    /// <param name="panels">The pictures, row by row.</param>
    public static Exhibit Of(string title, int width, int height, params IReadOnlyList<IReadOnlyList<Rgb>> panels)
    {
        Picture all = new((panels.Count * (width + Gap)) - Gap, height);
        Array.Fill(all.Pixels, 1);
        foreach ((IReadOnlyList<Rgb> pixels, int panel) in panels.Select((p, i) => (p, i)))
        {
            for (int i = 0; i < width * height; i++)
            {
                int at = 3 * ((i / width * all.Width) + (panel * (width + Gap)) + (i % width));
                (all.Pixels[at], all.Pixels[at + 1], all.Pixels[at + 2]) = ((float)pixels[i].R, (float)pixels[i].G, (float)pixels[i].B);
            }
        }

        return new(title, "png", ImageFile.Encode(".png", all, new()));
    }

    /// <summary>A picture, its reference, and how much they differ.</summary>
    /// <param name="title">What they are.</param>
    /// <param name="width">Width of each in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    /// <param name="found">The picture, row by row.</param>
    /// <param name="expected">The reference.</param>
    public static Exhibit Beside(string title, int width, int height, IReadOnlyList<Rgb> found, IReadOnlyList<Rgb> expected) =>
        Of(title, width, height, found, expected, [.. found.Zip(expected, (a, b) => a - b).Select(d => new Rgb(Math.Abs(d.R), Math.Abs(d.G), Math.Abs(d.B)))]);

    /// <summary>Points on logarithmic axes, joined by lines.</summary>
    /// <param name="title">What it shows.</param>
    /// <param name="x">The name of the axis to the right.</param>
    /// <param name="y">The name of the axis upwards.</param>
    /// <param name="curves">The curves, with names for the legend.</param>
    public static Exhibit Chart(string title, string x, string y, params IReadOnlyList<(string Name, (double X, double Y)[] Points)> curves)
    {
        string[] colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7"];
        ChartSeries[] series =
        [
            .. curves.Select((c, i) => new ChartSeries(c.Name, colours[i % colours.Length], [.. c.Points.Where(p => p.X > 0 && p.Y > 0 && double.IsFinite(p.Y))], Fit: null) { IsJoined = true }).Where(s => s.Points.Count > 0),
        ];
        string svg = series.Length == 0 ? "" : SvgChart.Draw([new(title, x, y, series, IsLogarithmic: true) { HasLegendAside = true }]).ToString();
        return new(title, "svg", Encoding.UTF8.GetBytes(svg));
    }
}
