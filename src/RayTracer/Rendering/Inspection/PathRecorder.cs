using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Takes down what becomes of the paths of one pixel, in the stages that shade them. It only reads; renders have none.
/// </summary>
/// <param name="scene">The scene.</param>
internal sealed unsafe class PathRecorder(Scene scene)
{
    private SampleRange _samples;
    private Path[] _paths = [];

    /// <summary>Prepares for some samples.</summary>
    public void Begin(SampleRange samples)
    {
        _samples = samples;
        _paths = [.. Enumerable.Range(0, samples.Count).Select(_ => new Path())];
    }

    /// <summary>All paths, once they have ended.</summary>
    public IEnumerable<TracedPath> Paths() => _paths.Select((p, i) => new TracedPath(_samples.First + i, p.Radiance, p.Vertices));

    /// <summary>Takes down paths that meet nothing.</summary>
    public void Missed(PathStream stream, uint* index, MaskW lanes)
    {
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            Path path = _paths[stream.Path[index[BitOperations.TrailingZeroCount(rest)]]];
            path.Pending = Arrival(stream, index[BitOperations.TrailingZeroCount(rest)], PathEvent.Missed);
        }
    }

    /// <summary>Takes down what paths have gathered after a surface's own light.</summary>
    public void Emitted(UIntW path, MaskW lanes, in RgbW radiance)
    {
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            _paths[path[lane]].AfterEmission = Lane(radiance, lane);
        }
    }

    /// <summary>Takes down what paths have gathered after ambient light.</summary>
    public void Brightened(UIntW path, MaskW lanes, in RgbW radiance)
    {
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            _paths[path[lane]].AfterAmbient = Lane(radiance, lane);
        }
    }

    /// <summary>Takes down how paths go on from a surface.</summary>
    public void Scattered(PathStream stream, uint* index, MaskW active, MaskW alive, Material material, in SurfaceW surface, in ScatterW scatter)
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
            path.Pending = Arrival(stream, index[lane], met) with
            {
                Position = Lane(surface.Point, lane),
                Normal = Lane(surface.Facing, lane),
                Primitive = (int)stream.Primitive[index[lane]],
                Instance = scene.World.Instances is null ? 0 : (int)stream.Instance[index[lane]],
                Weight = met == PathEvent.Absorbed ? Rgb.Black : Lane(scatter.Weight, lane),
                Pdf = met == PathEvent.Diffuse ? pdf[lane] : null,
                AfterEmission = path.AfterEmission,
                AfterAmbient = path.AfterAmbient,
            };
        }
    }

    /// <summary>Takes down how paths go on from where a medium scattered them.</summary>
    public void InMedium(PathStream stream, uint* index, MaskW active, MaskW alive, in Vec3W point, in FloatW pdf)
    {
        for (uint rest = active.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            bool goesOn = (alive.Bits >> lane & 1) != 0;
            Path path = _paths[stream.Path[index[lane]]];
            path.Pending = Arrival(stream, index[lane], goesOn ? PathEvent.Diffuse : PathEvent.Ended) with
            {
                Position = Lane(point, lane),
                Weight = Rgb.White,
                Pdf = goesOn ? pdf[lane] : null,
            };
        }
    }

    /// <summary>Takes down where paths go straight through a boundary.</summary>
    public void Crossed(PathStream stream, uint* index, MaskW active, in SurfaceW surface)
    {
        for (uint rest = active.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            _paths[stream.Path[index[lane]]].Pending = Arrival(stream, index[lane], PathEvent.Specular) with
            {
                Position = Lane(surface.Point, lane),
                Normal = Lane(surface.Facing, lane),
                Primitive = (int)stream.Primitive[index[lane]],
                Instance = scene.World.Instances is null ? 0 : (int)stream.Instance[index[lane]],
                Weight = Rgb.White,
            };
        }
    }

    /// <summary>Takes down what all paths of a step have gathered at its end, and takes the finished ones away.</summary>
    public void Take(FinishedPaths finished, PathStream next)
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

        public PathVertex? Pending { get; set; }

        // Where nothing is met, all that is added is the background.
        public void Close(Rgb radiance)
        {
            Radiance = radiance;
            Vertices.Add(Pending!.Event == PathEvent.Missed
                ? Pending with { AfterEmission = radiance, AfterAmbient = radiance, After = radiance }
                : Pending with { After = radiance });
        }
    }
}
