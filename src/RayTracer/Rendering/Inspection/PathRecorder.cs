using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Takes down what happens to the paths of one pixel.
/// </summary>
/// <param name="scene">The scene.</param>
internal sealed unsafe class PathRecorder(Scene scene) : PathObserver
{
    private SampleRange _samples;
    private Path[] _paths = [];

    /// <inheritdoc/>
    public override void Begin(in Tile tile, SampleRange samples)
    {
        _samples = samples;
        _paths = [.. Enumerable.Range(0, samples.Count).Select(_ => new Path())];
    }

    /// <summary>All paths, once they have ended.</summary>
    public IEnumerable<TracedPath> Paths() => _paths.Select((p, i) => new TracedPath(_samples.First + i, p.Radiance, p.Vertices));

    /// <inheritdoc/>
    public override void Missed(PathStream stream, uint* index, in MaskW lanes, in RgbW arriving)
    {
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            uint i = index[BitOperations.TrailingZeroCount(rest)];
            _paths[stream.Path[i]].Vertices.Add(Arrival(stream, i, PathEvent.Missed));
        }
    }

    /// <inheritdoc/>
    public override void BeginPacket(PathStream stream, uint* index, in MaskW lanes) =>
        Gathered(stream, index, lanes, stream.PickRadiance(index), true);

    /// <inheritdoc/>
    public override void Emitted(ShadingGroup group, PathStream stream, uint* index, in MaskW lanes, in RgbW light, in RgbW radiance) =>
        Gathered(stream, index, lanes, radiance, true);

    /// <inheritdoc/>
    public override void Brightened(PathStream stream, uint* index, in MaskW lanes, in RgbW light, in RgbW radiance) =>
        Gathered(stream, index, lanes, radiance, false);

    /// <inheritdoc/>
    public override void Scattered(
        PathStream stream, uint* index, in MaskW active, in MaskW alive, Material material, in SurfaceW surface, in ScatterW scatter,
        bool isByLobe)
    {
        material.Pdf(surface, scatter.Direction, out FloatW pdf);
        uint specular = scatter.Specular.Bits;
        uint absorbed = scatter.Absorbed.Bits;
        for (uint rest = active.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            uint bit = 1u << lane;
            Path path = _paths[stream.Path[index[lane]]];
            PathEvent met = (absorbed & bit) != 0 ? PathEvent.Absorbed
                : (alive.Bits & bit) == 0 ? PathEvent.Ended
                : (specular & bit) != 0 ? PathEvent.Specular : PathEvent.Diffuse;
            path.Vertices.Add(Arrival(stream, index[lane], met) with
            {
                Position = Lane(surface.Point, lane),
                Normal = Lane(surface.Facing, lane),
                Primitive = (int)stream.Primitive[index[lane]],
                Instance = scene.World.Instances is null ? 0 : (int)stream.Instance[index[lane]],
                Weight = met == PathEvent.Absorbed ? Rgb.Black : Lane(scatter.Weight, lane),
                Pdf = met == PathEvent.Diffuse ? pdf[lane] : null,
                AfterEmission = path.AfterEmission,
                AfterAmbient = path.AfterAmbient,
            });
        }
    }

    /// <inheritdoc/>
    public override void ScatteredInMedium(PathStream stream, uint* index, in MaskW active, in MaskW alive, in Vec3W point, in FloatW pdf)
    {
        for (uint rest = active.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            bool goesOn = (alive.Bits >> lane & 1) != 0;
            _paths[stream.Path[index[lane]]].Vertices.Add(Arrival(stream, index[lane], goesOn ? PathEvent.Diffuse : PathEvent.Ended) with
            {
                Position = Lane(point, lane),
                Weight = Rgb.White,
                Pdf = goesOn ? pdf[lane] : null,
            });
        }
    }

    /// <inheritdoc/>
    public override void Crossed(PathStream stream, uint* index, in MaskW active, in SurfaceW surface)
    {
        for (uint rest = active.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            _paths[stream.Path[index[lane]]].Vertices.Add(Arrival(stream, index[lane], PathEvent.Specular) with
            {
                Position = Lane(surface.Point, lane),
                Normal = Lane(surface.Facing, lane),
                Primitive = (int)stream.Primitive[index[lane]],
                Instance = scene.World.Instances is null ? 0 : (int)stream.Instance[index[lane]],
                Weight = Rgb.White,
            });
        }
    }

    /// <inheritdoc/>
    public override void EndStep(FinishedPaths finished, PathStream next)
    {
        for (int i = 0; i < next.Count; i++)
        {
            _paths[next.Path[i]].Close(new(next.RadianceR[i], next.RadianceG[i], next.RadianceB[i]));
        }

        for (int i = 0; i < finished.Count; i++)
        {
            float* r = finished.Radiance + i;
            _paths[finished.Path[i]].Close(new(*r, r[finished.Stride], r[2 * finished.Stride]));
        }

        finished.Clear();
    }

    // Ambient light comes after a surface's own.
    private void Gathered(PathStream stream, uint* index, MaskW lanes, in RgbW radiance, bool isEmission)
    {
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            Path path = _paths[stream.Path[index[lane]]];
            path.AfterAmbient = Lane(radiance, lane);
            path.AfterEmission = isEmission ? path.AfterAmbient : path.AfterEmission;
        }
    }

    private static PathVertex Arrival(PathStream stream, uint i, PathEvent met)
    {
        Rgb before = new(stream.RadianceR[i], stream.RadianceG[i], stream.RadianceB[i]);
        return new()
        {
            Event = met,
            Origin = new(stream.OriginX[i], stream.OriginY[i], stream.OriginZ[i]),
            Direction = new(stream.DirectionX[i], stream.DirectionY[i], stream.DirectionZ[i]),
            Throughput = new(stream.ThroughputR[i], stream.ThroughputG[i], stream.ThroughputB[i]),
            Before = before,
            AfterEmission = before,
            AfterAmbient = before,
            Number = stream.State[i] & PathState.VertexMask,
        };
    }

    private static Vector3 Lane(in Vec3W v, int lane) => new(v.X[lane], v.Y[lane], v.Z[lane]);

    private static Rgb Lane(in RgbW c, int lane) => new(c.R[lane], c.G[lane], c.B[lane]);

    private sealed class Path
    {
        public List<PathVertex> Vertices { get; } = [];

        public Rgb Radiance { get; private set; }

        public Rgb AfterEmission { get; set; }

        public Rgb AfterAmbient { get; set; }

        // Where nothing is met, all that is added is the background.
        public void Close(Rgb radiance)
        {
            Radiance = radiance;
            PathVertex last = Vertices[^1];
            Vertices[^1] = last.Event == PathEvent.Missed
                ? last with { AfterEmission = radiance, AfterAmbient = radiance, After = radiance }
                : last with { After = radiance };
        }
    }
}
