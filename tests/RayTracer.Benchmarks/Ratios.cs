using System.Diagnostics;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Benchmarks;

/// <summary>
/// Whole renders against one another, in turn, in one process: the renderer on one thread against <see cref="ScalarTracer"/>, and
/// two threads against one. On a shared machine only such ratios mean something, and processor time more than wall time.
/// </summary>
internal static class Ratios
{
    private const int Rounds = 5;

    public static int Run(string[] paths)
    {
        Console.WriteLine($"{Vector<float>.Count} lanes; processor time on one thread, best of {Rounds} rounds in turn; two threads by wall time");
        Measure("prototype S2, sobol", PrototypeScene.Create(SamplerKind.Sobol, 16));
        Measure("prototype S2, jittered", PrototypeScene.Create(SamplerKind.Jittered, 16));
        foreach (string path in paths)
        {
            SceneDescription? description = SceneReader.Read(path).Description;
            if (description is null)
            {
                Console.Error.WriteLine($"{path}: not a scene; see \"raytracer check\"");
                return 3;
            }

            Measure(path, description);
        }

        return 0;
    }

    private static void Measure(string name, SceneDescription description)
    {
        Scene scene = Build(description);
        double scalar = double.PositiveInfinity;
        double one = double.PositiveInfinity;
        double oneWall = double.PositiveInfinity;
        double twoWall = double.PositiveInfinity;
        long scalarRays = 0;
        long rays = 0;
        for (int round = 0; round < Rounds; round++)
        {
            ScalarTracer tracer = new(description);
            scalar = Math.Min(scalar, ProcessorTime(() => tracer.Render()));
            scalarRays = tracer.Rays;
            long start = Stopwatch.GetTimestamp();
            one = Math.Min(one, ProcessorTime(() => rays = new RTracer(scene, new() { Threads = 1 }).Render().Statistics.Rays));
            oneWall = Math.Min(oneWall, Stopwatch.GetElapsedTime(start).TotalSeconds);
            start = Stopwatch.GetTimestamp();
            new RTracer(scene, new() { Threads = 2 }).Render();
            twoWall = Math.Min(twoWall, Stopwatch.GetElapsedTime(start).TotalSeconds);
        }

        Console.WriteLine($"{name}: scalar {scalar:F3} s ({scalarRays / scalar / 1e6:F1} M rays/s), one thread {one:F3} s ({rays / one / 1e6:F1} M rays/s)");
        Console.WriteLine($"  {scalar / one:F2} times the scalar recursion; two threads {oneWall / twoWall:F2} times one");
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
