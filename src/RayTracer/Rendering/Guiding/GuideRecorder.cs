using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Takes down where learning paths go, and when they have ended, hands over what light they found in each direction that they were scattered
/// into: by how much it brightened the point that they came from, for one unit of what they carried there. So its expectation is the integral
/// of radiance times BSDF times cosine, without what was found by sampling lights from the point itself.
/// </summary>
/// <param name="sums">Takes the records; null where only the box of all points is wanted.</param>
/// <param name="units">The number of units of the sums in one unit of radiance.</param>
internal sealed unsafe class GuideRecorder(GuideSums? sums, double units) : PathObserver
{
    /// <summary>The most that a record counts, in units.</summary>
    public const double Largest = 1L << 33;

    /// <summary>The most records of a path: those of longer ones would count little.</summary>
    public const int MostOfPath = 64;
    private readonly Stack<int> _free = [];

    // Lanes are read one by one from memory, which is quicker than from a register.
    private readonly PinnedBuffer<LanesW> _lanes = new(1);
    private Vertex[] _vertices = [];
    private int[] _heads = [];

    /// <summary>A corner of the box of all points.</summary>
    public Vector3 Least { get; private set; } = new(float.PositiveInfinity);

    /// <summary>The corner opposite.</summary>
    public Vector3 Most { get; private set; } = new(float.NegativeInfinity);

    /// <inheritdoc/>
    public override void Scattered(
        PathStream stream, uint* index, in MaskW active, in MaskW alive, Material material, in SurfaceW surface, in ScatterW scatter,
        bool isByLobe)
    {
        ref LanesW lanes = ref *_lanes.Pointer;
        GuideMap.ToSquare(scatter.Direction, out lanes.U, out lanes.V);
        lanes.Point = surface.Point;
        float* numbers = (float*)_lanes.Pointer;
        for (uint rest = alive.Except(scatter.Delta).Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            uint i = index[lane];
            Add((int)stream.Path[i], new()
            {
                Point = new(numbers[lane], numbers[FloatW.Count + lane], numbers[(2 * FloatW.Count) + lane]),
                U = numbers[(3 * FloatW.Count) + lane],
                V = numbers[(4 * FloatW.Count) + lane],
                Carried = new(stream.ThroughputR[i], stream.ThroughputG[i], stream.ThroughputB[i]),
            });
        }
    }

    /// <inheritdoc/>
    public override void EndStep(FinishedPaths finished, PathStream next)
    {
        // Only now is there all light that the last vertex was given by sampling lights.
        for (int i = 0; i < next.Count; i++)
        {
            int path = (int)next.Path[i];
            if (path < _heads.Length && _heads[path] is > 0 and int head && !_vertices[head].HasBefore)
            {
                _vertices[head].Before = new(next.RadianceR[i], next.RadianceG[i], next.RadianceB[i]);
                _vertices[head].HasBefore = true;
            }
        }
    }

    /// <inheritdoc/>
    public override void Finish(uint path, int pixel, Rgb radiance, Rgb sample)
    {
        if (path >= _heads.Length)
        {
            return;
        }

        for (int at = _heads[path]; at > 0; at = _vertices[at].Next)
        {
            ref Vertex vertex = ref _vertices[at];
            sums?.Add(vertex.Point, vertex.U, vertex.V, Value(vertex, radiance));
            _free.Push(at);
        }

        _heads[path] = 0;
    }

    private long Value(in Vertex vertex, Rgb radiance)
    {
        (Rgb from, Rgb by) = (vertex.Before, vertex.Carried);
        double light = Gain(radiance.R, from.R, by.R) + Gain(radiance.G, from.G, by.G) + Gain(radiance.B, from.B, by.B);
        double value = light / 3 * units;

        // Also what is no number.
        return value > 0 ? (long)Math.Min(value, Largest) : 0;
    }

    private static double Gain(float after, float before, float carried) => carried > 0 ? ((double)after - before) / carried : 0;

    private void Add(int path, Vertex vertex)
    {
        Least = Vector3.Min(Least, vertex.Point);
        Most = Vector3.Max(Most, vertex.Point);
        if (path >= _heads.Length)
        {
            Array.Resize(ref _heads, Math.Max(path + 1, 2 * _heads.Length));
        }

        vertex.Next = _heads[path];
        vertex.Number = vertex.Next > 0 ? _vertices[vertex.Next].Number + 1 : 1;
        if (vertex.Number > MostOfPath)
        {
            return;
        }

        int at = Take();
        _vertices[at] = vertex;
        _heads[path] = at;
    }

    // A free place; 0 is none.
    private int Take()
    {
        if (_free.Count == 0)
        {
            int count = Math.Max(_vertices.Length, 1);
            Array.Resize(ref _vertices, Math.Max(1024, 2 * _vertices.Length));
            for (int i = _vertices.Length - 1; i >= count; i--)
            {
                _free.Push(i);
            }
        }

        return _free.Pop();
    }

    private struct LanesW
    {
        public Vec3W Point;
        public FloatW U, V;
    }

    private struct Vertex
    {
        public int Next;
        public int Number;
        public Vector3 Point;
        public float U, V;
        public Rgb Carried;
        public Rgb Before;
        public bool HasBefore;
    }
}
