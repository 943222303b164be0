using System.Diagnostics;
using System.Globalization;
using System.Runtime.Intrinsics.X86;
using System.Text.Json;
using RayTracer.Acceleration;

namespace RayTracer.Benchmarks.Embree;

/// <summary>
/// The triangle tree against Embree: the same mesh, the same rays, in turn in one process. On one thread processor time counts, on several wall time;
/// of each way to trace, the best round.
/// </summary>
internal static unsafe class EmbreeBenchmark
{
    private static readonly JsonSerializerOptions s_json = new() { Converters = { new FiniteNumberConverter() } };
    private static readonly TraversalMode[] s_modes = [TraversalMode.Single, TraversalMode.Blocks, TraversalMode.Sorted, TraversalMode.Automatic];

    /// <param name="args">
    /// --triangles N of a landscape, or --mesh FILE.ply; --rounds N; --peer SETTINGS of Embree's device (isa=avx2 where the runtime's
    /// DOTNET_EnableAVX512 is 0: both sides must have the same instructions); --json for figures on standard output and the rest on the other.
    /// </param>
    public static int Run(string[] args)
    {
        string? Option(string name) => Array.IndexOf(args, name) is int i and >= 0 && i + 1 < args.Length ? args[i + 1] : null;
        bool json = args.Contains("--json");
        int rounds = int.Parse(Option("--rounds") ?? "4", CultureInfo.InvariantCulture);
        int threads = Environment.ProcessorCount;
        string? file = Option("--mesh");
        BenchmarkMesh mesh = file is null
            ? BenchmarkMesh.Landscape(int.Parse(Option("--triangles") ?? "1000000", CultureInfo.InvariantCulture))
            : BenchmarkMesh.OfFile(file);
        string settings = Option("--peer") is string more ? $",{more}" : "";
        using EmbreePeer? peer = EmbreePeer.Load(threads, settings, out string why);
        TextWriter log = json ? Console.Error : Console.Out;
        log.WriteLine(peer is null ? $"No peer: {why}. Own figures only." : $"Embree {peer.Version} from {why}{settings}");
        log.WriteLine($"{mesh.TriangleCount:N0} triangles, {threads} threads, AVX2 {Avx2.IsSupported}, AVX-512 {Avx512F.VL.IsSupported}, {rounds} rounds");
        List<Figure> figures = [];
        EmbreePeer.Scene?[] scenes = [peer?.Build(mesh, robust: true), peer?.Build(mesh, robust: false)];
        TriangleBvh tree = MeasureBuild(mesh, peer, threads, rounds, scenes[0], figures);
        foreach (BenchmarkRays rays in BenchmarkRays.Of(mesh, tree))
        {
            figures.Add(Compare(tree, scenes, rays, 1, rounds, log));
            if (threads > 1)
            {
                figures.Add(Compare(tree, scenes, rays, threads, rounds, log));
            }
        }

        Array.ForEach(scenes, scene => scene?.Dispose());
        if (json)
        {
            Console.WriteLine(JsonSerializer.Serialize(figures, s_json));
        }
        else
        {
            Print(figures);
        }

        return 0;
    }

    private static TriangleBvh MeasureBuild(BenchmarkMesh mesh, EmbreePeer? peer, int threads, int rounds, EmbreePeer.Scene? scene, List<Figure> figures)
    {
        TriangleBvh? tree = null;
        double own = double.PositiveInfinity;
        double others = scene?.Seconds ?? double.NaN;
        for (int round = 0; round < (mesh.TriangleCount > 3_000_000 ? 1 : rounds); round++)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            long start = Stopwatch.GetTimestamp();
            tree = mesh.Build(threads);
            own = Math.Min(own, Stopwatch.GetElapsedTime(start).TotalSeconds);
            if (peer is not null)
            {
                using EmbreePeer.Scene again = peer.Build(mesh, robust: true);
                others = Math.Min(others, again.Seconds);
            }
        }

