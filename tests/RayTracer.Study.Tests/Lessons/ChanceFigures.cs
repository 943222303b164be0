using System.Xml.Linq;
using RayTracer.Textbook;
using static RayTracer.Study.Tests.Lessons.Figure;

namespace RayTracer.Study.Tests.Lessons;

/// <summary>Drawings of the lessons on chance, from random numbers of the textbook edition.</summary>
internal static class ChanceFigures
{
    /// <summary>The error of the area of a quarter disk, by the share of points in it, against their number.</summary>
    public static XDocument Error()
    {
        int[] sides = [1, 2, 4, 8, 16, 32, 64];
        double deviation = Math.Sqrt(Math.PI / 4 * (1 - (Math.PI / 4)));
        return SvgChart.Draw([new("Error of an estimate", "samples", "root mean square error",
            [
                new("independent", Blue, [.. sides.Select(s => ((double)s * s, RootMeanSquare(_ => new IndependentSampler(3), s)))], Fit: null),
                new("σ / √N", Ink, [.. sides.Select(s => ((double)s * s, deviation / s))], Fit: null) { IsJoined = true },
                new("jittered", Red, [.. sides.Select(s => ((double)s * s, RootMeanSquare(n => new StratifiedSampler(n, 3), s)))], Fit: null) { IsJoined = true },
            ], IsLogarithmic: true) { HasLegendAside = true }]);
    }

    // Over 400 estimates, each of side² points.
    private static double RootMeanSquare(Func<int, ISampler> make, int side)
    {
        const int Estimates = 400;
        ISampler sampler = make(side);
        double squares = 0;
        for (int estimate = 0; estimate < Estimates; estimate++)
        {
            int inside = 0;
            for (int i = 0; i < side * side; i++)
            {
                sampler.Begin(estimate, 0, i);
                (double u, double v) = sampler.Next2();
                inside += (u * u) + (v * v) < 1 ? 1 : 0;
            }

            squares += Math.Pow((inside / (double)(side * side)) - (Math.PI / 4), 2);
        }

        return Math.Sqrt(squares / Estimates);
    }

    /// <summary>Means of 1, 4, 16 and 64 values of u², many times: they gather around 1/3, and come to look like a bell.</summary>
    public static XDocument Means()
    {
        Figure figure = new(660, 250);
        IndependentSampler sampler = new(5);
        foreach ((int n, int i) in new[] { 1, 4, 16, 64 }.Select((n, i) => (n, i)))
        {
            Plot plot = new(figure, (40 + (156 * i), 30, 136, 160), (0, 1), (0, 12), (Plot.Ticks("0.##", 0, 0.5, 1), []), (n == 1 ? "1 value" : $"mean of {n}", ""));
            double[] means = [.. Enumerable.Range(0, 4000).Select(_ => Enumerable.Range(0, n).Average(_ => Math.Pow(sampler.Next(), 2)))];
            plot.Histogram(means, 40, "#9cc7e3");

            // The bell with the variance of u², 1/5 − 1/9, over n.
            double variance = 4.0 / 45 / n;
            if (n > 1)
            {
                plot.Curve(null, Red, x => Math.Exp(-Math.Pow(x - (1.0 / 3), 2) / (2 * variance)) / Math.Sqrt(2 * Math.PI * variance));
            }

            figure.Line(plot.At(1.0 / 3, 0), plot.At(1.0 / 3, 12), Ink, 1, "4 3");
        }

        return figure.Document;
    }

    /// <summary>Directions of two warps, counted by the cosine to the axis, against their densities.</summary>
    public static XDocument Warps()
    {
        Figure figure = new(660, 280);
        IndependentSampler sampler = new(2);
        (string Title, Func<double> Draw, Func<double, double> Density, double Top)[] warps =
        [
            ("cosine", () => Warp.CosineHemisphere(sampler.Next2()).Z, z => 2 * Math.PI * Warp.CosineHemispherePdf(z), 2),
            ("cosine to the power of 20", () => Warp.CosinePower(sampler.Next2(), 20).Z, z => 2 * Math.PI * Warp.CosinePowerPdf(z, 20), 22),
        ];
        for (int i = 0; i < 2; i++)
        {
            (string title, Func<double> draw, Func<double, double> density, double top) = warps[i];
            Plot plot = new(figure, (70 + (320 * i), 40, 240, 180), (0, 1), (0, top), (Plot.Ticks("0.##", 0, 0.5, 1), Plot.Ticks("0.#", 0, top / 2, top)), ("cos θ", i == 0 ? "density of cos θ" : ""));
            plot.Histogram([.. Enumerable.Range(0, 4000).Select(_ => draw())], 25, "#9cc7e3");
            plot.Curve(null, Red, density);
            figure.Text(title, (190 + (320 * i), 25), isBold: true);
        }

        return figure.Document;
    }

