using System.Numerics;
using RayTracer.Shapes;
using RayTracer.Textbook;
using Vector = RayTracer.Textbook.Vector;

namespace RayTracer.Study;

/// <summary>Traces with one of the textbook edition's trees.</summary>
internal sealed class TreeTracer : ITracer
{
    private readonly IAccelerator _tree;

    /// <summary>Builds the tree.</summary>
    /// <param name="mesh">The triangles.</param>
    /// <param name="build">Makes the tree of some shapes.</param>
    public TreeTracer(MeshData mesh, Func<IReadOnlyList<IShape>, IAccelerator> build)
    {
        Vector[] points = Array.ConvertAll(mesh.Positions, p => (Vector)p);
        int[] corners = mesh.Indices;
        IShape[] triangles = [.. Enumerable.Range(0, mesh.TriangleCount).Select(t => new MeshTriangle(points, corners[3 * t], corners[(3 * t) + 1], corners[(3 * t) + 2]))];
        long before = GC.GetTotalMemory(forceFullCollection: true);
        _tree = build(triangles);
        MemoryBytes = Math.Max(0, GC.GetTotalMemory(forceFullCollection: true) - before);
    }

    /// <summary>What the tree added to the memory in use, beside the triangles.</summary>
    public long MemoryBytes { get; }

    /// <inheritdoc/>
    public void Trace(ReadOnlySpan<(Vector3 Origin, Vector3 Direction)> rays, Span<int> hits)
    {
        for (int i = 0; i < rays.Length; i++)
        {
            Hit hit = Hit.None();
            hits[i] = _tree.Intersect(new(rays[i].Origin, rays[i].Direction), ref hit) ? hit.Index : -1;
        }
    }
}
