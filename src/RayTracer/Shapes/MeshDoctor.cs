using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// Finds the faults of a mesh and repairs them: unusable triangles are dropped, unusable normals are recomputed, and
/// triangles that face otherwise than their neighbours are turned. Any numbers whatever give a mesh that can be rendered.
/// </summary>
internal sealed class MeshDoctor
{
    private readonly MeshData _mesh;
    private readonly List<string> _findings = [];
    private int[] _kept;

    private MeshDoctor(MeshData mesh)
    {
        _mesh = mesh;
        _kept = new int[mesh.Indices.Length / 3];
        for (int i = 0; i < _kept.Length; i++)
        {
            _kept[i] = i;
        }
    }

    /// <summary>Checks and mends a mesh.</summary>
    /// <param name="mesh">The mesh; not changed.</param>
    /// <param name="report">The faults found, as the rest of a sentence that begins with the mesh's name; empty where there were none.</param>
    /// <returns>A sound mesh; the same one where nothing was wrong.</returns>
    public static MeshData Mend(MeshData mesh, out string report)
    {
        MeshDoctor doctor = new(mesh);
        MeshData mended = doctor.Mend();
        if (mended.TriangleCount == 0)
        {
            doctor._findings.Add("there is no triangle in it");
        }

        report = string.Join("; ", doctor._findings);
        return mended;
    }

    private MeshData Mend()
    {
        int vertices = _mesh.Positions.Length;
        if (_mesh.Indices.Length % 3 != 0)
        {
            _findings.Add($"the last {Count(_mesh.Indices.Length % 3, "corner")} made no triangle and {(_mesh.Indices.Length % 3 == 1 ? "was" : "were")} dropped");
        }

        Drop("whose corners do not exist", (a, b, c) => (uint)a < vertices && (uint)b < vertices && (uint)c < vertices);
        Drop("whose corners are no finite numbers", (a, b, c) => At(a).IsFinite() && At(b).IsFinite() && At(c).IsFinite());
        Drop("without area", HasArea);
        DropDuplicates();
        int[] turned = TurnAgainstNeighbours();
        int[] materials = Materials();
        bool isWhole = _kept.Length == _mesh.Indices.Length / 3 && _mesh.Indices.Length % 3 == 0 && turned.Length == 0;
        int[] indices = isWhole ? _mesh.Indices : Indices(turned);
        return new(_mesh.Positions, indices)
        {
            Normals = Normals(indices, turned),
            Uv = Finite(_mesh.Uv, "uv", "uv", v => float.IsFinite(v.X) && float.IsFinite(v.Y)),
            Colors = Finite(_mesh.Colors, "colour", "colours", IsColor),
            SecondColors = Finite(_mesh.SecondColors, "second colour", "second colours", IsColor),
            Tangents = Finite(_mesh.Tangents, "tangent", "tangents", t => float.IsFinite(t.X) && float.IsFinite(t.Y) && float.IsFinite(t.Z) && float.IsFinite(t.W)),
            MaterialOfTriangle = materials.Length == 0 ? null : materials,
            FaceOfTriangle = _mesh.FaceOfTriangle is { } faces ? [.. _kept.Select(t => t < faces.Length ? faces[t] : -1 - t)] : null,
        };
    }

    private static bool IsColor(Rgb c) => float.IsFinite(c.R) && float.IsFinite(c.G) && float.IsFinite(c.B) && c.R >= 0 && c.G >= 0 && c.B >= 0;

    private Vector3 At(int corner) => _mesh.Positions[corner];

    private (int A, int B, int C) Corners(int triangle)
    {
        int[] indices = _mesh.Indices;
        return (indices[3 * triangle], indices[(3 * triangle) + 1], indices[(3 * triangle) + 2]);
    }

    private bool HasArea(int a, int b, int c)
    {
        (Vector3 ab, Vector3 ac) = (At(b) - At(a), At(c) - At(a));
        return !AreParallel(ab, ac) && ab.Cross(ac).Unit().IsFinite();
    }

