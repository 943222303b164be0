using RayTracer.Shapes;

namespace RayTracer.Textbook;

/// <summary>Turns the triangles of files and scene files into meshes.</summary>
internal static class MeshReader
{
    /// <summary>A mesh for each of the materials that triangles have.</summary>
    /// <param name="wanted">The shape that shows the mesh.</param>
    /// <param name="mesh">The mesh, which may come from a file that the shape names.</param>
    /// <param name="refusals">Takes what there is none of.</param>
    public static List<(Mesh Mesh, int Material)> Read(MeshDescription wanted, MeshDescription mesh, Refusals refusals)
    {
        MeshData data = mesh.Data ?? Inline(mesh);
        if (data.Colors is not null && !wanted.IgnoreColors)
        {
            refusals.Say(wanted, null, "the textbook edition has no colours of corners: give \"ignoreColors\": true");
        }

        Vector[] points = Array.ConvertAll(data.Positions, p => (Vector)p);
        List<(int A, int B, int C)> triangles = [];
        for (int i = 0; i + 2 < data.Indices.Length; i += 3)
        {
            (int a, int b, int c) = (data.Indices[i], data.Indices[i + 1], data.Indices[i + 2]);
            if (Math.Max(a, Math.Max(b, c)) >= points.Length || Math.Min(a, Math.Min(b, c)) < 0)
            {
                refusals.Say(mesh, nameof(mesh.Triangles), $"a triangle has a corner that is not there: there are {points.Length}, counted from 0");
                return [];
            }

            triangles.Add(wanted.FlipNormals ? (a, c, b) : (a, b, c));
        }

        Vector[]? normals = Normals(wanted, data, points, triangles);
        (double, double)[]? uv = data.Uv is null ? null : Array.ConvertAll(data.Uv, t => ((double)t.X, wanted.FlipV ? 1.0 - t.Y : t.Y));
        int[] numbers = data.MaterialOfTriangle ?? [];
        return [.. triangles.Select((t, i) => (Triangle: t, Material: i < numbers.Length ? numbers[i] : 0)).GroupBy(t => t.Material)
            .Select(g => (new Mesh(points, [.. g.Select(t => t.Triangle)], normals, uv), g.Key))];
    }

    private static MeshData Inline(MeshDescription mesh) => new([.. mesh.Positions], [.. mesh.Triangles.SelectMany(t => new[] { t.A, t.B, t.C })])
    {
        Normals = mesh.Normals.Count > 0 ? [.. mesh.Normals] : null,
        Uv = mesh.Uv.Count > 0 ? [.. mesh.Uv] : null,
        Colors = mesh.Colors.Count > 0 ? [default] : null,
        MaterialOfTriangle = mesh.MaterialOfTriangle.Count > 0 ? [.. mesh.MaterialOfTriangle] : null,
    };

    private static Vector[]? Normals(MeshDescription wanted, MeshData data, Vector[] points, List<(int A, int B, int C)> triangles)
    {
        if (wanted.Shading == MeshShading.Flat || (data.Normals is null && wanted.Shading == MeshShading.Own))
        {
            return null;
        }

        if (data.Normals is { } own)
        {
            return Array.ConvertAll(own, n => ((Vector)n).Length > 0 ? ((Vector)n).Unit * (wanted.FlipNormals ? -1 : 1) : default);
        }

        // The mean of the triangles around each corner, weighted by their angles there (Thürmer & Wüthrich 1998).
        Vector[] sums = new Vector[points.Length];
        foreach ((int a, int b, int c) in triangles)
        {
            AddAngle(a, b, c);
            AddAngle(b, c, a);
            AddAngle(c, a, b);
        }

        return Array.ConvertAll(sums, n => n.Length > 0 ? n.Unit : default);

        void AddAngle(int at, int next, int last)
        {
            (Vector one, Vector other) = (points[next] - points[at], points[last] - points[at]);
            Vector across = Vector.Cross(one, other);
            double sine = across.Length;
            sums[at] += sine > 0 ? across * (Math.Atan2(sine, Vector.Dot(one, other)) / sine) : default;
        }
    }
}
