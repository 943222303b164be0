using System.Xml.Linq;
using RayTracer.Imaging;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Spectra;
using RayTracer.Textbook;
using RayTracer.Textures;
using static RayTracer.Study.Tests.Lessons.Figure;
using Rgb = RayTracer.Textbook.Rgb;
using Transform = RayTracer.Textbook.Transform;

namespace RayTracer.Study.Tests.Lessons;

/// <summary>Drawings of the lessons on surfaces, surroundings, media, motion and colours.</summary>
internal static class LightFigures
{
    /// <summary>Lobes of a rough metal in the plane of incidence, each drawn to its largest value.</summary>
    public static XDocument Lobes()
    {
        Figure figure = new(660, 310);
        Vector viewer = Direction(-50);
        (double X, double Y) foot = (300, 270);
        (double, double) At(double degrees, double length) => (foot.X + (length * Math.Sin(degrees * Math.PI / 180)), foot.Y - (length * Math.Cos(degrees * Math.PI / 180)));
        figure.Line((40, 270), (620, 270), Ink, 2);
        figure.Line(foot, At(50, 250), Faint, 1.5, "5 4");
        figure.Text("mirror direction", At(50, 262), "start");
        figure.Line(foot, At(0, 240), Faint);
        figure.Text("n", At(0, 250));
        figure.Arrow(At(-50, 240), At(-50, 8), Ink, 1.5);
        figure.Text("light", At(-50, 255), "end");
        foreach ((double alpha, string colour, int i) in new[] { (0.1, Blue, 0), (0.3, Green, 1), (0.6, Red, 2) })
        {
            Ggx metal = new(new Solid(new Rgb(alpha)), new Reflectance(Rgb.Black, Rgb.Black, new Solid(Rgb.White)));
            double[] lobe = [.. Enumerable.Range(0, 361).Select(k => metal.Evaluate(default, viewer, Direction((k / 2.0) - 90)).R * Math.Cos(((k / 2.0) - 90) * Math.PI / 180))];
            figure.Polyline(lobe.Select((value, k) => At((k / 2.0) - 90, 210 * value / lobe.Max())), colour);
            figure.Line((30, 30 + (22 * i)), (52, 30 + (22 * i)), colour, 2);
            figure.Text(FormattableString.Invariant($"α = {alpha}, brightest at {(Array.IndexOf(lobe, lobe.Max()) / 2.0) - 90:0.#}°"), (58, 35 + (22 * i)), "start");
        }

        return figure.Document;
    }

    /// <summary>A picture of all directions, and directions that were chosen by its light.</summary>
    public static XDocument Environment()
    {
        const int Columns = 60;
        const int Rows = 30;
        const int Levels = 12;
        Figure figure = new(660, 350);
        Picture picture = ImageFile.Read(ProjectFolder.PathOf("scenes", "lights", "studio.hdr"));
        ImageEnvironment around = new(picture, 1, Transform.Identity);
        for (int row = 0; row < Rows; row++)
        {
            int Shade(int column) => (int)Math.Round(Levels * Math.Pow(Math.Min(1, around.Radiance(Along((column + 0.5) / Columns, (row + 0.5) / Rows)).Luminance / 4), 1 / 2.2));

            // Cells of one shade side by side are one rectangle.
            for (int column = 0, next = 0; column < Columns; column = next)
            {
                for (next = column + 1; next < Columns && Shade(next) == Shade(column); next++)
                {
                }

                int grey = 255 * Shade(column) / Levels;
                figure.Rectangle(30 + (10 * column), 20 + (10 * row), 10 * (next - column), 10, FormattableString.Invariant($"#{grey:x2}{grey:x2}{grey:x2}"));
            }
        }

        StratifiedSampler sampler = new(16, 1);
        for (int i = 0; i < 256; i++)
        {
            sampler.Begin(0, 0, i);
            (Vector d, _) = around.Choose(sampler.Next2());
            double u = Math.Atan2(d.X, -d.Z) / (2 * Math.PI);
            figure.Dot((30 + (600 * (u - Math.Floor(u))), 20 + (300 * Math.Acos(d.Y) / Math.PI)), Red, 2.2);
        }

        figure.Text("256 directions, chosen by the light that comes from them", (330, 340));
        return figure.Document;
    }

    private static Vector Along(double u, double v)
    {
        (double sin, double cos) = Math.SinCos(2 * Math.PI * u);
        (double r, double y) = Math.SinCos(Math.PI * v);
        return new(r * sin, y, -r * cos);
    }

