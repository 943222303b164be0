using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>
/// Takes down what happens to the paths of one pixel.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="asks">True for paths from the camera, which ask lights.</param>
internal sealed unsafe partial class PathRecorder(Scene scene, bool asks = true) : PathObserver
{
    private readonly LightQuestions _questions = new(scene);
    private readonly EmitterLookup _emitters = new(scene);
    private readonly List<LitPoint> _waiting = [];
    private SampleRange _samples;
    private Path[] _paths = [];
    private Path[] _packet = [];
    private RgbW _lightWeight;
    private UIntW _pixelKey;

    /// <inheritdoc/>
    public override void Begin(in Tile tile, SampleRange samples)
    {
        _samples = samples;
        _pixelKey = Hash.PixelKey((uint)scene.Render.Seed, (uint)((tile.Y * scene.Render.Width) + tile.X));
        _waiting.Clear();
        _paths = [.. Enumerable.Range(0, samples.Count).Select(_ => new Path())];
    }

    /// <summary>All paths, once they have ended.</summary>
    public IEnumerable<TracedPath> Paths() => _paths.Select((p, i) => new TracedPath(_samples.First + i, p.Radiance, [.. p.Vertices.Zip(p.Questions, (v, q) => v with { Lights = [.. q.Select(l => l.Settle())] })]));

    /// <summary>What vertices of a path ask, where the renderer's answers come from elsewhere.</summary>
    /// <param name="path">The path's place among the samples.</param>
    /// <param name="vertex">The vertex's place on its path.</param>
    public IReadOnlyList<LightQuestion> Questions(int path, int vertex) => _paths[path].Questions[vertex];

