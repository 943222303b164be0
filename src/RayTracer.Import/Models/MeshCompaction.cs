using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>Leaves out the vertices of a mesh that no triangle uses.</summary>
internal static class MeshCompaction
{
    /// <summary>The same triangles with only their own vertices, in the order in which triangles first use them.</summary>
    /// <param name="mesh">A mesh whose indices are all in range.</param>
    public static MeshData Compact(MeshData mesh)
    {
        Dictionary<int, int> places = [];
        List<int> used = [];
        int[] indices = new int[mesh.Indices.Length];
        for (int i = 0; i < indices.Length; i++)
        {
            int vertex = mesh.Indices[i];
            if (!places.TryGetValue(vertex, out int place))
            {
                place = used.Count;
                places.Add(vertex, place);
                used.Add(vertex);
            }

            indices[i] = place;
        }

        return new(Pick(mesh.Positions, used)!, indices)
        {
            Normals = Pick(mesh.Normals, used),
            Uv = Pick(mesh.Uv, used),
            Colors = Pick(mesh.Colors, used),
            Tangents = Pick(mesh.Tangents, used),
            MaterialOfTriangle = mesh.MaterialOfTriangle,
        };
    }

    private static T[]? Pick<T>(T[]? all, List<int> used) => all is null ? null : [.. used.Select(i => all[i])];
}