    /// <summary>How far light flies in a medium, and where it turns when it is scattered.</summary>
    public static XDocument Media()
    {
        const double Extinction = 0.8;
        Figure figure = new(660, 320);
        IndependentSampler sampler = new(6);
        Plot flights = new(figure, (70, 40, 240, 210), (0, 5), (0, 0.8), (Plot.Ticks("0", 0, 1, 2, 3, 4, 5), Plot.Ticks("0.#", 0, 0.4, 0.8)), ("distance of flight (σ = 0.8)", "density"));
        flights.Histogram([.. Enumerable.Range(0, 5000).Select(_ => -Math.Log(1 - sampler.Next()) / Extinction)], 25, "#9cc7e3");
        flights.Curve(null, Red, d => Extinction * Math.Exp(-Extinction * d));
        figure.Text("σ e^(−σd)", (160, 75), "start", Red);

        (double X, double Y) centre = (460, 150);
        figure.Arrow((335, 150), (452, 150), Ink);
        foreach ((float g, string colour, int i) in new[] { (0f, Ink, 0), (0.4f, Blue, 1), (0.7f, Red, 2), (-0.3f, Green, 3) })
        {
            figure.Polyline(Enumerable.Range(0, 181).Select(k => 2 * Math.PI * k / 180).Select(turn =>
            {
                double length = 260 * Math.Sqrt(HenyeyGreenstein.Evaluate((float)Math.Cos(turn), g)[0]) * 0.55;
                return (centre.X + (length * Math.Cos(turn)), centre.Y - (length * Math.Sin(turn)));
            }), colour, 1.8);
            figure.Line((322 + (80 * i), 293), (340 + (80 * i), 293), colour, 2);
            figure.Text(FormattableString.Invariant($"g = {g:0.#}").Replace('-', '−'), (345 + (80 * i), 298), "start");
        }

        figure.Text("square root of the phase function", (490, 25));
        return figure.Document;
    }

    /// <summary>For which share of the shutter's time a moving ball covers the points of its way.</summary>
    public static XDocument Shutter()
    {
        Figure figure = new(660, 280);
        Plot plot = new(figure, (75, 20, 400, 195), (-1, 3.2), (0, 1), (Plot.Ticks("0;−0", -1, 0, 1, 2, 3), Plot.Ticks("0.#", 0, 0.5, 1)), ("place along the way, in diameters of the ball", "share of the time"));
        foreach ((double way, string colour) in new[] { (0.0, Ink), (0.5, Blue), (2.0, Red) })
        {
            plot.Curve(FormattableString.Invariant($"moves by {way}"), colour, x => Covered(x, way), steps: 210);
        }

        return figure.Document;
    }

    // A ray from the front, at 400 times of the shutter: the ball, of radius 0.5, is met or not.
    private static double Covered(double x, double way)
    {
        Sphere ball = new(default, 0.5);
        Ray ray = new(new(x, 0, 5), new(0, 0, -1));
        return Enumerable.Range(0, 400).Average(i =>
        {
            Hit hit = Hit.None();
            return new Placed(ball, Transform.Translation(new(way * (i + 0.5) / 400, 0, 0))).Intersect(ray, ref hit) ? 1.0 : 0;
        });
    }

    /// <summary>The report's figure 4.8: the refractive index of fused quartz.</summary>
    public static XDocument Index()
    {
        Figure figure = new(660, 300);
        Plot plot = new(figure, (85, 20, 440, 215), (300, 800), (1.45, 1.49), (Plot.Ticks("0", 300, 400, 500, 600, 700, 800), Plot.Ticks("0.00", 1.45, 1.46, 1.47, 1.48, 1.49)), ("wavelength in nm", "refractive index"));
        Dispersion quartz = Glass.FusedQuartz.Dispersion();
        foreach ((double nanometres, string colour, string name) in new[] { (436, "#3b3fd0", "violet"), (546, "#2a8a2a", "green"), (656, "#c03028", "red") })
        {
            double index = quartz.Index((float)(nanometres / 1000))[0];
            figure.Line(plot.At(nanometres, 1.45), plot.At(nanometres, index), colour, 1.5, "4 3");
            figure.Dot(plot.At(nanometres, index), colour, 5);
            (double x, double y) = plot.At(nanometres, index);
            figure.Text(FormattableString.Invariant($"{name}, {nanometres} nm: {index:0.0000}"), (x + 8, y - 10), "start", colour);
        }

        plot.Curve(null, Ink, nanometres => quartz.Index((float)(nanometres / 1000))[0]);
        return figure.Document;
    }

    private static Vector Direction(double degrees) => new(Math.Sin(degrees * Math.PI / 180), 0, Math.Cos(degrees * Math.PI / 180));
}