        double bytes = tree!.Statistics.MemoryBytes / (double)mesh.TriangleCount;
        double peerBytes = scene is null ? double.NaN : scene.Bytes / (double)mesh.TriangleCount;
        figures.Add(new("build", threads, "seconds", own, others, double.NaN, others / own, double.NaN, 0));
        figures.Add(new("memory", threads, "bytes a triangle", bytes, peerBytes, double.NaN, bytes / peerBytes, double.NaN, 0));
        return tree;
    }

    private static Figure Compare(TriangleBvh tree, EmbreePeer.Scene?[] scenes, BenchmarkRays rays, int threads, int rounds, TextWriter log)
    {
        List<(string Name, bool Own, bool Robust, bool Single, Action<int, int> Trace)> ways = [];
        foreach (TraversalMode mode in s_modes)
        {
            ways.Add((mode.ToString(), true, false, mode == TraversalMode.Single, (first, count) => Trace(tree, rays.Part(first, count), rays.Any, mode)));
        }

        for (int i = 0; i < 2; i++)
        {
            if (scenes[i] is EmbreePeer.Scene scene)
            {
                string name = i == 0 ? "Embree robust" : "Embree fast";
                ways.Add(($"{name} 1", false, i == 0, true, (first, count) => scene.Trace(rays, first, count, false, rays.Distance, rays.Primitive)));
                ways.Add(($"{name} 8", false, i == 0, false, (first, count) => scene.Trace(rays, first, count, true, rays.Distance, rays.Primitive)));
            }
        }

        double[] best = new double[ways.Count];
        int[] expected = [];
        int differences = 0;
        for (int round = 0; round <= rounds; round++)
        {
            for (int way = 0; way < ways.Count; way++)
            {
                double rate = rays.Count / Time(rays.Count, threads, ways[way].Name, ways[way].Trace) / 1e6;
                best[way] = round > 0 ? Math.Max(best[way], rate) : 0;
                if (round == 0)
                {
                    int[] found = new ReadOnlySpan<int>(rays.Primitive, rays.Count).ToArray();
                    expected = way == 0 ? found : expected;
                    int different = found.Zip(expected).Count(pair => pair.First != pair.Second);
                    if (ways[way].Own && different > 0)
                    {
                        throw new InvalidOperationException($"{ways[way].Name} disagrees with {ways[0].Name} on {different} rays.");
                    }

                    differences = Math.Max(differences, different);
                }
            }
        }

        for (int way = 0; way < ways.Count; way++)
        {
            log.WriteLine($"  {rays.Name,-9} {threads} threads {ways[way].Name,-16} {best[way],8:F2} M rays/s");
        }

        double Best(Func<(string Name, bool Own, bool Robust, bool Single, Action<int, int> Trace), bool> which) =>
            ways.Select((way, i) => which(way) ? best[i] : double.NaN).Where(rate => !double.IsNaN(rate)).DefaultIfEmpty(double.NaN).Max();
        double own = Best(w => w.Own);
        double robust = Best(w => !w.Own && w.Robust);
        double fast = Best(w => !w.Own);
        double single = Best(w => w.Own && w.Single) / Best(w => !w.Own && w.Robust && w.Single);
        return new(rays.Name, threads, "M rays/s", own, robust, fast, own / robust, single, differences);
    }

    private static void Trace(TriangleBvh tree, in RayStream rays, bool any, TraversalMode mode)
    {
        if (any)
        {
            tree.AnyHit(rays, mode);
        }
        else
        {
            tree.ClosestHit(rays, mode);
        }
    }

    private static double Time(int count, int threads, string name, Action<int, int> trace)
    {
        // Sorting wants many rays; the others get what fits a cache.
        int chunk = name is "Sorted" or "Automatic" ? Math.Min(1 << 18, ((count / (2 * threads)) + 63) & ~63) : 4096;
        chunk = threads == 1 && chunk > 4096 ? 1 << 18 : chunk;
        int next = 0;
        void Drain()
        {
            for (int first = Interlocked.Add(ref next, chunk) - chunk; first < count; first = Interlocked.Add(ref next, chunk) - chunk)
            {
                trace(first, Math.Min(chunk, count - first));
            }
        }

        if (threads == 1)
        {
            TimeSpan before = Environment.CpuUsage.TotalTime;
            Drain();
            return (Environment.CpuUsage.TotalTime - before).TotalSeconds;
        }

        long start = Stopwatch.GetTimestamp();
        Thread[] workers = [.. Enumerable.Range(0, threads).Select(_ => new Thread(Drain))];
        Array.ForEach(workers, worker => worker.Start());
        Array.ForEach(workers, worker => worker.Join());
        return Stopwatch.GetElapsedTime(start).TotalSeconds;
    }

    private static void Print(List<Figure> figures)
    {
        Console.WriteLine($"{"",-9} {"threads",7} {"own",9} {"robust",9} {"best",9} {"ratio",7} {"single",7} {"differ",7}");
        foreach (Figure f in figures)
        {
            Console.WriteLine($"{f.Name,-9} {f.Threads,7} {f.Own,9:F2} {f.Robust,9:F2} {f.Fastest,9:F2} {f.Ratio,7:F2} {f.SingleRatio,7:F2} {f.Differences,7}  {f.Unit}");
        }
    }

    /// <summary>One line of the result.</summary>
    /// <param name="Name">What was measured.</param>
    /// <param name="Threads">Number of threads.</param>
    /// <param name="Unit">Unit of the next three.</param>
    /// <param name="Own">The project's best mode.</param>
    /// <param name="Robust">The peer's best mode with its robust flag.</param>
    /// <param name="Fastest">The peer's best mode, with or without it.</param>
    /// <param name="Ratio">How many times as fast as the robust peer; of memory, own bytes over the peer's.</param>
    /// <param name="SingleRatio">The same for single rays against single rays.</param>
    /// <param name="Differences">Rays on which some mode of the peer names another triangle.</param>
    private sealed record Figure(
        string Name, int Threads, string Unit, double Own, double Robust, double Fastest, double Ratio, double SingleRatio, int Differences);
}
