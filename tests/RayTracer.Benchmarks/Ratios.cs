using System.Numerics;
using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Benchmarks;

/// <summary>
/// Whole renders against one another, in turn, in one process: the renderer on one thread against the textbook edition. On a shared
/// machine only such ratios mean something, and processor time more than wall time.
/// </summary>
internal static class Ratios
{
    private const int Rounds = 3;

    public static int Run(string[] paths)
    {
        Console.WriteLine($"{Machine.Now()}\n\nProcessor time on one thread, the best of {Rounds} rounds in turn.\n");
        Console.WriteLine($"| scene | textbook edition | {Vector<float>.Count} lanes | times as fast |\n|---|---:|---:|---:|");
        Measure("S2, sobol", PrototypeScene.Create(SamplerKind.Sobol, 16));
        Measure("S2, jittered", PrototypeScene.Create(SamplerKind.Jittered, 16));
        foreach (string path in paths)
        {
            SceneDescription? description = Scenes.SceneReader.Read(path).Description;
            if (description is null)
            {
                Console.Error.WriteLine($"{path}: not a scene; see \"raytracer check\"");
                return 3;
            }

            Measure($"`{path}`", description);
        }

        return 0;
    }

    private static void Measure(string name, SceneDescription description)
    {
        Func<string, bool, Picture> grey = (_, _) => new(1, 1, [0.5f, 0.5f, 0.5f]);
        SceneBuilder builder = new(grey);
        Scene scene = builder.Build(description) ?? throw new InvalidOperationException(builder.Complaints[0].Message);
        Textbook.SceneReader reader = new(grey);
        Textbook.Renderer textbook = reader.Read(description) ?? throw new InvalidOperationException(reader.Complaints[0].Message);
        double slow = double.PositiveInfinity;
        double fast = double.PositiveInfinity;
        int samples = description.Render.SamplesPerPixel;
        long paths = (long)description.Render.Width * description.Render.Height * samples;
        for (int round = 0; round < Rounds; round++)
        {
            slow = Math.Min(slow, ProcessorTime(() => Enumerable.Range(0, samples).ToList().ForEach(sample => textbook.Pass(sample))));
            fast = Math.Min(fast, ProcessorTime(() => new RTracer(scene, new() { Threads = 1 }).Render()));
        }

        Console.WriteLine($"| {name} | {slow:F2} s, {paths / slow / 1e6:F2} M paths/s | {fast:F2} s, {paths / fast / 1e6:F2} M paths/s | {slow / fast:F1} |");
    }

    private static double ProcessorTime(Action action)
    {
        TimeSpan before = Environment.CpuUsage.TotalTime;
        action();
        return (Environment.CpuUsage.TotalTime - before).TotalSeconds;
    }
}
