using System.Numerics;
using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Benchmarks;

/// <summary>
/// Whole renders against one another, in turn, in one process: the renderer on one thread against <see cref="ScalarTracer"/>. On a shared
/// machine only such ratios mean something, and processor time more than wall time.
/// </summary>
internal static class Ratios
{
    private const int Rounds = 3;

    public static int Run(string[] paths)
    {
        Console.WriteLine($"{Machine.Now()}\n\nProcessor time on one thread, the best of {Rounds} rounds in turn.\n");
        Console.WriteLine($"| scene | scalar recursion | {Vector<float>.Count} lanes | times as fast |\n|---|---:|---:|---:|");
        Measure("S2, sobol", PrototypeScene.Create(SamplerKind.Sobol, 16));
        Measure("S2, jittered", PrototypeScene.Create(SamplerKind.Jittered, 16));
        foreach (string path in paths)
        {
            SceneDescription? description = SceneReader.Read(path).Description;
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
        Scene scene = Build(description);
        double scalar = double.PositiveInfinity;
        double one = double.PositiveInfinity;
        long scalarRays = 0;
        long rays = 0;
        for (int round = 0; round < Rounds; round++)
        {
            ScalarTracer tracer = new(description);
            scalar = Math.Min(scalar, ProcessorTime(() => tracer.Render()));
            scalarRays = tracer.Rays;
            one = Math.Min(one, ProcessorTime(() => rays = new RTracer(scene, new() { Threads = 1 }).Render().Statistics.Rays));
        }

        Console.WriteLine($"| {name} | {scalar:F2} s, {scalarRays / scalar / 1e6:F1} M rays/s | {one:F2} s, {rays / one / 1e6:F0} M rays/s | {scalar / one:F1} |");
    }

    private static Scene Build(SceneDescription description)
    {
        SceneBuilder builder = new((_, _) => new(1, 1, [0.5f, 0.5f, 0.5f]));
        return builder.Build(description) ?? throw new InvalidOperationException(builder.Complaints[0].Message);
    }

    private static double ProcessorTime(Action action)
    {
        TimeSpan before = Environment.CpuUsage.TotalTime;
        action();
        return (Environment.CpuUsage.TotalTime - before).TotalSeconds;
    }
}