    // Exact: doubles hold products of floats, while a fused cross product of parallel vectors leaves what one of its products was rounded
    // by.
    private static bool AreParallel(Vector3 a, Vector3 b) =>
        (double)a.Y * b.Z == (double)a.Z * b.Y && (double)a.Z * b.X == (double)a.X * b.Z && (double)a.X * b.Y == (double)a.Y * b.X;

    private void Drop(string which, Func<int, int, int, bool> isGood)
    {
        bool[] good = new bool[_kept.Length];
        Parallel.For(0, (_kept.Length + 4095) / 4096, block =>
        {
            for (int i = block * 4096; i < Math.Min(_kept.Length, (block + 1) * 4096); i++)
            {
                (int a, int b, int c) = Corners(_kept[i]);
                good[i] = isGood(a, b, c);
            }
        });
        Keep(good, count => $"{Count(count, "triangle")} {which} dropped");
    }

    private void Keep(bool[] good, Func<int, string> finding)
    {
        int bad = good.Count(g => !g);
        if (bad > 0)
        {
            _kept = [.. _kept.Where((_, i) => good[i])];
            _findings.Add(finding(bad));
        }
    }

    // Triangles with the same corners in the same order round, whichever comes first; those that face the other way are another side.
    private void DropDuplicates()
    {
        // By the least corner, so that only few need comparing.
        int[] start = Buckets(_kept.Length, i => Least(_kept[i]), out int[] members);
        bool[] good = new bool[_kept.Length];
        Array.Fill(good, true);
        HashSet<(int, int)> seen = [];
        for (int corner = 0; corner + 1 < start.Length; corner++)
        {
            int count = start[corner + 1] - start[corner];
            if (count < 2)
            {
                continue;
            }

            seen.Clear();
            for (int i = start[corner]; i < start[corner + 1]; i++)
            {
                (int a, int b, int c) = Corners(_kept[members[i]]);
                good[members[i]] = seen.Add(a == corner ? (b, c) : b == corner ? (c, a) : (a, b));
            }
        }

        Keep(good, count => $"{Count(count, "duplicate triangle")} dropped");
    }

    private int Least(int triangle)
    {
        (int a, int b, int c) = Corners(triangle);
        return Math.Min(a, Math.Min(b, c));
    }

    // A counting sort of things by a corner: members of corner v are those from start[v] to start[v + 1], in their order.
    private int[] Buckets(int count, Func<int, int> cornerOf, out int[] members)
    {
        int[] start = new int[_mesh.Positions.Length + 1];
        for (int i = 0; i < count; i++)
        {
            start[cornerOf(i) + 1]++;
        }

        for (int v = 1; v < start.Length; v++)
        {
            start[v] += start[v - 1];
        }

        members = new int[count];
        int[] next = start[..^1];
        for (int i = 0; i < count; i++)
        {
            members[next[cornerOf(i)]++] = i;
        }

        return start;
    }

    // Neighbours that share an edge go along it in opposite directions, if they face the same side. In each connected component the
    // smaller part is turned. Returns which of the kept triangles are turned, by 1; empty where none is.
    private int[] TurnAgainstNeighbours()
    {
        MeshEdges edges = new(_mesh, _kept);
        if (!edges.AnyInconsistent())
        {
            return [];
        }

        int[] turned = edges.Orient(out int count, out int unsolved);
        if (count > 0)
        {
            _findings.Add($"{Count(count, "triangle")} that faced otherwise than {(count == 1 ? "its" : "their")} neighbours turned");
        }

        if (unsolved > 0)
        {
            _findings.Add($"at {Count(unsolved, "edge")} the sides that neighbours face cannot be made to agree");
        }

        return count > 0 ? turned : [];
    }

    private int[] Indices(int[] turned)
    {
        int[] indices = new int[3 * _kept.Length];
        for (int i = 0; i < _kept.Length; i++)
        {
            (int a, int b, int c) = Corners(_kept[i]);
            bool turn = turned.Length > 0 && turned[i] != 0;
            (indices[3 * i], indices[(3 * i) + 1], indices[(3 * i) + 2]) = turn ? (a, c, b) : (a, b, c);
        }

        return indices;
    }

