using System.Diagnostics;
using System.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Study;

/// <summary>Measures the time a ray against the number of triangles, method by method.</summary>
/// <param name="plan">The numbers of triangles.</param>
internal sealed class ComplexityStudy(ComplexityPlan plan)
{
    private const int WarmUpRays = 64;

    // The fastest of some rounds counts for each of many short pieces: what else the machine does meets few of them every time.
    private const int RaysAtOnce = 4096;
    private readonly (Vector3 Origin, Vector3 Direction)[] _rays = Terrain.Rays(plan.Rays);

    /// <summary>The measurements, by method.</summary>
    public Dictionary<Method, List<ComplexityPoint>> Points { get; } = Method.All.ToDictionary(m => m, _ => new List<ComplexityPoint>());

    /// <summary>Methods that were left out from some number of triangles on, because they would have taken too long.</summary>
    public Dictionary<Method, int> LeftOut { get; } = [];

    /// <summary>
    /// Rays that two methods did not find the same triangle for: those through an edge, which each of two tests may give to either side.
    /// </summary>
    public int Disagreements { get; private set; }

    /// <summary>Measures.</summary>
    /// <param name="report">Takes each result.</param>
    /// <param name="cancellation">Ends the study.</param>
    /// <exception cref="OperationCanceledException">It was ended.</exception>
    public void Run(Action<Method, ComplexityPoint> report, CancellationToken cancellation)
    {
        foreach (int count in plan.Counts)
        {
            MeshData mesh = Terrain.Create(count);
            int[]? expected = null;
            foreach (Method method in Method.All.Where(m => !LeftOut.ContainsKey(m)))
            {
                cancellation.ThrowIfCancellationRequested();
                if (IsTooSlow(method, count))
                {
                    LeftOut.Add(method, count);
                    continue;
                }

                (ComplexityPoint point, int[] hits) = Measure(method, mesh);
                Points[method].Add(point);
                report(method, point);
                expected ??= hits;
                Disagreements += hits.Zip(expected).Count(pair => pair.First != pair.Second);
            }
        }
    }

    // By the last measurement, if it grew in proportion to the number of triangles.
    private bool IsTooSlow(Method method, int count)
    {
        if (Points[method].Count == 0)
        {
            return false;
        }

        ComplexityPoint last = Points[method][^1];
        double seconds = Math.Max(last.BuildSeconds, last.NanosecondsPerRay * 1e-9 * plan.Rays * plan.Rounds);
        return seconds * count / last.Triangles > plan.SecondsEach && (seconds > plan.SecondsEach / 10 || method.Growth(4) == 4);
    }

    private (ComplexityPoint Point, int[] Hits) Measure(Method method, MeshData mesh)
    {
        long start = Stopwatch.GetTimestamp();
        ITracer tracer = method.Build(mesh);
        double build = Stopwatch.GetElapsedTime(start).TotalSeconds;
        int[] hits = new int[_rays.Length];
        tracer.Trace(_rays.AsSpan(0, Math.Min(WarmUpRays, _rays.Length)), hits);
        double seconds = 0;
        for (int first = 0; first < _rays.Length; first += RaysAtOnce)
        {
            int count = Math.Min(RaysAtOnce, _rays.Length - first);
            seconds += Enumerable.Range(0, plan.Rounds).Min(_ =>
            {
                long start = Stopwatch.GetTimestamp();
                tracer.Trace(_rays.AsSpan(first, count), hits.AsSpan(first, count));
                return Stopwatch.GetElapsedTime(start).TotalSeconds;
            });
        }

        return (new(mesh.TriangleCount, seconds * 1e9 / _rays.Length, build, tracer.MemoryBytes / (double)mesh.TriangleCount), hits);
    }
}
