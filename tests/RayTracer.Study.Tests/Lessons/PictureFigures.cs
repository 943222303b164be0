using System.Xml.Linq;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textbook;
using RayTracer.Textures;
using static RayTracer.Study.Tests.Lessons.Figure;

namespace RayTracer.Study.Tests.Lessons;

/// <summary>Drawings of the lessons on what becomes of light in a picture.</summary>
internal static class PictureFigures
{
    /// <summary>What the tone maps make of a grey, from dark to bright.</summary>
    public static XDocument Tones()
    {
        Figure figure = new(660, 310);
        Plot plot = new(figure, (75, 20, 420, 225), (-6, 6), (0, 1), (Plot.Ticks("+0;−0;0", -6, -4, -2, 0, 2, 4, 6), Plot.Ticks("0.##", 0, 0.25, 0.5, 0.75, 1)), ("light, in stops above and below 1", "value in the file (sRGB)"));
        foreach ((ToneMap map, string colour, string? dash) in new[]
        {
            (ToneMap.Clamp, Ink, null), (ToneMap.Soft, Blue, null), (ToneMap.Reinhard, Green, null), (ToneMap.Aces, Red, "6 4"), (ToneMap.Agx, Purple, (string?)"2 4"),
        })
        {
            plot.Curve(map.ToString().ToLowerInvariant(), colour, stops =>
            {
                float light = (float)Math.Pow(2, stops);
                return SrgbCurve.Encode8(ToneMapping.Apply(map, new(light, light, light)).G) / 255.0;
            }, dash);
        }

        return figure.Document;
    }

    /// <summary>A noisy row of pixels, the mean of neighbours, and the mean of neighbours that look alike.</summary>
    public static XDocument Filters()
    {
        const int Count = 110;
        const int Reach = 6;
        const double Noise = 0.08;
        Figure figure = new(660, 300);
        IndependentSampler sampler = new(9);
        double True(int i) => i < 45 ? 0.25 + (0.001 * i) : i < 80 ? 0.75 : 0.75 - (0.012 * (i - 80));

        // Sums of twelve uniform numbers, less 6, have mean 0 and variance 1.
        double[] noisy = [.. Enumerable.Range(0, Count).Select(i => True(i) + (Noise * (Enumerable.Range(0, 12).Sum(_ => sampler.Next()) - 6)))];
        double At(int i) => noisy[Math.Clamp(i, 0, Count - 1)];
        double Mean(int i, Func<int, double> weight)
        {
            int[] others = [.. Enumerable.Range(i - Reach, (2 * Reach) + 1)];
            return others.Sum(j => weight(j) * At(j)) / others.Sum(weight);
        }

        // Buades, Coll and Morel 2005: a neighbour counts by how much its surroundings look like those of the pixel, in deviations of the noise.
        double Alike(int i, int j)
        {
            double distance = Enumerable.Range(-3, 7).Average(k => Math.Pow(At(i + k) - At(j + k), 2)) / (2 * Noise * Noise);
            return Math.Exp(-Math.Max(0, distance - 1) / 0.2);
        }

        Plot plot = new(figure, (75, 20, 420, 215), (0, Count - 1), (0, 1), (Plot.Ticks("0", 0, 20, 40, 60, 80, 100), Plot.Ticks("0.#", 0, 0.5, 1)), ("pixel", "light"));
        for (int i = 0; i < Count; i++)
        {
            figure.Dot(plot.At(i, noisy[i]), "#9a9a9a", 2.2);
        }

        IEnumerable<(double, double)> Row(Func<int, double> f) => Enumerable.Range(0, Count).Select(i => ((double)i, f(i)));
        plot.Curve("true", Ink, Row(True), "5 4");
        plot.Curve("mean of 13", Red, Row(i => Mean(i, _ => 1)));
        plot.Curve("non-local mean", Blue, Row(i => Mean(i, j => Alike(i, j))));
        return figure.Document;
    }
}
