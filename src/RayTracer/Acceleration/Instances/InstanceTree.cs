namespace RayTracer.Acceleration;

/// <summary>
/// Finds the instances that a ray may meet: a tree over their boxes, through which each ray goes by itself, nearer children first; and those
/// without end, which are asked every time.
/// </summary>
internal sealed class InstanceTree
{
    private readonly InstanceTable _table;
    private readonly WideBvh _tree;
    private readonly int[] _endless;

    /// <summary>Builds the tree.</summary>
    /// <param name="table">The instances.</param>
    /// <param name="boxes">Six numbers an instance: lower x, y, z, upper x, y, z.</param>
    public InstanceTree(InstanceTable table, float[] boxes)
    {
        _table = table;
        _tree = WideBvh.Build(boxes, 1, Environment.ProcessorCount);
        HashSet<int> bounded = [.. _tree.Order];
        _endless = [.. Enumerable.Range(0, table.Count).Where(i => !bounded.Contains(i)).Select(i => i + 1)];
    }

    /// <summary>Memory of the tree.</summary>
    public long MemoryBytes => _tree.MemoryBytes + (4L * _endless.Length);

    /// <summary>The size and shape of the tree.</summary>
    public BvhStatistics Statistics => _tree.Statistics;

    /// <summary>Shortens a ray to the nearest hit of all instances.</summary>
    public void ClosestHit(in SpaceRay ray, float time, ref InstanceHit hit)
    {
        foreach (int instance in _endless)
        {
            _table.Meet(instance, ray, time, ref hit);
        }

        Nearest search = new(this, ray, time, hit);
        SingleRayTraversal.Follow<ClosestSearch, Nearest>(_tree, ray, hit.Distance, ref search, out _);
        hit = search.Hit;
    }

    /// <summary>
    /// Returns the cost of finding a ray's nearest hit of all instances: nodes visited plus triangles tested, of all trees.
    /// </summary>
    public long Cost(in SpaceRay ray, float time, in InstanceHit hit)
    {
        Nearest search = new(this, ray, time, hit) { Counts = true };
        float distance = hit.Distance;
        foreach (int instance in _endless)
        {
            search.Meet(instance, ref distance);
        }

        SingleRayTraversal.Follow<CountingSearch, Nearest>(_tree, ray, distance, ref search, out long visited);
        return search.Cost + visited;
    }

    /// <summary>Returns whether any instance stands in the way of a ray.</summary>
    public bool AnyHit(in SpaceRay ray, float time, float distance, int skipped, int skip)
    {
        foreach (int instance in _endless)
        {
            if (_table.IsMet(instance, ray, time, distance, instance == skipped ? skip : -1))
            {
                return true;
            }
        }

        Any search = new(this, ray, time, skipped, skip);
        return SingleRayTraversal.Follow<AnySearch, Any>(_tree, ray, distance, ref search, out _);
    }

    // The number of the instance in a leaf.
    private int Instance(uint leaf) => _tree.Order[BvhNode.LeafFirst(leaf)] + 1;

    private struct Nearest(InstanceTree tree, SpaceRay ray, float time, InstanceHit hit) : ILeaves
    {
        public InstanceHit Hit = hit;

        public long Cost;

        public bool Counts { get; init; }

        public readonly unsafe void Prefetch(BvhNode* nodes, uint reference)
        {
        }

        public bool Meet(uint leaf, ref float distance) => Meet(tree.Instance(leaf), ref distance);

        public bool Meet(int instance, ref float distance)
        {
            if (Counts)
            {
                Cost += tree._table.CostOf(instance, ray, time, distance);
            }

            tree._table.Meet(instance, ray, time, ref Hit);
            distance = Hit.Distance;
            return true;
        }
    }

    private readonly struct Any(InstanceTree tree, SpaceRay ray, float time, int skipped, int skip) : ILeaves
    {
        public unsafe void Prefetch(BvhNode* nodes, uint reference)
        {
        }

        public bool Meet(uint leaf, ref float distance)
        {
            int instance = tree.Instance(leaf);
            return tree._table.IsMet(instance, ray, time, distance, instance == skipped ? skip : -1);
        }
    }
}