    /// <inheritdoc/>
    public override void Missed(PathStream stream, uint* index, in MaskW lanes, in RgbW arriving)
    {
        RgbW alone = scene.Background;
        scene.Environment?.Evaluate(stream.PickDirection(index), out alone);
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            uint i = index[lane];
            Path path = _paths[stream.Path[i]];
            Rgb sent = Lane(alone, lane);
            path.Emission = sent.IsBlack ? null : new(scene.SampledEnvironment is null ? -1 : scene.SampledLights.Count - 1, sent, null, null, Share(Lane(arriving, lane), sent));
            path.Add(Arrival(stream, i, PathEvent.Missed), []);
        }
    }

    /// <inheritdoc/>
    public override void BeginPacket(PathStream stream, uint* index, in MaskW lanes)
    {
        _packet = [.. Enumerable.Range(0, FloatW.Count).Select(lane => _paths[stream.Path[index[lane]]])];
        foreach (Path path in _packet)
        {
            path.Lit.Clear();
            path.Emission = null;
        }

        Gathered(stream, index, lanes, stream.PickRadiance(index), true);
    }

    /// <inheritdoc/>
    public override void Emitted(ShadingGroup group, PathStream stream, uint* index, in MaskW lanes, in RgbW light, in RgbW radiance)
    {
        Gathered(stream, index, lanes, radiance, true);
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            _paths[stream.Path[index[lane]]].Emitted = Lane(light, lane);
        }
    }

    /// <inheritdoc/>
    public override void Brightened(PathStream stream, uint* index, in MaskW lanes, in RgbW light, in RgbW radiance) =>
        Gathered(stream, index, lanes, radiance, false);

    /// <inheritdoc/>
    public override void BeginLights(in RgbW weight) => _lightWeight = weight;

    /// <inheritdoc/>
    public override void Lit(int light, in MaskW lanes, in RgbW radiance, bool isWaiting)
    {
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            LitPoint point = new(light, Lane(radiance, lane), Lane(_lightWeight, lane));
            _packet[lane].Lit.Add(point);
            if (isWaiting)
            {
                _waiting.Add(point);
            }
        }
    }

    /// <inheritdoc/>
    public override void LitInMedium(int light, in MaskW lanes, in RgbW radiance)
    {
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            _packet[lane].Lit.Add(new(light, Lane(radiance, lane), Rgb.White));
        }
    }

    /// <inheritdoc/>
    public override void Settle(int* hits)
    {
        for (int i = 0; i < _waiting.Count; i++)
        {
            _waiting[i].Settle(isFree: hits[i] < 0);
        }

        _waiting.Clear();
    }

    /// <inheritdoc/>
    public override void Scattered(
        PathStream stream, uint* index, in MaskW active, in MaskW alive, Material material, in SurfaceW surface, in ScatterW scatter,
        bool isByLobe)
    {
        ShadingGroup group = scene.Groups[scene.GroupOfPrimitive[(int)stream.Primitive[index[BitOperations.TrailingZeroCount(active.Bits)]]]];
        material.Evaluate(surface, scatter.Direction, out RgbW bsdf, out FloatW pdf);
        RgbW sent = default;
        if (group.Traits.Emits)
        {
            material.Emission(SurfaceShader.CosineOfEmission(surface), surface.U, surface.V, out sent);
        }

        FloatW cosine = FloatW.Abs(Vec3W.Dot(scatter.Direction, surface.Facing));
        MaskW dropped = SurfaceShader.Dropped(surface, scatter.Direction);
        RgbW dispersion = Questions(group, material, surface, stream, index, out List<LightQuestion>[] asked);
        for (uint rest = active.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            bool Is(MaskW mask) => (mask.Bits >> lane & 1) != 0;
            Path path = _paths[stream.Path[index[lane]]];
            uint state = stream.State[index[lane]];
            Rgb weight = Lane(scatter.Weight, lane);
            PathEvent met = Is(scatter.Absorbed) ? PathEvent.Absorbed : !Is(alive) ? PathEvent.Ended : Is(scatter.Specular) ? PathEvent.Specular : PathEvent.Diffuse;
            Rgb value = Lane(bsdf, lane);
            PathVertex vertex = Arrival(stream, index[lane], met) with
            {
                Position = Lane(surface.Point, lane),
                Normal = Lane(surface.Facing, lane),
                Primitive = (int)stream.Primitive[index[lane]],
                Instance = InstanceOf(stream, index[lane]),
                Weight = met == PathEvent.Absorbed ? Rgb.Black : weight,
                Pdf = met == PathEvent.Diffuse ? pdf[lane] : null,
                Bsdf = met == PathEvent.Diffuse && !isByLobe && IsProduct(weight, value, cosine[lane] / pdf[lane]) ? value : null,
                Cosine = cosine[lane],
                Dispersion = Lane(dispersion, lane),
                AfterEmission = path.AfterEmission,
                AfterAmbient = path.AfterAmbient,
            };
            path.Emission = Lane(sent, lane) is { IsBlack: false } radiance ? Met(path, vertex, group, stream, index[lane], radiance) : null;
            path.Add(vertex with { End = met == PathEvent.Ended ? EndOf(vertex, state, Is(dropped)) : PathEnd.None }, Answer(path, asked, lane, vertex, state));
        }
    }

    /// <inheritdoc/>
    public override void ScatteredInMedium(PathStream stream, uint* index, in MaskW active, in MaskW alive, in Vec3W point, in FloatW pdf)
    {
        UIntW media = UIntW.Pick(stream.Media, index);
        Begin(null, stream, index);
        FloatW time = scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f;
        List<LightQuestion>[] asked = _questions.InMedia(point, stream.PickDirection(index), media, time);
        for (uint rest = active.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            bool goesOn = (alive.Bits >> lane & 1) != 0;
            Path path = _paths[stream.Path[index[lane]]];
            PathVertex vertex = Arrival(stream, index[lane], goesOn ? PathEvent.Diffuse : PathEvent.Ended) with
            {
                Position = Lane(point, lane),
                Weight = Rgb.White,
                Pdf = goesOn ? pdf[lane] : null,
                Bsdf = goesOn ? new(pdf[lane], pdf[lane], pdf[lane]) : null,
                Cosine = 1,
            };
            path.Add(vertex with { End = goesOn ? PathEnd.None : EndOf(vertex, stream.State[index[lane]], false) }, Answer(path, asked, lane, vertex, stream.State[index[lane]]));
        }
    }

    /// <inheritdoc/>
    public override void Crossed(PathStream stream, uint* index, in MaskW active, in SurfaceW surface)
    {
        for (uint rest = active.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            PathVertex vertex = Arrival(stream, index[lane], PathEvent.Specular) with
            {
                Position = Lane(surface.Point, lane),
                Normal = Lane(surface.Facing, lane),
                Primitive = (int)stream.Primitive[index[lane]],
                Instance = InstanceOf(stream, index[lane]),
                Weight = Rgb.White,
            };
            _paths[stream.Path[index[lane]]].Add(vertex, []);
        }
    }

    /// <inheritdoc/>
    public override void EndStep(FinishedPaths finished, PathStream next)
    {
        for (int i = 0; i < next.Count; i++)
        {
            _paths[next.Path[i]].Close(new(next.RadianceR[i], next.RadianceG[i], next.RadianceB[i]), new(next.ThroughputR[i], next.ThroughputG[i], next.ThroughputB[i]));
        }

        for (int i = 0; i < finished.Count; i++)
        {
            float* r = finished.Radiance + i;
            _paths[finished.Path[i]].Close(new(*r, r[finished.Stride], r[2 * finished.Stride]), null);
        }

        finished.Clear();
    }
}
