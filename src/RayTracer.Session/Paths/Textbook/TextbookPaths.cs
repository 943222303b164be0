using System.Numerics;
using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Textbook;
using Vertex = RayTracer.Session.RayNotes.Vertex;

namespace RayTracer.Session;

/// <summary>Follows samples of a pixel once more in the textbook edition, and the paths from lights that end in it.</summary>
/// <param name="shown">The scene.</param>
/// <param name="renderer">The edition's renderer of it.</param>
internal sealed class TextbookPaths(ViewportScene shown, Renderer renderer)
{
    private const int MostWays = 64;
    private readonly bool _weighsPart = shown.Settings.Edition?.Contains(':', StringComparison.Ordinal) == true || shown.Scene.Render.Integrator.Name == "report";

    /// <summary>Follows some samples of a pixel.</summary>
    public IEnumerable<InspectedPath> Trace(int x, int y, SampleRange samples) => Enumerable.Range(samples.First, samples.Count).Select(sample =>
    {
        RayNotes notes = Follow(x, y, sample, out Textbook.Rgb light);

        // Of the ways on at glass, the brightest one is the path; all of them are ways.
        List<List<Vertex>> branches = Branches(notes);
        List<Vertex> path = branches.MaxBy(b => b.Sum(v => v.Contribution.Luminance))!;
        Textbook.Rgb rest = light - notes.Vertices.Aggregate(default(Textbook.Rgb), (sum, v) => sum + v.Contribution);
        List<InspectedWay> seen = Seen(x, y, sample, path[0], out Textbook.Rgb lens);
        InspectedVertex[] vertices = [Camera(path[0], lens), .. path.Select((v, i) => i < path.Count - 1 ? Of(v, path[i + 1].Came, default) : Of(v, null, rest))];
        IReadOnlyList<InspectedWay> ways = branches.Count < 2 && seen.Count == 0 ? [] : [.. Ways(branches, seen.Count > 0 ? "met" : "branch"), .. seen.Take(MostWays)];
        return new InspectedPath(sample, Single(light + lens), vertices, ways, PathSentence.Of(Single(light + lens), vertices, shown.Scene.Render.Integrator));
    });

    // Paths from the lights that bring light to the pixel in a sample: those of the whole picture are followed.
    private List<InspectedWay> Seen(int x, int y, int sample, Vertex first, out Textbook.Rgb sum)
    {
        List<(Textbook.Rgb Light, Vertex[] Path)> found = [];
        ParallelOptions options = new() { MaxDegreeOfParallelism = shown.Settings.Threads };
        Parallel.For(0, shown.Scene.Render.Height, options, Watched, (row, _, own) =>
        {
            renderer.TraceLight(own.Scene, row, sample, (column, line, light) =>
            {
                if ((column, line) == (x, y))
                {
                    lock (found)
                    {
                        found.Add((light, [.. own.Notes.Vertices]));
                    }
                }
            });
            return own;
        },
        _ => { });
        sum = found.Aggregate(default(Textbook.Rgb), (all, f) => all + f.Light);
        return
        [
            .. found.OrderByDescending(f => f.Light.Luminance).Select(f => new InspectedWay(
                f.Path.Length + 1, 1, "seen", Single(f.Light), 1, [.. f.Path.Select(NameOf)],
                [Point(first.Ray.Origin), .. f.Path.Reverse().Select(PointOf), Point(f.Path[0].Ray.Origin)])),
        ];

        (RayNotes Notes, Textbook.Scene Scene) Watched()
        {
            RayNotes notes = new(default, _weighsPart);
            return (notes, renderer.Scene.WatchedBy(notes));
        }
    }

    /// <summary>The rays of a sample.</summary>
    public RayNotes Follow(int x, int y, int sample, out Textbook.Rgb light)
    {
        RayNotes notes = new(renderer.Scene.Ambient, _weighsPart);

        // Photons are of one sample at a time, and several requests may look at once.
        lock (renderer)
        {
            light = renderer.Follow(x, y, sample, notes);
        }

        return notes;
    }

    // From the camera to each place where nothing goes on.
    private static List<List<Vertex>> Branches(RayNotes notes)
    {
        HashSet<Vertex> inner = [.. notes.Vertices.Select(v => v.Before).OfType<Vertex>()];
        return [.. notes.Vertices.Where(v => !inner.Contains(v)).Select(Back)];

        static List<Vertex> Back(Vertex end)
        {
            List<Vertex> path = [];
            for (Vertex? v = end; v is not null; v = v.Before)
            {
                path.Insert(0, v);
            }

            return path;
        }
    }

