using System.Diagnostics;
using System.Globalization;
using System.Numerics;
using RayTracer.Jobs;

namespace RayTracer.Benchmarks.Precision;

/// <summary>Single precision against double: the same rays and balls, by the same code, at several distances from the origin.</summary>
internal static class PrecisionBenchmark
{
    private const int Rounds = 9;

    public static int Run()
    {
        Console.WriteLine($"{Machine.Now()}\n\n{BallRays<float>.Rays} rays against {BallRays<float>.Balls} balls of radius 1 on one thread, the best of {Rounds} rounds in turn.\n");
        Console.WriteLine($"| from the origin | {Vector<float>.Count} floats, M rays/s | {Vector<double>.Count} doubles, M rays/s | times as fast | other hit | median error | largest error |\n|---:|---:|---:|---:|---:|---:|---:|");
        foreach (double offset in new[] { 0, 1e2, 1e4, 1e6 })
        {
            BallRays<float> single = new(offset);
            BallRays<double> twice = new(offset);
            double singleSeconds = double.PositiveInfinity;
            double doubleSeconds = double.PositiveInfinity;
            for (int round = 0; round < Rounds; round++)
            {
                singleSeconds = Math.Min(singleSeconds, Seconds(single.Trace));
                doubleSeconds = Math.Min(doubleSeconds, Seconds(twice.Trace));
            }

            Report(offset, singleSeconds, doubleSeconds, single, twice);
        }

        return 0;
    }

    private static void Report(double offset, double singleSeconds, double doubleSeconds, BallRays<float> single, BallRays<double> twice)
    {
        (float Single, double Double)[] hits = [.. single.Distances.Zip(twice.Distances)];
        double other = hits.Count(h => float.IsFinite(h.Single) != double.IsFinite(h.Double)) / (double)hits.Length;
        double[] errors = [.. hits.Where(h => float.IsFinite(h.Single) && double.IsFinite(h.Double)).Select(h => Math.Abs(h.Single - h.Double)).Order()];
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"| {offset:N0} | {BallRays<float>.Rays / singleSeconds / 1e6:F0} | {BallRays<float>.Rays / doubleSeconds / 1e6:F0} | {doubleSeconds / singleSeconds:F2} | {other:P3} | {errors[errors.Length / 2]:0.0e+0} | {errors[^1]:0.0e+0} |"));
    }

    private static double Seconds(Action action)
    {
        long start = Stopwatch.GetTimestamp();
        action();
        return Stopwatch.GetElapsedTime(start).TotalSeconds;
    }
}
