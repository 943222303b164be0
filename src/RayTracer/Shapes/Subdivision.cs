using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// Subdivides meshes: Catmull &amp; Clark (1978), and Loop (1987) with the weights of Warren (1995). Along borders and creases both have the rules of cubic B-splines (Hoppe et al. 1994); a place
/// where more than two of them end stays where it is.
/// </summary>
internal sealed class Subdivision
{
    private readonly PolygonMesh _mesh;
    private readonly MeshTopology _edges;

    // Around each place: the edges, the sharp ones among them with the sum of their other ends, and the sum of all other ends.
    private readonly int[] _valence;
    private readonly int[] _sharp;
    private readonly Vector3[] _sharpEnds;
    private readonly Vector3[] _ends;

    private Subdivision(PolygonMesh mesh)
    {
        _mesh = mesh;
        _edges = MeshTopology.Of(mesh);
        int places = mesh.Positions.Length;
        (_valence, _sharp, _sharpEnds, _ends) = (new int[places], new int[places], new Vector3[places], new Vector3[places]);
        for (int edge = 0; edge < _edges.EdgeCount; edge++)
        {
            (int a, int b) = _edges.Ends(edge);
            AddEnd(a, b, _edges.IsSharp(edge));
            AddEnd(b, a, _edges.IsSharp(edge));
        }
    }

    /// <summary>A mesh of four times as many faces, or for Catmull and Clark's rules, as many as there were corners.</summary>
    public static PolygonMesh Once(PolygonMesh mesh, SubdivisionScheme scheme)
    {
        Subdivision step = new(mesh);
        return scheme == SubdivisionScheme.Loop ? step.Loop() : step.CatmullClark();
    }

    /// <summary>The same mesh, with its places on the surface that subdividing for ever gives.</summary>
    /// <param name="mesh">A mesh of triangles for Loop's rules; of quadrilaterals for Catmull and Clark's.</param>
    /// <param name="scheme">The rules.</param>
    public static Vector3[] Limit(PolygonMesh mesh, SubdivisionScheme scheme)
    {
        Subdivision step = new(mesh);
        Vector3[] diagonals = scheme == SubdivisionScheme.CatmullClark ? step.Diagonals() : [];
        return [.. mesh.Positions.Select((at, v) => step._valence[v] == 0 || step._sharp[v] > 2 ? at
            : step._sharp[v] == 2 ? (step._sharpEnds[v] + (at * 4)) * (1f / 6)
            : scheme == SubdivisionScheme.Loop ? step.LimitOfLoop(v) : step.LimitOfCatmullClark(v, diagonals[v]))];
    }

    private void AddEnd(int at, int other, bool isSharp)
    {
        _valence[at]++;
        _ends[at] += _mesh.Positions[other];
        if (isSharp)
        {
            _sharp[at]++;
            _sharpEnds[at] += _mesh.Positions[other];
        }
    }

    // Warren 1995: the weight of each of n neighbours.
    private static float Weight(int n) => n == 3 ? 3f / 16 : 3f / (8 * n);

    private Vector3 LimitOfLoop(int v)
    {
        int n = _valence[v];
        float weight = 1 / (n + (3 / (8 * Weight(n))));
        return (_mesh.Positions[v] * (1 - (n * weight))) + (_ends[v] * weight);
    }

    // Halstead et al. 1993.
    private Vector3 LimitOfCatmullClark(int v, Vector3 diagonals)
    {
        int n = _valence[v];
        return ((_mesh.Positions[v] * (n * n)) + (_ends[v] * 4) + diagonals) * (1f / (n * (n + 5)));
    }

    // Around each place, the sum of the corners of its quadrilaterals that lie across.
    private Vector3[] Diagonals()
    {
        Vector3[] sums = new Vector3[_mesh.Positions.Length];
        for (int corner = 0; corner < _mesh.Corners.Length; corner++)
        {
            int across = (corner & ~3) + ((corner + 2) & 3);
            sums[_mesh.Corners[corner]] += _mesh.Positions[_mesh.Corners[across]];
        }

        return sums;
    }

    private PolygonMesh Loop()
    {
        Vector3[] opposite = new Vector3[_edges.EdgeCount];
        for (int corner = 0; corner < _mesh.Corners.Length; corner++)
        {
            opposite[_edges.EdgeOf[corner]] += _mesh.Positions[_mesh.Corners[_mesh.Previous(corner / 3, corner)]];
        }

        Vector3 Inner(int edge, Vector3 ends) => (ends * (3f / 8)) + (opposite[edge] * (1f / 8));
        Vector3 Smooth(int v)
        {
            int n = _valence[v];
            return (_mesh.Positions[v] * (1 - (n * Weight(n)))) + (_ends[v] * Weight(n));
        }

        int edges = _mesh.Positions.Length;
        PolygonParts parts = new(_mesh, 4 * _mesh.Corners.Length);
        for (int face = 0; face < _mesh.FaceCount; face++)
        {
            int a = _mesh.Starts[face];
            for (int corner = a; corner < a + 3; corner++)
            {
                int before = _mesh.Previous(face, corner);
                parts.Add(_mesh.Corners[corner], _mesh.Creases[corner], [corner]);
                parts.Add(edges + _edges.EdgeOf[corner], false, [corner, _mesh.Next(face, corner)]);
                parts.Add(edges + _edges.EdgeOf[before], _mesh.Creases[before], [before, corner]);
                parts.End(face);
            }

            for (int corner = a; corner < a + 3; corner++)
            {
                parts.Add(edges + _edges.EdgeOf[corner], false, [corner, _mesh.Next(face, corner)]);
            }

            parts.End(face);
        }

        return parts.Mesh([.. Places(Smooth), .. EdgePoints(Inner)]);
    }

