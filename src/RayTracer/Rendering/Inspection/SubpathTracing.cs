using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Follows single samples of a pixel once more where paths come from the camera and from the lights: all light paths of the sample's pass, then the
/// camera's path, and those light paths again that brought light to the pixel.
/// </summary>
internal sealed class SubpathTracing
{
    private readonly int _mostWays;
    private readonly Tile _pixel;
    private readonly ArrivalLog _log;
    private readonly LightPass _pass;
    private readonly PathRecorder _camera;
    private readonly PathRecorder _light;
    private readonly Func<uint, int, int> _followLight;
    private readonly Wavefront _wavefront;

    /// <summary>Prepares.</summary>
    /// <param name="scene">A scene whose integrator traces light.</param>
    /// <param name="x">The pixel's column.</param>
    /// <param name="y">The pixel's row.</param>
    /// <param name="mostWays">The number of ways that are listed: the brightest ones.</param>
    public SubpathTracing(Scene scene, int x, int y, int mostWays)
    {
        _mostWays = mostWays;
        _pixel = new(x, y, 1, 1);
        _log = new((uint)((y * scene.Render.Width) + x));
        _pass = new(scene, new() { Crop = _pixel }, Environment.ProcessorCount, (uint)scene.Render.Seed) { Recorded = _log };
        _camera = new(scene);
        _light = new(scene, asks: false);
        _followLight = _pass.Follower(_light);
        _wavefront = new(scene, 1, 1, _camera, _pass);
    }

    /// <summary>Follows a sample.</summary>
    /// <param name="sample">The sample.</param>
    public TracedPath Trace(int sample)
    {
        _pass.Trace(sample, default);
        _pass.Splats.Drop();
        _wavefront.Observe(_pixel, new(sample, sample + 1));
        TracedPath path = _camera.Paths().Single();
        List<Arrival> arrivals = _log.Take();
        PathVertex[] vertices = [.. path.Vertices];
        Rgb sum = Sum(arrivals, a => a.To == 1);
        for (int i = 0; i < vertices.Length; i++)
        {
            // Boundaries that are crossed have the number of what is met behind them.
            bool isVertex = i == vertices.Length - 1 || vertices[i + 1].Number != vertices[i].Number;
            uint number = isVertex ? vertices[i].Number + 2 : 0;
            Rgb emitted = sum + Sum(arrivals, a => a.To == number && a.From == 0);
            Rgb after = emitted + Sum(arrivals, a => a.To == number && a.From > 0);
            Arrival met = arrivals.Find(a => a.To == number && a.From == 0);
            TracedEmission? emission = vertices[i].Emission is { } light ? light with { Weight = met.Alone.IsBlack ? 0 : met.Light.Luminance / met.Alone.Luminance } : null;
            vertices[i] = vertices[i] with { Before = sum, AfterEmission = emitted, AfterAmbient = emitted, After = after, Emission = emission };
            sum = after;
        }

        Dictionary<Arrival, int> asked = AnswerQuestions(arrivals, vertices);
        Arrival[] brightest = [.. arrivals.OrderByDescending(a => a.Light.Luminance).Take(_mostWays)];
        FindLightPaths(brightest);
        return path with { Radiance = sum, Vertices = vertices, Ways = [.. brightest.Select(a => WayOf(a, sample, vertices, asked))] };
    }

    // What vertices asked of lights, and what came of it; returns the lights of what arrived.
    private Dictionary<Arrival, int> AnswerQuestions(List<Arrival> arrivals, PathVertex[] vertices)
    {
        Dictionary<Arrival, int> lights = [];
        for (int i = 0; i < vertices.Length; i++)
        {
            IReadOnlyList<LightQuestion> questions = _camera.Questions(0, i);
            foreach (Arrival arrival in arrivals.Where(a => a.From == 1 && a.To == vertices[i].Number + 2))
            {
                Vector3 direction = (arrival.Point - vertices[i].Position!.Value).Unit();
                LightQuestion? nearest = questions.Where(q => !q.IsAnswered).MaxBy(q => q.Answer.Direction.Dot(direction));
                nearest?.Weigh(arrival.Light.Luminance / arrival.Alone.Luminance);
                nearest?.Wait(new(nearest.Answer.Light, arrival.Light, Rgb.White), nearest.Expected * vertices[i].Throughput * vertices[i].Dispersion);
                lights[arrival] = nearest?.Answer.Light ?? -1;
            }

            vertices[i] = vertices[i] with { Lights = [.. questions.Select(q => q.Settle())] };
        }

        return lights;
    }

    private static Rgb Sum(List<Arrival> arrivals, Func<Arrival, bool> which) => arrivals.Where(which).Aggregate(Rgb.Black, (sum, a) => sum + a.Light);

    // Photons do not keep the numbers of their paths, which nobody else asks for.
    private unsafe void FindLightPaths(Span<Arrival> arrivals)
    {
        Dictionary<(Vector3, uint), uint> found = [];
        foreach (Arrival arrival in arrivals)
        {
            if (arrival.IsMerge)
            {
                found[(arrival.Point, arrival.From)] = 0;
            }
        }

        for (int i = 0; found.Count > 0 && i < _pass.Vertices.Count; i++)
        {
            ref LightVertex vertex = ref _pass.Vertices.Vertices[i];
            (Vector3, uint) key = (vertex.Point, (vertex.State & PathState.VertexMask) + 2);
            if (found.ContainsKey(key))
            {
                found[key] = vertex.Path;
            }
        }

        foreach (ref Arrival arrival in arrivals)
        {
            arrival = arrival.IsMerge ? arrival with { LightPath = found[(arrival.Point, arrival.From)] } : arrival;
        }
    }

    private TracedWay WayOf(Arrival arrival, int sample, PathVertex[] vertices, Dictionary<Arrival, int> asked)
    {
        PathVertex? end = Array.FindLast(vertices, v => v.Number + 2 == arrival.To);
        TracedWay way = new((int)arrival.From, (int)arrival.To, arrival.IsMerge, arrival.Light, arrival.Alone)
        {
            Factors = arrival.Factors.All,
            CameraEnd = arrival.To == 1 ? vertices[0].Origin : end?.Position,
        };
        if (arrival.From < 2)
        {
            return arrival.From == 0 ? way with { Light = end?.Emission?.Light ?? -1 } : way with { LightEnd = arrival.Point, Light = asked.GetValueOrDefault(arrival, -1) };
        }

        int light = _followLight(arrival.LightPath, sample);
        uint last = arrival.From - 2;
        return way with { Light = light, LightEnd = arrival.Point, LightPath = [.. _light.Paths().Single().Vertices.TakeWhile(v => v.Number <= last)] };
    }

    // What arrives at one pixel in a pass.
    private sealed class ArrivalLog(uint pixel) : IArrivals
    {
        private readonly List<Arrival> _arrivals = [];

        public void Add(uint at, in Arrival arrival)
        {
            if (at == pixel && !arrival.Light.IsBlack)
            {
                lock (_arrivals)
                {
                    _arrivals.Add(arrival);
                }
            }
        }

        // In an order that does not depend on the threads.
        public List<Arrival> Take()
        {
            List<Arrival> sorted = [.. _arrivals.OrderBy(a => a.To).ThenBy(a => a.From).ThenBy(a => a.IsMerge).ThenBy(a => a.LightPath).ThenBy(a => a.Light.Luminance)];
            _arrivals.Clear();
            return sorted;
        }
    }
}
