using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// A mesh of polygons as subdivision takes it: corners of faces that lie at the same place are one, whatever their uv, which every corner of every face has for itself.
/// </summary>
internal sealed class PolygonMesh
{
    /// <summary>The places.</summary>
    public required Vector3[] Positions { get; init; }

    /// <summary>Where the corners of each face begin in <see cref="Corners"/>, and where the last one's end.</summary>
    public required int[] Starts { get; init; }

    /// <summary>For each corner of each face, its place.</summary>
    public required int[] Corners { get; init; }

    /// <summary>For each corner of each face, whether the edge from it to the next one is a crease.</summary>
    public required bool[] Creases { get; init; }

    /// <summary>uv for each corner of each face; null where there is none.</summary>
    public Vector2[]? Uv { get; init; }

    /// <summary>A colour for each corner of each face; null where there is none.</summary>
    public Rgb[]? Colors { get; init; }

    /// <summary>The index of each face's material; null where all are made of the first.</summary>
    public int[]? Materials { get; init; }

    /// <summary>The number of faces.</summary>
    public int FaceCount => Starts.Length - 1;

    /// <summary>The number of corners of a face.</summary>
    public int Count(int face) => Starts[face + 1] - Starts[face];

    /// <summary>The corner after another one, around its face.</summary>
    public int Next(int face, int corner) => corner + 1 < Starts[face + 1] ? corner + 1 : Starts[face];

    /// <summary>The corner before another one, around its face.</summary>
    public int Previous(int face, int corner) => corner > Starts[face] ? corner - 1 : Starts[face + 1] - 1;

    /// <summary>The polygons of a sound mesh of triangles.</summary>
    /// <param name="mesh">The mesh, without faults.</param>
    /// <param name="keepsTriangles">True where the triangles are faces, whatever polygons they were cut from.</param>
    /// <param name="creaseAngle">The angle between faces, in degrees, beyond which their edge is a crease.</param>
    public static PolygonMesh Of(MeshData mesh, bool keepsTriangles, float creaseAngle)
    {
        (int[] starts, int[] vertices, int[] triangles) = Faces(mesh, keepsTriangles);
        Dictionary<Vector3, int> places = [];
        List<Vector3> positions = [];
        int[] placeOf = new int[mesh.Positions.Length];
        for (int i = 0; i < placeOf.Length; i++)
        {
            // −0 is 0 here.
            Vector3 at = mesh.Positions[i] + Vector3.Zero;
            if (!places.TryGetValue(at, out placeOf[i]))
            {
                placeOf[i] = positions.Count;
                places.Add(at, placeOf[i]);
                positions.Add(at);
            }
        }

        PolygonMesh smooth = new()
        {
            Positions = [.. positions],
            Starts = starts,
            Corners = [.. vertices.Select(v => placeOf[v])],
            Creases = new bool[vertices.Length],
            Uv = mesh.Uv is { } uv ? [.. vertices.Select(v => uv[v])] : null,
            Colors = mesh.Colors is { } colors ? [.. vertices.Select(v => colors[v])] : null,
            Materials = mesh.MaterialOfTriangle is { } materials ? [.. triangles.Select(t => materials[t])] : null,
        };
        return creaseAngle < 180 ? smooth.WithCreases(creaseAngle) : smooth;
    }

    /// <summary>The area of a face, along its normal: twice as long (Newell's, of Sutherland et al. 1974).</summary>
    public Vector3 Across(int face)
    {
        Vector3 first = Positions[Corners[Starts[face]]];
        Vector3 sum = default;
        for (int i = Starts[face] + 1; i + 1 < Starts[face + 1]; i++)
        {
            sum += (Positions[Corners[i]] - first).Cross(Positions[Corners[i + 1]] - first);
        }

        return sum;
    }

    private PolygonMesh WithCreases(float angle)
    {
        LaneMath.SinCosTurn(angle / 360, out _, out float least);
        MeshTopology edges = MeshTopology.Of(this);
        bool[] creases = new bool[Corners.Length];
        for (int face = 0; face < FaceCount; face++)
        {
            for (int corner = Starts[face]; corner < Starts[face + 1]; corner++)
            {
                int other = edges.OppositeFace(edges.EdgeOf[corner], face);
                creases[corner] = other >= 0 && Across(face).Unit().Dot(Across(other).Unit()) < least;
            }
        }

        return new()
        {
            Positions = Positions,
            Starts = Starts,
            Corners = Corners,
            Creases = creases,
            Uv = Uv,
            Colors = Colors,
            Materials = Materials,
        };
    }

    // Of each face, its vertices in the mesh and one of its triangles.
    private static (int[] Starts, int[] Vertices, int[] Triangles) Faces(MeshData mesh, bool keepsTriangles)
    {
        List<int> starts = [0];
        List<int> vertices = [];
        List<int> triangles = [];
        int[]? faces = keepsTriangles ? null : mesh.FaceOfTriangle;
        for (int first = 0, end; first < mesh.TriangleCount; first = end)
        {
            for (end = first + 1; faces is not null && end < mesh.TriangleCount && faces[end] == faces[first]; end++)
            {
            }

            ReadOnlySpan<int> indices = mesh.Indices.AsSpan(3 * first, 3 * (end - first));
            int before = vertices.Count;
            if (indices.Length == 3 || !AddOutline(indices, vertices))
            {
                vertices.RemoveRange(before, vertices.Count - before);
                Triangles(indices, first);
                continue;
            }

            starts.Add(vertices.Count);
            triangles.Add(first);
        }

        return ([.. starts], [.. vertices], [.. triangles]);

        void Triangles(ReadOnlySpan<int> indices, int first)
        {
            for (int i = 0; i < indices.Length; i += 3)
            {
                vertices.AddRange(indices.Slice(i, 3));
                starts.Add(vertices.Count);
                triangles.Add(first + (i / 3));
            }
        }
    }

    // The polygon that triangles were cut from: the edges that no two of them share. False where these are not one ring.
    private static bool AddOutline(ReadOnlySpan<int> indices, List<int> vertices)
    {
        HashSet<(int, int)> edges = [];
        for (int i = 0; i < indices.Length; i++)
        {
            edges.Add((indices[i], indices[i % 3 == 2 ? i - 2 : i + 1]));
        }

        Dictionary<int, int> next = [];
        foreach (int i in Enumerable.Range(0, indices.Length))
        {
            (int from, int to) = (indices[i], indices[i % 3 == 2 ? i - 2 : i + 1]);
            if (!edges.Contains((to, from)) && !next.TryAdd(from, to))
            {
                return false;
            }
        }

        int start = next.ContainsKey(indices[0]) ? indices[0] : indices[1];
        int at = start;
        for (int i = 0; i < next.Count; i++)
        {
            vertices.Add(at);
            if (!next.TryGetValue(at, out at))
            {
                return false;
            }
        }

        return at == start && next.Count == (indices.Length / 3) + 2;
    }
}
