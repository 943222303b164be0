namespace RayTracer.Textbook;

/// <summary>All the ways to find what a ray meets, by name.</summary>
public static class Trees
{
    /// <summary>What builds them, in the order in which a course comes to them.</summary>
    public static IReadOnlyDictionary<string, Func<IReadOnlyList<IShape>, IAccelerator>> All { get; } = new Dictionary<string, Func<IReadOnlyList<IShape>, IAccelerator>>
    {
        ["plain loop"] = s => new PlainLoop(s),
        ["uniform grid"] = s => new UniformGrid(s),
        ["kd-tree"] = s => new KdTree(s),
        ["octree"] = s => new Octree(s),
        ["quadtree"] = s => new Quadtree(s),
        ["BSP tree"] = s => new BspTree(s),
        ["boxes by median"] = s => new BoundingVolumes(s, isHalved: true),
        ["boxes by area"] = s => new BoundingVolumes(s),
        ["oriented boxes"] = s => new OrientedBoxes(s),
    };
}
