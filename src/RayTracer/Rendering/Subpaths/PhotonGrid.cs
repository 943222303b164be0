using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>A vertex of a light path, as far as merges need it.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 4)]
internal struct Photon
{
    /// <summary>Its size in numbers of 32 bits.</summary>
    public const uint Numbers = 12;

    /// <summary>Where it is.</summary>
    public Vector3 Point;

    /// <summary>Number of the vertex on its path, from 0, and the state's bits.</summary>
    public uint State;

    /// <summary>Unit direction in which the light travels.</summary>
    public Vector3 Direction;

    /// <summary>The light's power; without the colour of its wavelength, if it has one.</summary>
    public Rgb Power;

    /// <summary>The partial sums that merges need (<see cref="SubpathSumsW"/>).</summary>
    public float Vcm, Vm;
}

/// <summary>
/// Finds the light paths' vertices near a point. Cells are as wide as the circle in which vertices are merged, so that eight of them cover it; a table
/// of hashes has the vertices of each side by side, in the order of their numbers, and so those near a point always come in the same order.
/// </summary>
internal sealed unsafe class PhotonGrid
{
    private const int RowsOfPoint = 4;
    private PinnedBuffer<uint> _first = new(0);
    private PinnedBuffer<Photon> _photons = new(0);
    private int _capacity;
    private uint _mask;
    private float _inverseWidth;
    private float _radius2;

    /// <summary>The photons, bucket by bucket.</summary>
    public Photon* Photons => _photons.Pointer;

    /// <summary>Sorts vertices into cells.</summary>
    /// <param name="vertices">The vertices.</param>
    /// <param name="radius">How far from a point they may be.</param>
    public void Build(LightVertices vertices, float radius)
    {
        (_inverseWidth, _radius2) = (1 / (2 * radius), radius * radius);
        MakeRoom(vertices.Count);
        new Span<uint>(_first.Pointer, (int)_mask + 2).Clear();
        for (int i = 0; i < vertices.Count; i++)
        {
            if (IsMerged(vertices.Vertices[i]))
            {
                _first.Pointer[Bucket(Cell(vertices.Vertices[i].Point)) + 1]++;
            }
        }

        // Each bucket's start, which its photons then push on to its end: the next one's start.
        uint sum = 0;
        for (uint bucket = 0; bucket <= _mask; bucket++)
        {
            uint count = _first.Pointer[bucket + 1];
            _first.Pointer[bucket + 1] = sum;
            sum += count;
        }

        for (int i = 0; i < vertices.Count; i++)
        {
            ref LightVertex vertex = ref vertices.Vertices[i];
            if (!IsMerged(vertex))
            {
                continue;
            }

            _photons.Pointer[_first.Pointer[Bucket(Cell(vertex.Point)) + 1]++] = new()
            {
                Point = vertex.Point,
                State = vertex.State,
                Direction = vertex.Direction,
                Power = vertex.Power,
                Vcm = vertex.Vcm,
                Vm = vertex.Vm,
            };
        }
    }

    // In media, vertices are only connected.
    private static bool IsMerged(in LightVertex vertex) => (vertex.State & PathState.IsInMedium) == 0;

    /// <summary>Finds the photons near points. What has to be fetched from memory is asked for of all points at once.</summary>
    /// <param name="points">The points.</param>
    /// <param name="lanes">The lanes in use.</param>
    /// <param name="found">Takes the numbers of each lane's photons.</param>
    /// <returns>The most photons of a lane.</returns>
    public int Find(in Vec3W points, uint lanes, List<uint>[] found)
    {
        Rows* rows = stackalloc Rows[16];
        for (uint rest = lanes; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            rows[lane] = RowsOf(new(points.X[lane], points.Y[lane], points.Z[lane]));
        }

        int most = 0;
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            found[lane].Clear();
            for (int range = 0; range < 2 * RowsOfPoint && (lanes >> lane & 1) != 0; range++)
            {
                Find(rows[lane], range, found[lane]);
            }

            most = Math.Max(most, found[lane].Count);
        }

        return most;
    }

    // The four pairs of cells, neighbours along x, around a point: a bucket and the next.
    private Rows RowsOf(Vector3 point)
    {
        Vector3 scaled = point * _inverseWidth;
        Rows rows = new() { Point = point, X = Floor(scaled.X - 0.5f), Y = Floor(scaled.Y - 0.5f), Z = Floor(scaled.Z - 0.5f) };
        for (int row = 0; row < RowsOfPoint; row++)
        {
            uint bucket = Bucket((rows.X, rows.Y + (row & 1), rows.Z + (row >> 1)));
            rows.Begin[row] = _first.Pointer[bucket];
            rows.End[row] = _first.Pointer[Math.Min(bucket + 2, _mask + 1)];
            rows.Begin[RowsOfPoint + row] = 0;

            // After the last bucket comes the first.
            rows.End[RowsOfPoint + row] = bucket == _mask ? _first.Pointer[1] : 0;
        }

        return rows;
    }

    private void Find(in Rows rows, int range, List<uint> found)
    {
        Vector3 point = rows.Point;
        int row = range % RowsOfPoint;
        for (uint i = rows.Begin[range]; i < rows.End[range]; i++)
        {
            Vector3 at = _photons.Pointer[i].Point;
            Vector3 away = at - point;
            float distance2 = (away.X * away.X) + (away.Y * away.Y) + (away.Z * away.Z);
            if (distance2 < _radius2)
            {
                // Other cells may have the same hash.
                (int x, int y, int z) = Cell(at);
                if ((uint)(x - rows.X) < 2 && y == rows.Y + (row & 1) && z == rows.Z + (row >> 1))
                {
                    found.Add(i);
                }
            }
        }
    }

    private static int Floor(float x) => (int)float.Clamp(float.Floor(x), -1e9f, 1e9f);

    private void MakeRoom(int photons)
    {
        uint size = BitOperations.RoundUpToPowerOf2((uint)Math.Max(photons, 2));
        if (size != _mask + 1)
        {
            (_mask, _first) = (size - 1, new(size + 1L));
        }

        if (_capacity < photons)
        {
            _capacity = (int)Math.Min(photons * 9L / 8, Array.MaxLength);
            _photons = new(_capacity);
        }
    }

    private (int X, int Y, int Z) Cell(Vector3 point) => (Floor(point.X * _inverseWidth), Floor(point.Y * _inverseWidth), Floor(point.Z * _inverseWidth));

    // With primes of Teschner et al. 2003; cells that are neighbours along x have neighbouring buckets.
    private uint Bucket((int X, int Y, int Z) cell) => ((((uint)cell.Y * 19349663u) ^ ((uint)cell.Z * 83492791u)) + (uint)cell.X) & _mask;

    private struct Rows
    {
        public Vector3 Point;
        public int X, Y, Z;
        public fixed uint Begin[2 * RowsOfPoint];
        public fixed uint End[2 * RowsOfPoint];
    }
}