    private int[] Materials()
    {
        if (_mesh.MaterialOfTriangle is not { } materials)
        {
            return [];
        }

        if (materials.Length < _mesh.TriangleCount)
        {
            _findings.Add($"{Count(_mesh.TriangleCount - materials.Length, "triangle")} without a material of {(_mesh.TriangleCount - materials.Length == 1 ? "its" : "their")} own made of the first");
        }

        return [.. _kept.Select(t => t < materials.Length ? materials[t] : 0)];
    }

    private Vector3[]? Normals(int[] indices, int[] turned)
    {
        if (_mesh.Normals is not { } given)
        {
            return null;
        }

        if (given.Length < _mesh.Positions.Length)
        {
            _findings.Add($"{Count(_mesh.Positions.Length - given.Length, "corner")} without a normal: {(given.Length == 0 ? "all triangles left flat" : "computed from the triangles around")}");
            if (given.Length == 0)
            {
                return null;
            }
        }

        bool[] used = Used(indices);
        int zero = 0;
        for (int v = 0; v < given.Length && v < used.Length; v++)
        {
            zero += used[v] && !IsDirection(given[v]) ? 1 : 0;
        }

        if (zero > 0)
        {
            _findings.Add($"{Count(zero, "normal")} without a direction computed from the triangles around");
        }

        if (zero == 0 && given.Length >= _mesh.Positions.Length && turned.Length == 0)
        {
            return Array.TrueForAll(given, IsUnit) ? given : [.. given.Select(Unit)];
        }

        Vector3[] computed = FromTriangles(indices);
        return [.. computed.Select((n, v) => v < given.Length && IsDirection(given[v]) ? Unit(given[v]) : n)];
    }

    // Between corners, longer normals would count more. What is a unit vector but for rounding stays as it is.
    private static Vector3 Unit(Vector3 normal) => IsUnit(normal) ? normal : normal.Unit() is var unit && unit.IsFinite() ? unit : default;

    private static bool IsUnit(Vector3 normal) => float.Abs(normal.Dot(normal) - 1f) < 1e-5f;

    private bool[] Used(int[] indices)
    {
        bool[] used = new bool[_mesh.Positions.Length];
        foreach (int corner in indices)
        {
            used[corner] = true;
        }

        return used;
    }

    private static bool IsDirection(Vector3 normal) => normal.Unit().IsFinite();

    // The mean of the normals around a corner, weighted by area.
    private Vector3[] FromTriangles(int[] indices)
    {
        Vector3[] normals = new Vector3[_mesh.Positions.Length];
        for (int i = 0; i < indices.Length; i += 3)
        {
            (int a, int b, int c) = (indices[i], indices[i + 1], indices[i + 2]);
            Vector3 normal = (At(b) - At(a)).Cross(At(c) - At(a));
            normals[a] += normal;
            normals[b] += normal;
            normals[c] += normal;
        }

        return [.. normals.Select(n => n.Unit().IsFinite() ? n.Unit() : default)];
    }

    private T[]? Finite<T>(T[]? values, string one, string many, Func<T, bool> isGood)
        where T : struct
    {
        if (values is null)
        {
            return null;
        }

        int vertices = _mesh.Positions.Length;
        if (values.Length < vertices)
        {
            _findings.Add($"{Count(vertices - values.Length, "corner")} without {one}: all {many} left out");
            return null;
        }

        int bad = values.Count(v => !isGood(v));
        if (bad == 0)
        {
            return values;
        }

        _findings.Add($"{bad} {(bad == 1 ? one : many)} that cannot be used replaced by zeros");
        return [.. values.Select(v => isGood(v) ? v : default)];
    }

    private static string Count(int count, string thing) => count == 1 ? $"1 {thing}" : $"{count} {thing}s";
}