    // What several branches have in common counts for the first of them.
    private List<InspectedWay> Ways(List<List<Vertex>> branches, string kind)
    {
        HashSet<Vertex> counted = [];
        return [.. branches.Select(b =>
        {
            Textbook.Rgb light = b.Where(counted.Add).Aggregate(default(Textbook.Rgb), (sum, v) => sum + v.Contribution);
            IReadOnlyList<string> things = [.. b.Select(NameOf)];
            return new InspectedWay(0, b.Count + 1, kind, Single(light), 1, things, [.. b.Select(PointOf).Reverse().Append(Point(b[0].Ray.Origin))]);
        }).OrderByDescending(w => w.Radiance.Luminance)];
    }

    private static InspectedVertex Camera(Vertex first, Textbook.Rgb lens)
    {
        double[] nothing = [0, 0, 0];
        return new("camera", Point(first.Ray.Origin), null, "/camera", "camera", "", Numerics.Rgb.White, Numerics.Rgb.White, null, Array(lens), new(nothing, nothing, Array(lens)));
    }

    private InspectedVertex Of(Vertex v, RayNotes.Way? taken, Textbook.Rgb rest)
    {
        MaterialDescription? material = (v.Hit.Thing?.Source as ShapeDescription)?.Material;
        Textbook.Rgb emitted = v.Throughput * v.Radiance * v.Share;
        Textbook.Rgb ambient = v.Throughput * v.Ambient;
        return new(
            EventOf(v, taken), PointOf(v), v.IsHit ? Point(v.Hit.Inside ? -v.Hit.Normal : v.Hit.Normal) : null, v.IsHit ? shown.PointerOf(v.Hit.Thing!.Source) : null, NameOf(v),
            material is null ? "" : PathInspector.NameOf(shown, material), Single(taken?.Weight ?? default), Single(v.Throughput),
            taken is { Pdf: > 0 } way ? (float)way.Pdf : null, Array(v.Contribution + rest), new(Array(emitted), Array(ambient), Array((v.Throughput * v.Direct) + rest)))
        {
            Bsdf = taken?.Bsdf is { } bsdf ? Single(bsdf) : null,
            Cosine = (float)(taken?.Cosine ?? 0),
            Survival = taken is null ? 1 : (float)v.Survival,
            End = v.IsHit && taken is null ? v.Survival < 1 ? "roulette" : v.Offered.Count > 0 ? "depth" : "" : "",
            Emission = v.Share > 0 ? new(NameOf(v), Single(v.Radiance), null, null, (float)v.Share) { IsFoundOtherwise = v.Before is { Lights.Count: > 0 } } : null,
            Lights = [.. v.Lights.Select(l => Of(v, l))],
        };
    }

    private InspectedLight Of(Vertex v, RayNotes.AskedLight asked)
    {
        LightSample sample = asked.Sample;
        Thing? source = renderer.Scene.Things.FirstOrDefault(t => ReferenceEquals(t.Light, asked.Light));
        bool arrives = !asked.Added.IsBlack || asked.Share > 0;
        Thing? blocker = arrives || !renderer.Scene.Intersect(v.Hit.Leave(sample.Direction), out Textbook.Hit hit) || hit.Distance > sample.Distance * (1 - 1e-6) ? null : hit.Thing;
        double cosine = Math.Abs(Textbook.Vector.Dot(sample.Direction, v.Hit.Shading));
        return new(
            source is null ? asked.Light is EnvironmentLight ? "surroundings" : "point light" : NameOf(source), shown.PointerOf(source?.Source),
            arrives ? "arrives" : asked.Scattered.IsBlack ? "behind" : "blocked", blocker is null ? null : NameOf(blocker), shown.PointerOf(blocker?.Source), Single(sample.Radiance),
            (float)(asked.Chance * sample.Pdf), null, Single(asked.Scattered * (cosine > 0 ? 1 / cosine : 0)), (float)cosine, (float)asked.Share, Numerics.Rgb.White,
            Single(v.Throughput * asked.Added), Point(v.Hit.Point + (sample.Direction * Math.Min(sample.Distance, 2 * shown.Extent.Size))));
    }

    private static string EventOf(Vertex v, RayNotes.Way? taken) => !v.IsHit ? "miss" : taken is { } way ? way.Lobe == Lobe.Mirror ? "specular" : "diffuse"
        : v.Share > 0 ? "emission" : v.Offered.Count == 0 ? "absorbed" : "end";

    // Far enough to be seen to leave.
    private Vector3 PointOf(Vertex v) => Point(v.IsHit ? v.Hit.Point : v.Ray.At(2 * shown.Extent.Size));

    private static string NameOf(Vertex v) => v.IsHit ? NameOf(v.Hit.Thing!) : "background";

    private static string NameOf(Thing thing) => PathInspector.NameOf(thing.Source as ShapeDescription);

    private static Vector3 Point(Textbook.Vector v) => new((float)v.X, (float)v.Y, (float)v.Z);

    private static Numerics.Rgb Single(Textbook.Rgb c) => new((float)c.R, (float)c.G, (float)c.B);

    private static double[] Array(Textbook.Rgb c) => [c.R, c.G, c.B];
}
