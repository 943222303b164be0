using System.Numerics;
using RayTracer.Shapes;
using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.Study;

/// <summary>Finds the triangles of a picture without rays, by the textbook edition's rasterizer.</summary>
internal sealed class RasterTracer : ITracer
{
    private readonly Face[] _faces;

    /// <summary>Takes the triangles.</summary>
    public RasterTracer(MeshData mesh) =>
        _faces = [.. Enumerable.Range(0, mesh.TriangleCount).Select(t => new Face(Corner(mesh, 3 * t), Corner(mesh, (3 * t) + 1), Corner(mesh, (3 * t) + 2), Rgb.White))];

    /// <summary>Nothing: it has no tree.</summary>
    public long MemoryBytes => 0;

    /// <summary>Finds the triangle of each pixel of <see cref="TerrainView"/>, whose rays are given.</summary>
    public void Trace(ReadOnlySpan<(Vector3 Origin, Vector3 Direction)> rays, Span<int> hits)
    {
        int side = (int)Math.Sqrt(rays.Length);
        Rasterizer raster = new(side, side);
        raster.Draw(_faces, TerrainView.Camera);
        raster.Visible.CopyTo(hits);
    }

    private static Textbook.Vector Corner(MeshData mesh, int index) => mesh.Positions[mesh.Indices[index]];
}