    private PolygonMesh CatmullClark()
    {
        Vector3[] middles = [.. Enumerable.Range(0, _mesh.FaceCount).Select(Middle)];
        Vector3[] around = new Vector3[_mesh.Positions.Length];
        for (int face = 0; face < _mesh.FaceCount; face++)
        {
            for (int corner = _mesh.Starts[face]; corner < _mesh.Starts[face + 1]; corner++)
            {
                around[_mesh.Corners[corner]] += middles[face];
            }
        }

        Vector3 Inner(int edge, Vector3 ends) => (ends + middles[_edges.Faces(edge).First] + middles[_edges.Faces(edge).Second]) * 0.25f;
        Vector3 Smooth(int v)
        {
            // (F + 2R + (n − 3) v) / n, with the mean R of the edges' middles: half of v, and half of the other ends.
            float n = _valence[v];
            return (around[v] + _ends[v] + (_mesh.Positions[v] * (n * (n - 2)))) * (1 / (n * n));
        }

        int edges = _mesh.Positions.Length;
        int faces = edges + _edges.EdgeCount;
        PolygonParts parts = new(_mesh, 4 * _mesh.Corners.Length);
        for (int face = 0; face < _mesh.FaceCount; face++)
        {
            int[] all = [.. Enumerable.Range(_mesh.Starts[face], _mesh.Count(face))];
            foreach (int corner in all)
            {
                int before = _mesh.Previous(face, corner);
                parts.Add(_mesh.Corners[corner], _mesh.Creases[corner], [corner]);
                parts.Add(edges + _edges.EdgeOf[corner], false, [corner, _mesh.Next(face, corner)]);
                parts.Add(faces + face, false, all);
                parts.Add(edges + _edges.EdgeOf[before], _mesh.Creases[before], [before, corner]);
                parts.End(face);
            }
        }

        return parts.Mesh([.. Places(Smooth), .. EdgePoints(Inner), .. middles]);
    }

    private Vector3 Middle(int face)
    {
        Vector3 sum = default;
        for (int corner = _mesh.Starts[face]; corner < _mesh.Starts[face + 1]; corner++)
        {
            sum += _mesh.Positions[_mesh.Corners[corner]];
        }

        return sum * (1f / _mesh.Count(face));
    }

    private IEnumerable<Vector3> Places(Func<int, Vector3> smooth) => _mesh.Positions.Select((at, v) =>
        _valence[v] == 0 || _sharp[v] > 2 ? at : _sharp[v] == 2 ? (at * 0.75f) + (_sharpEnds[v] * 0.125f) : smooth(v));

    private IEnumerable<Vector3> EdgePoints(Func<int, Vector3, Vector3> inner)
    {
        for (int edge = 0; edge < _edges.EdgeCount; edge++)
        {
            (int a, int b) = _edges.Ends(edge);
            Vector3 ends = _mesh.Positions[a] + _mesh.Positions[b];
            yield return _edges.IsSharp(edge) ? ends * 0.5f : inner(edge, ends);
        }
    }
}

/// <summary>The faces that others are cut into.</summary>
/// <param name="from">The mesh of the others.</param>
/// <param name="corners">The number of corners that there will be.</param>
internal sealed class PolygonParts(PolygonMesh from, int corners)
{
    private readonly List<int> _starts = [0];
    private readonly List<int> _corners = new(corners);
    private readonly List<bool> _creases = new(corners);
    private readonly List<Vector2>? _uv = from.Uv is null ? null : new(corners);
    private readonly List<Rgb>? _colors = from.Colors is null ? null : new(corners);
    private readonly List<int>? _materials = from.Materials is null ? null : [];

    /// <summary>Adds a corner to the face under way.</summary>
    /// <param name="place">Its place.</param>
    /// <param name="isCrease">True where the edge from it to the next one is a crease.</param>
    /// <param name="between">The corners of the other mesh in whose middle it lies.</param>
    public void Add(int place, bool isCrease, ReadOnlySpan<int> between)
    {
        _corners.Add(place);
        _creases.Add(isCrease);
        float part = 1f / between.Length;
        (Vector2 uv, Rgb color) = (default, Rgb.Black);
        foreach (int corner in between)
        {
            uv += (from.Uv?[corner] ?? default) * part;
            color += (from.Colors?[corner] ?? Rgb.Black) * part;
        }

        _uv?.Add(uv);
        _colors?.Add(color);
    }

    /// <summary>Ends a face.</summary>
    /// <param name="face">The face of the other mesh that it is a part of.</param>
    public void End(int face)
    {
        _starts.Add(_corners.Count);
        _materials?.Add(from.Materials![face]);
    }

    /// <summary>The mesh of the faces.</summary>
    /// <param name="positions">Its places.</param>
    public PolygonMesh Mesh(Vector3[] positions) => new()
    {
        Positions = positions,
        Starts = [.. _starts],
        Corners = [.. _corners],
        Creases = [.. _creases],
        Uv = _uv?.ToArray(),
        Colors = _colors?.ToArray(),
        Materials = _materials?.ToArray(),
    };
}
