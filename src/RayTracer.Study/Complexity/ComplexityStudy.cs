using System.Diagnostics;
using System.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Study;

/// <summary>Measures the time a ray against the number of triangles, method by method.</summary>
/// <param name="plan">The numbers of triangles.</param>
/// <param name="methods">The methods.</param>
/// <param name="rays">The rays.</param>
/// <param name="raysAtOnce">
/// The rays of a piece: the fastest of some rounds counts for each of many short pieces, as what else the machine does meets few of them every time.
/// </param>
internal sealed class ComplexityStudy(ComplexityPlan plan, IReadOnlyList<Method> methods, (Vector3 Origin, Vector3 Direction)[] rays, int raysAtOnce)
{
    /// <summary>Rays in random directions, by all methods that trace them.</summary>
    public ComplexityStudy(ComplexityPlan plan) : this(plan, Method.All, Terrain.Rays(plan.Rays), 4096)
    {
    }

    /// <summary>The methods.</summary>
    public IReadOnlyList<Method> Methods => methods;

    /// <summary>The measurements, by method.</summary>
    public Dictionary<Method, List<ComplexityPoint>> Points { get; } = methods.ToDictionary(m => m, _ => new List<ComplexityPoint>());

    /// <summary>Methods that were left out from some number of triangles on, because they would have taken too long.</summary>
    public Dictionary<Method, int> LeftOut { get; } = [];

    /// <summary>
    /// Rays that two methods did not find the same triangle for: those through an edge, which each of two tests may give to either side.
    /// </summary>
    public int Disagreements { get; private set; }

    /// <summary>A picture of the landscape, a ray through the middle of each pixel, by the methods that make one.</summary>
    public static ComplexityStudy OfPicture(ComplexityPlan plan)
    {
        int side = (int)Math.Sqrt(plan.Rays);
        ComplexityPlan small = plan with { Counts = [.. plan.Counts.Where(n => n <= Method.MostOfPicture)] };
        return new(small, Method.OfPictures, [.. Enumerable.Range(0, side * side).Select(i => TerrainView.RayOf(i, side))], side * side);
    }

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
            foreach (Method method in methods.Where(m => !LeftOut.ContainsKey(m)))
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
        int[] hits = new int[rays.Length];
        tracer.Trace(rays.AsSpan(0, Math.Min(raysAtOnce, rays.Length)), hits);
        double seconds = 0;
        for (int first = 0; first < rays.Length; first += raysAtOnce)
        {
            int count = Math.Min(raysAtOnce, rays.Length - first);
            seconds += Enumerable.Range(0, plan.Rounds).Min(_ =>
            {
                long start = Stopwatch.GetTimestamp();
                tracer.Trace(rays.AsSpan(first, count), hits.AsSpan(first, count));
                return Stopwatch.GetElapsedTime(start).TotalSeconds;
            });
        }

        return (new(mesh.TriangleCount, seconds * 1e9 / rays.Length, build, tracer.MemoryBytes / (double)mesh.TriangleCount), hits);
    }
}
