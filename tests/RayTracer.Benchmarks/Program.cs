using System.Diagnostics;
using RayTracer.Benchmarks;
using RayTracer.Description;
using RayTracer.Rendering;

SamplerKind sampler = args.Length > 0 ? Enum.Parse<SamplerKind>(args[0], true) : SamplerKind.Sobol;
int spp = args.Length > 1 ? int.Parse(args[1]) : 16;
int threads = args.Length > 2 ? int.Parse(args[2]) : 1;
int stream = args.Length > 3 ? int.Parse(args[3]) : 1024;
int tile = args.Length > 4 ? int.Parse(args[4]) : 0;
var builder = new SceneBuilder((_, _) => throw new NotSupportedException());
Scene scene = builder.Build(PrototypeScene.Create(sampler, spp)) ?? throw new InvalidOperationException(builder.Complaints[0].Message);
double best = double.PositiveInfinity;
RenderStatistics s = null!;
Film film = null!;
for (int i = 0; i < 4; i++)
{
    var cpu = Environment.CpuUsage.UserTime;
    (film, s) = new RTracer(scene, new() { Threads = threads, StreamSize = stream, TileSize = tile }).Render();
    best = Math.Min(best, (Environment.CpuUsage.UserTime - cpu).TotalSeconds);
}
double mean = 0;
float[] row = new float[3 * 600];
for (int y = 0; y < 600; y++) { film.ReadRow(y, row); mean += row.Average(); }
Console.WriteLine($"{sampler} {spp} spp {threads}T stream {stream} lanes {System.Numerics.Vector<float>.Count}: {best * 1e3:F1} ms {s.Rays / best / 1e6:F1} Mrays/s {s.Paths / best / 1e6:F2} Mpaths/s rays/path {(double)s.Rays / s.Paths:F2} closest {(double)s.ClosestHitRays / s.Paths:F2} bad {s.NonFiniteSamples} mean {mean / 600:F5} {film.ComputeHash()[..12]}");
if (args.Length > 5) { RayTracer.Imaging.ImageFile.Write(args[5], film, new()); }