    /// <summary>Along directions in a plane: with which density a lamp's sampling and a rough metal's find them, and what each counts by the balance heuristic.</summary>
    public static XDocument Weights()
    {
        Figure figure = new(660, 400);
        Ggx metal = new(new Solid(new Rgb(0.12)), new Reflectance(Rgb.Black, Rgb.Black, new Solid(Rgb.White)));
        Vector viewer = Direction(-40);
        double lamp = 1 / (2 * Math.PI * (1 - Math.Cos(Math.PI / 12)));
        double OfLamp(double degrees) => degrees is >= 25 and <= 55 ? lamp : 0;
        double OfMetal(double degrees) => metal.Pdf(default, viewer, Direction(degrees));
        IEnumerable<(double, double)> Along(double from, double to, Func<double, double> f) => Enumerable.Range(0, 121).Select(i => from + ((to - from) * i / 120)).Select(x => (x, f(x)));
        (double Value, string Label)[] angles = [.. Plot.Ticks("0°", 0, 30, 60, 90)];

        Plot densities = new(figure, (75, 25, 420, 135), (0, 90), (0, 8), (angles, Plot.Ticks("0", 0, 2, 4, 6, 8)), ("", "pdf per steradian"));
        densities.Curve("lamp's sampling", Blue, [(0, 0), (25, 0), (25, lamp), (55, lamp), (55, 0), (90, 0)]);
        densities.Curve("metal's sampling", Red, OfMetal);
        Plot weights = new(figure, (75, 210, 420, 135), (0, 90), (0, 1), (angles, Plot.Ticks("0.#", 0, 0.5, 1)), ("angle to the normal, on the other side than the viewer (40°)", "weight"));
        weights.Curve("of the lamp's", Blue, Along(25, 55, x => OfLamp(x) / (OfLamp(x) + OfMetal(x))));
        weights.Curve("of the metal's", Red, Along(25, 55, x => OfMetal(x) / (OfLamp(x) + OfMetal(x))));
        weights.Curve("squared (power)", Purple, Along(25, 55, x => LightSampling.Share(OfMetal(x), OfLamp(x))), "5 4");
        return figure.Document;
    }

    /// <summary>Paths between walls that reflect 70 %: how many live on under roulette, and what they carry together.</summary>
    public static XDocument Roulette()
    {
        const int Paths = 4000;
        const int Bounces = 16;
        const int Spared = 4;
        Figure figure = new(660, 290);
        IndependentSampler sampler = new(4);
        int[] alive = new int[Bounces + 1];
        double[] carried = new double[Bounces + 1];
        for (int path = 0; path < Paths; path++)
        {
            Rgb throughput = Rgb.White;
            for (int bounce = 0; bounce <= Bounces; bounce++)
            {
                alive[bounce]++;
                carried[bounce] += throughput.R;
                throughput *= new Rgb(0.7);
                if (bounce >= Spared && !PathIntegrator.Survives(null, ref throughput, sampler.Next()))
                {
                    break;
                }
            }
        }

        Plot plot = new(figure, (75, 20, 380, 205), (0, Bounces), (0, 1), (Plot.Ticks("0", 0, 4, 8, 12, 16), Plot.Ticks("0.##", 0, 0.25, 0.5, 0.75, 1)), ("bounces", "share of the paths"));
        plot.Curve("0.7ᵏ", Ink, k => Math.Pow(0.7, k));
        plot.Curve("paths that are left", Blue, alive.Select((a, k) => ((double)k, a / (double)Paths)), "5 4");
        plot.Curve("what all carry", Red, carried.Select((c, k) => ((double)k, c / Paths)), "1 5");
        foreach ((double c, int k) in carried.Select((c, k) => (c / Paths, k)))
        {
            figure.Dot(plot.At(k, c), Red);
            figure.Circle(plot.At(k, alive[k] / (double)Paths), 5, Blue);
        }

        return figure.Document;
    }

    private static Vector Direction(double degrees) => new(Math.Sin(degrees * Math.PI / 180), 0, Math.Cos(degrees * Math.PI / 180));
}
