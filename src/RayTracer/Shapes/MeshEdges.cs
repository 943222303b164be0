using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// Which triangles of a mesh share edges. Corners at equal positions count as one, so that seams where uv or normals change do not
/// part neighbours.
/// </summary>
internal sealed class MeshEdges
{
    private readonly MeshData _mesh;
    private readonly int[] _triangles;
    private readonly int[] _welded;

    // Edge e goes out of corner e % 3 of triangle e / 3. Edges whose lesser end is v are from _start[v] to _start[v + 1].
    private readonly int[] _start;
    private readonly int[] _edges;

    /// <summary>Sorts the edges of some triangles by their ends.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="triangles">The triangles that count, whose corners exist.</param>
    public MeshEdges(MeshData mesh, int[] triangles)
    {
        _mesh = mesh;
        _triangles = triangles;
        _welded = Weld(mesh.Positions);
        _start = new int[_welded.Length + 1];
        int count = 3 * triangles.Length;
        for (int e = 0; e < count; e++)
        {
            _start[Math.Min(From(e), To(e)) + 1]++;
        }

        for (int v = 1; v < _start.Length; v++)
        {
            _start[v] += _start[v - 1];
        }

        _edges = new int[count];
        int[] next = _start[..^1];
        for (int e = 0; e < count; e++)
        {
            _edges[next[Math.Min(From(e), To(e))]++] = e;
        }
    }

    /// <summary>True where any two triangles that alone share an edge face different sides.</summary>
    public bool AnyInconsistent()
    {
        bool found = false;
        Parallel.For(0, (_welded.Length + 4095) / 4096, (block, state) =>
        {
            for (int v = block * 4096; v < Math.Min(_welded.Length, (block + 1) * 4096); v++)
            {
                if (IsInconsistent(v))
                {
                    found = true;
                    state.Stop();
                }
            }
        });
        return found;
    }

    /// <summary>Finds which triangles to turn, so that neighbours agree.</summary>
    /// <param name="count">The number of turned triangles.</param>
    /// <param name="unsolved">Edges at which they still do not agree.</param>
    /// <returns>For each triangle, 1 where it is to be turned.</returns>
    public int[] Orient(out int count, out int unsolved)
    {
        int[] opposite = Opposites();
        int[] turned = new int[_triangles.Length];
        Array.Fill(turned, -1);
        List<int> component = [];
        for (int seed = 0; seed < turned.Length; seed++)
        {
            if (turned[seed] < 0)
            {
                Spread(seed, opposite, turned, component);
            }
        }

        count = turned.Count(t => t == 1);
        unsolved = 0;
        for (int e = 0; e < opposite.Length; e++)
        {
            int o = opposite[e];
            unsolved += o > e && (From(e) == From(o)) != (turned[e / 3] != turned[o / 3]) ? 1 : 0;
        }

        return turned;
    }

    // Gives each triangle that can be reached the side of the first; then turns the smaller part.
    private void Spread(int seed, int[] opposite, int[] turned, List<int> component)
    {
        component.Clear();
        component.Add(seed);
        turned[seed] = 0;
        int others = 0;
        for (int i = 0; i < component.Count; i++)
        {
            int triangle = component[i];
            for (int e = 3 * triangle; e < (3 * triangle) + 3; e++)
            {
                int o = opposite[e];
                if (o >= 0 && turned[o / 3] < 0)
                {
                    turned[o / 3] = From(e) == From(o) ? 1 - turned[triangle] : turned[triangle];
                    others += turned[o / 3];
                    component.Add(o / 3);
                }
            }
        }

        if (2 * others > component.Count)
        {
            foreach (int triangle in component)
            {
                turned[triangle] = 1 - turned[triangle];
            }
        }
    }

    private int[] Opposites()
    {
        int[] opposite = new int[_edges.Length];
        Array.Fill(opposite, -1);
        for (int v = 0; v < _welded.Length; v++)
        {
            foreach ((int first, int second) in Pairs(v))
            {
                (opposite[first], opposite[second]) = (second, first);
            }
        }

        return opposite;
    }

    // As Pairs, but without memory: most corners have few edges.
    private bool IsInconsistent(int corner)
    {
        (int first, int end) = (_start[corner], _start[corner + 1]);
        if (end - first > 64)
        {
            return Pairs(corner).Exists(p => From(p.First) == From(p.Second));
        }

        for (int i = first; i < end; i++)
        {
            int far = Far(_edges[i], corner);
            int others = 0;
            bool same = false;
            for (int j = first; j < end; j++)
            {
                if (j != i && Far(_edges[j], corner) == far)
                {
                    others++;
                    same = From(_edges[j]) == From(_edges[i]);
                }
            }

            if (others == 1 && same)
            {
                return true;
            }
        }

        return false;
    }

    // Of the edges whose lesser end is a corner, those that exactly two triangles share.
    private List<(int First, int Second)> Pairs(int corner)
    {
        int first = _start[corner];
        int count = _start[corner + 1] - first;
        if (count < 2)
        {
            return s_none;
        }

        int[] sorted = _edges.AsSpan(first, count).ToArray();
        Array.Sort(sorted, (a, b) => Far(a, corner) != Far(b, corner) ? Far(a, corner).CompareTo(Far(b, corner)) : a.CompareTo(b));
        List<(int, int)> pairs = [];
        for (int i = 0; i < count;)
        {
            int end = i + 1;
            while (end < count && Far(sorted[end], corner) == Far(sorted[i], corner))
            {
                end++;
            }

            if (end - i == 2 && sorted[i] / 3 != sorted[i + 1] / 3)
            {
                pairs.Add((sorted[i], sorted[i + 1]));
            }

            i = end;
        }

        return pairs;
    }

    private static readonly List<(int First, int Second)> s_none = [];

    private int Far(int edge, int near) => From(edge) == near ? To(edge) : From(edge);

    private int From(int edge) => _welded[_mesh.Indices[(3 * _triangles[edge / 3]) + (edge % 3)]];

    private int To(int edge) => _welded[_mesh.Indices[(3 * _triangles[edge / 3]) + ((edge + 1) % 3)]];

    // For each corner, the first one at the same position: an open hash table of corners.
    private static int[] Weld(Vector3[] positions)
    {
        int size = (int)BitOperations.RoundUpToPowerOf2((uint)Math.Max(16, positions.Length + (positions.Length / 2)));
        int[] table = new int[size];
        int[] welded = new int[positions.Length];
        for (int v = 0; v < positions.Length; v++)
        {
            Vector3 p = positions[v];
            if (!p.IsFinite())
            {
                welded[v] = v;
                continue;
            }

            uint slot = Hash(p) & (uint)(size - 1);
            while (table[slot] != 0 && positions[table[slot] - 1] != p)
            {
                slot = (slot + 1) & (uint)(size - 1);
            }

            if (table[slot] == 0)
            {
                table[slot] = v + 1;
            }

            welded[v] = table[slot] - 1;
        }

        return welded;
    }

    // Of equal positions alike, so the zeros are made one.
    private static uint Hash(Vector3 p)
    {
        uint h = (BitConverter.SingleToUInt32Bits(p.X + 0f) * 0x9E3779B1u) ^ (BitConverter.SingleToUInt32Bits(p.Y + 0f) * 0x85EBCA77u) ^ (BitConverter.SingleToUInt32Bits(p.Z + 0f) * 0xC2B2AE3Du);
        h ^= h >> 15;
        h *= 0x2C1B3C6Du;
        return h ^ (h >> 13);
    }
}
