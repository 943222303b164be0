using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Shapes;

namespace RayTracer.Study;

/// <summary>Traces with the hierarchy that the renderer uses.</summary>
/// <param name="mesh">The triangles.</param>
/// <param name="streams">True if many rays go through the tree together, as in a render, or one after another.</param>
internal sealed unsafe class BvhTracer(MeshData mesh, bool streams) : ITracer
{
    private const int Columns = 7;
    private readonly TriangleBvh _bvh = TriangleBvh.Build(mesh.Positions, mesh.Indices, Environment.ProcessorCount);

    /// <inheritdoc/>
    public long MemoryBytes => _bvh.Statistics.MemoryBytes;

    /// <inheritdoc/>
    public void Trace(ReadOnlySpan<(Vector3 Origin, Vector3 Direction)> rays, Span<int> hits)
    {
        int n = rays.Length;
        float[] columns = new float[n * Columns];
        for (int i = 0; i < n; i++)
        {
            (Vector3 o, Vector3 d) = rays[i];
            ReadOnlySpan<float> ray = [o.X, o.Y, o.Z, d.X, d.Y, d.Z, float.PositiveInfinity];
            for (int k = 0; k < ray.Length; k++)
            {
                columns[(k * n) + i] = ray[k];
            }
        }

        fixed (float* p = columns)
        fixed (int* hit = hits)
        {
            RayStream stream = RayStream.OfColumns(p, n, hit, n);
            _bvh.ClosestHit(stream, streams ? TraversalMode.Automatic : TraversalMode.Single);
        }
    }
}
