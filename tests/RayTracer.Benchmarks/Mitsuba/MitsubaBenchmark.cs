using System.Diagnostics;
using System.Globalization;
using System.Numerics;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Benchmarks.Mitsuba;

/// <summary>
/// Whole renders against Mitsuba's vectorised mode (llvm_ad_rgb): the same scene, in turn, each in a process that has rendered once before, so
/// that neither side's compiler counts. The best round of each counts, by wall time on all cores.
/// </summary>
internal static class MitsubaBenchmark
{
    /// <param name="args">
    /// Pairs of a scene in Mitsuba's format and its samples, or of <c>cloud</c> and samples; before them, --rounds N, and --own FILE for the scene that is rendered here in the next pair's place.
    /// </param>
    public static int Run(string[] args)
    {
        int rounds = 4;
        string? own = null;
        Console.WriteLine($"{Vector<float>.Count} lanes, {Environment.ProcessorCount} threads");
        for (int i = 0; i + 1 < args.Length; i += 2)
        {
            switch (args[i])
            {
                case "--rounds":
                    rounds = Number(args[i + 1]);
                    break;
                case "--own":
                    own = args[i + 1];
                    break;
                case "cloud":
                    CloudBenchmark.Run(Number(args[i + 1]), rounds);
                    break;
                default:
                    Compare(args[i], own ?? args[i], Number(args[i + 1]), rounds);
                    own = null;
                    break;
            }
        }

        return 0;
    }

    private static int Number(string text) => int.Parse(text, CultureInfo.InvariantCulture);

    private static void Compare(string scene, string ownScene, int samples, int rounds)
    {
        Scene own = SceneLoader.Load(ownScene, s => s with { Render = s.Render with { SamplesPerPixel = samples } }).Scene
            ?? throw new InvalidOperationException($"{ownScene}: not a scene; see \"raytracer check\"");
        using MitsubaPeer peer = new(scene, samples);
        (double Wall, double Processor) mine = (double.PositiveInfinity, double.PositiveInfinity);
        (double Wall, double Processor) others = mine;
        for (int round = 0; round <= rounds; round++)
        {
            (double Wall, double Processor) first = peer.Render(round);
            (double Wall, double Processor) second = Render(own);
            if (round > 0)
            {
                others = Best(others, first);
                mine = Best(mine, second);
            }
        }

        double paths = (double)own.Render.Width * own.Render.Height * samples / 1e6;
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{Path.GetFileName(ownScene)}, {samples} samples, Mitsuba {peer.Version}: {paths / mine.Wall:F1} against {paths / others.Wall:F1} M paths/s, {others.Wall / mine.Wall:F2} times; by processor time {others.Processor / mine.Processor:F2} times"));
    }

    /// <summary>The lesser of two times, each by itself.</summary>
    public static (double Wall, double Processor) Best((double Wall, double Processor) a, (double Wall, double Processor) b) =>
        (Math.Min(a.Wall, b.Wall), Math.Min(a.Processor, b.Processor));

    private static (double Wall, double Processor) Render(Scene scene)
    {
        TimeSpan before = Environment.CpuUsage.TotalTime;
        long start = Stopwatch.GetTimestamp();
        new RTracer(scene, new()).Render();
        return (Stopwatch.GetElapsedTime(start).TotalSeconds, (Environment.CpuUsage.TotalTime - before).TotalSeconds);
    }
}
