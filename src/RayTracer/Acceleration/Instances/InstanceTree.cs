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

        Nearest search = new(_table, ray, time, hit);
        BoxTraversal.Follow(_tree, ray, hit.Distance, ref search);
        hit = search.Hit;
    }

    /// <summary>
    /// Returns the cost of finding a ray's nearest hit of all instances: nodes visited plus triangles tested, of all trees.
    /// </summary>
    public long Cost(in SpaceRay ray, float time, in InstanceHit hit)
    {
        Counting search = new(_table, ray, time, hit);
        float distance = hit.Distance;
        foreach (int instance in _endless)
        {
            search.Visit(instance - 1, ref distance);
        }

        BoxTraversal.Follow(_tree, ray, distance, ref search);
        return search.Cost;
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

        Any search = new(_table, ray, time, distance, skipped, skip);
        return BoxTraversal.Follow(_tree, ray, distance, ref search);
    }

    private struct Nearest(InstanceTable table, SpaceRay ray, float time, InstanceHit hit) : IBoxSearch
    {
        public InstanceHit Hit = hit;

        public bool Visit(int thing, ref float distance)
        {
            table.Meet(thing + 1, ray, time, ref Hit);
            distance = Hit.Distance;
            return false;
        }

        public readonly void Enter()
        {
        }
    }

    private struct Counting(InstanceTable table, SpaceRay ray, float time, InstanceHit hit) : IBoxSearch
    {
        private InstanceHit _hit = hit;

        public long Cost { get; private set; }

        public bool Visit(int thing, ref float distance)
        {
            Cost += table.CostOf(thing + 1, ray, time, distance);
            table.Meet(thing + 1, ray, time, ref _hit);
            distance = _hit.Distance;
            return false;
        }

        public void Enter() => Cost++;
    }

    private readonly struct Any(InstanceTable table, SpaceRay ray, float time, float limit, int skipped, int skip) : IBoxSearch
    {
        public bool Visit(int thing, ref float distance) => table.IsMet(thing + 1, ray, time, limit, thing + 1 == skipped ? skip : -1);

        public void Enter()
        {
        }
    }
}
