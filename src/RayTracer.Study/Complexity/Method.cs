using System.Numerics;
using RayTracer.Shapes;
using RayTracer.Textbook;

namespace RayTracer.Study;

/// <summary>Something that traces rays through triangles.</summary>
internal interface ITracer
{
    /// <summary>Memory beside the triangles' corners and indices, in bytes.</summary>
    long MemoryBytes { get; }

    /// <summary>Finds the triangle that each ray meets first; −1 for none.</summary>
    void Trace(ReadOnlySpan<(Vector3 Origin, Vector3 Direction)> rays, Span<int> hits);
}

/// <summary>A way to trace rays that is measured.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Colour">Its colour in the chart, as in CSS.</param>
/// <param name="Law">The expected growth of its time a ray, as it is written in a formula.</param>
/// <param name="Growth">The same as a function.</param>
/// <param name="Build">Builds it for some triangles.</param>
internal sealed record Method(string Name, string Colour, string Law, Func<double, double> Growth, Func<MeshData, ITracer> Build)
{
    /// <summary>All that are measured.</summary>
    public static IReadOnlyList<Method> All { get; } =
    [
        OfTree("plain loop", "#c1440e", "n", n => n, s => new PlainLoop(s)),
        OfTree("uniform grid", "#8e5ba6", "∛n", Math.Cbrt, s => new UniformGrid(s)),
        OfTree("kd-tree", "#2e7d32", "log₂ n", Math.Log2, s => new KdTree(s)),
        OfTree("octree", "#b58900", "log₂ n", Math.Log2, s => new Octree(s)),
        OfTree("quadtree", "#d33682", "log₂ n", Math.Log2, s => new Quadtree(s)),
        OfTree("BSP tree", "#6c71c4", "log₂ n", Math.Log2, s => new BspTree(s)),
        OfTree("boxes by median", "#586e75", "log₂ n", Math.Log2, s => new BoundingVolumes(s, isHalved: true)),
        OfTree("boxes by area", "#333333", "log₂ n", Math.Log2, s => new BoundingVolumes(s)),
        OfTree("oriented boxes", "#7f4f24", "log₂ n", Math.Log2, s => new OrientedBoxes(s)),
        new("BVH, single rays", "#1f5fa8", "log₂ n", Math.Log2, m => new BvhTracer(m, streams: false)),
        new("BVH, streams", "#0b8f9c", "log₂ n", Math.Log2, m => new BvhTracer(m, streams: true)),
    ];

    /// <summary>Those that are measured on a picture; the first finds what is visible without rays.</summary>
    public static IReadOnlyList<Method> OfPictures { get; } =
    [
        new("rasterizer", "#c1440e", "n", n => n, m => new RasterTracer(m)),
        .. All.Where(m => m.Name is "boxes by area" or "BVH, streams"),
    ];

    /// <summary>The most triangles in pictures: a rasterizer that is written to be read keeps much of each.</summary>
    public const int MostOfPicture = 1_000_000;

    private static Method OfTree(string name, string colour, string law, Func<double, double> growth, Func<IReadOnlyList<IShape>, IAccelerator> build) =>
        new(name, colour, law, growth, mesh => new TreeTracer(mesh, build));
}
