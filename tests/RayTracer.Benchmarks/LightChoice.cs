using System.Diagnostics;
using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;

namespace RayTracer.Benchmarks;

/// <summary>
/// What the choice of one light of many gains, and takes: small lamps of different strengths above a floor, seen from points of it without shadows.
/// </summary>
internal static class LightChoice
{
    private const int Points = 64;
    private const int Trials = 20_000;
    private static readonly int[] s_counts = [10, 100, 1_000, 10_000, 100_000];

    /// <summary>Prints a table.</summary>
    public static int Run()
    {
        Console.WriteLine("| lights | variance, uniform choice | variance, by the tree | ns, uniform choice | ns, by the tree | gain at equal time |");
        Console.WriteLine("|---:|---:|---:|---:|---:|---:|");
        foreach (int count in s_counts)
        {
            Scene scene = Scene.From(new SceneDescription { Lights = [.. Lamps(count)] });
            LightSelection selection = new(scene.Lights, (0, 1));
            (double uniform, double chosen) = Variances(scene.Lights, selection);
            (double plain, double tree) = (Nanoseconds(scene.Lights, null), Nanoseconds(scene.Lights, selection));
            Console.WriteLine(string.Create(
                CultureInfo.InvariantCulture, $"| {count:N0} | {uniform:G3} | {chosen:G2} | {plain:F0} | {tree:N0} | {uniform / chosen * plain / tree:G2} |"));
        }

        return 0;
    }

    private static IEnumerable<ShapeDescription> Lamps(int count)
    {
        Random random = new(7);
        for (int i = 0; i < count; i++)
        {
            float power = MathF.Pow(10, random.NextSingle() * 2);
            Vector3 center = new((random.NextSingle() * 100) - 50, 0.3f + (random.NextSingle() * 4), (random.NextSingle() * 100) - 50);
            yield return new SphereDescription { Center = center, Radius = 0.02f, Material = new LuminaireMaterialDescription { Multiplier = power } };
        }
    }

    private static Vector3 Point(int i) => new(((i % 8) * 11.7f) - 45, 0, ((i / 8 % 8) * 12.3f) - 45);

    // Of one sample, relative to the square of the mean, by all probabilities.
    private static (double Uniform, double Chosen) Variances(IReadOnlyList<LightSource> lights, LightSelection selection)
    {
        (double uniform, double chosen) = (0, 0);
        for (int i = 0; i < Points; i++)
        {
            (double sum, double squares, double weighed) = (0, 0, 0);
            for (int light = 0; light < lights.Count; light++)
            {
                lights[light].Sample(Point(i), 0.5f, 0.5f, 0f, out ShapeSampleW sample, out RgbW radiance);
                double brings = Math.Max(0, sample.Direction.Y[0]) * radiance.G[0];
                selection.Probability(Point(i), Vector3.UnitY, (uint)light, out FloatW probability);
                sum += brings;
                squares += brings * brings;
                weighed += brings > 0 ? brings * brings / probability[0] : 0;
            }

            uniform += ((squares * lights.Count / (sum * sum)) - 1) / Points;
            chosen += ((weighed / (sum * sum)) - 1) / Points;
        }

        return (uniform, chosen);
    }

    // Of the choice for a packet, and points on the light of its first lane; the least of three measurements.
    private static double Nanoseconds(IReadOnlyList<LightSource> lights, LightSelection? selection) => Enumerable.Range(0, 3).Min(_ =>
    {
        long start = Stopwatch.GetTimestamp();
        for (int i = 0; i < Trials; i++)
        {
            float u = i * 0.6180339f % 1;
            int light = (int)(u * lights.Count);
            if (selection is not null)
            {
                selection.Choose(Point(i), Vector3.UnitY, u, out UIntW choice, out FloatW _);
                light = (int)choice[0];
            }

            lights[light].Sample(Point(i), 0.5f, 0.5f, 0f, out ShapeSampleW _, out RgbW _);
        }

        return Stopwatch.GetElapsedTime(start).TotalNanoseconds / Trials;
    });
}
