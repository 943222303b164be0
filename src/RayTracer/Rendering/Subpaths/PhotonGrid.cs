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
    private const uint BucketsOfY = 19349663;
    private const uint BucketsOfZ = 83492791;
    private const float Farthest = 1e9f;
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
    /// <param name="radius">The greatest distance from a point.</param>
    public void Build(LightVertices vertices, float radius)
    {
        (_inverseWidth, _radius2) = (1 / (2 * radius), radius * radius);
        MakeRoom(vertices.Count);
        new Span<uint>(_first.Pointer, (int)_mask + 2).Clear();
        for (int i = 0; i < vertices.Count; i++)
        {
            if (IsMerged(vertices.Vertices[i]))
            {
                _first.Pointer[Bucket(vertices.Vertices[i].Point) + 1]++;
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

            _photons.Pointer[_first.Pointer[Bucket(vertex.Point) + 1]++] = new()
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

    /// <summary>Finds the photons near points.</summary>
    /// <param name="points">The points.</param>
    /// <param name="active">The lanes in use.</param>
    /// <param name="found">Takes the numbers of each lane's photons.</param>
    /// <returns>The most photons of a lane.</returns>
    public int Find(in Vec3W points, MaskW active, List<uint>[] found)
    {
        foreach (List<uint> list in found)
        {
            list.Clear();
        }

        Vec3W scaled = points * _inverseWidth;
        CellW first = new() { X = Floor(scaled.X - 0.5f), Y = Floor(scaled.Y - 0.5f), Z = Floor(scaled.Z - 0.5f) };
        for (int row = 0; row < RowsOfPoint; row++)
        {
            CellW cell = first;
            cell.Y += (uint)row & 1;
            cell.Z += (uint)row >> 1;
            UIntW bucket = (((cell.Y * BucketsOfY) ^ (cell.Z * BucketsOfZ)) + cell.X) & _mask;
            MaskW isLast = active & UIntW.Equal(bucket, _mask);
            Find(points, cell, UIntW.Gather(_first.Pointer, bucket), UIntW.Gather(_first.Pointer, isLast.Select(_mask + 1, bucket + 2u)), active, found);
            if (isLast.Any)
            {
                // After the last bucket comes the first.
                Find(points, cell, 0u, _first.Pointer[1], isLast, found);
            }
        }

        int most = 0;
        foreach (List<uint> list in found)
        {
            most = Math.Max(most, list.Count);
        }

        return most;
    }

    // Of the photons of a cell and its neighbour along x, and of others with the same hash.
    private void Find(in Vec3W points, in CellW cell, UIntW next, UIntW end, MaskW active, List<uint>[] found)
    {
        for (MaskW has = active & next < end; has.Any; has = active & next < end)
        {
            UIntW at = has.Select(next, 0u) * Photon.Numbers;
            float* numbers = (float*)_photons.Pointer;
            Vec3W point = Vec3W.Gather(numbers, at);
            Vec3W away = point - points;
            MaskW isNear = has & Vec3W.Dot(away, away) < _radius2;
            if (isNear.Any)
            {
                Vec3W scaled = point * _inverseWidth;
                isNear &= (Floor(scaled.X) - cell.X < 2u) & UIntW.Equal(Floor(scaled.Y), cell.Y) & UIntW.Equal(Floor(scaled.Z), cell.Z);
                for (uint lanes = isNear.Bits; lanes != 0; lanes &= lanes - 1)
                {
                    int lane = BitOperations.TrailingZeroCount(lanes);
                    found[lane].Add(next[lane]);
                }
            }

            next += 1u;
        }
    }

    // In media, vertices are only connected.
    private static bool IsMerged(in LightVertex vertex) => (vertex.State & PathState.IsInMedium) == 0;

    private static UIntW Floor(FloatW x) => FloatW.Max(FloatW.Min(FloatW.Floor(x), Farthest), -Farthest).ToIntInRange();

    private static uint Floor(float x) => (uint)(int)float.Clamp(float.Floor(x), -Farthest, Farthest);

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

    // With primes of Teschner et al. 2003; cells that are neighbours along x have neighbouring buckets.
    private uint Bucket(Vector3 point)
    {
        Vector3 scaled = point * _inverseWidth;
        return (((Floor(scaled.Y) * BucketsOfY) ^ (Floor(scaled.Z) * BucketsOfZ)) + Floor(scaled.X)) & _mask;
    }

    private struct CellW
    {
        public UIntW X, Y, Z;
    }
}
