using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>
/// Finds the instances that a ray may meet: a tree over their boxes, through which each ray goes by itself, nearer children first; and those
/// without end, which are asked every time.
/// </summary>
internal sealed unsafe class InstanceTree
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

    /// <summary>What the tree looks like.</summary>
    public BvhStatistics Statistics => _tree.Statistics;

    /// <summary>Shortens a ray to the nearest hit of all instances.</summary>
    public void ClosestHit(in SpaceRay ray, float time, ref InstanceHit hit)
    {
        foreach (int instance in _endless)
        {
            _table.Meet(instance, ray, time, ref hit);
        }

        Nearest search = new(_table, ray, time, hit);
        Follow(ray, hit.Distance, ref search);
        hit = search.Hit;
    }

    /// <summary>What it costs a ray to find the nearest hit of all instances: nodes visited plus triangles tested, of all trees.</summary>
    public long Cost(in SpaceRay ray, float time, in InstanceHit hit)
    {
        Counting search = new(_table, ray, time, hit);
        float distance = hit.Distance;
        foreach (int instance in _endless)
        {
            search.Visit(instance, ref distance);
        }

        Follow(ray, distance, ref search);
        return search.Cost;
    }

    /// <summary>Whether any instance stands in the way of a ray.</summary>
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
        return Follow(ray, distance, ref search);
    }

    private interface ISearchOfInstances
    {
        /// <summary>Looks at an instance.</summary>
        /// <param name="instance">Its number, from 1.</param>
        /// <param name="distance">How far hits still count.</param>
        /// <returns>Whether the search is over.</returns>
        bool Visit(int instance, ref float distance);

        /// <summary>Told of each node.</summary>
        void Enter();
    }

    [SkipLocalsInit]
    private bool Follow<TSearch>(in SpaceRay ray, float distance, ref TSearch search)
        where TSearch : ISearchOfInstances
    {
        RayBlock block;
        SpaceRay copy = ray;
        int primitive;
        if (_tree.Count == 0 || RayBlock.Load(&block, copy.AsStream(&copy, &distance, &primitive), 0, 1, null, _tree.Bounds) == 0)
        {
            return false;
        }

        uint* pending = stackalloc uint[TraversalStack.Capacity];
        float* entries = stackalloc float[TraversalStack.Capacity];
        ReadOnlySpan<int> order = _tree.Order;
        pending[0] = 0;
        entries[0] = 0;
        for (int depth = 1; depth > 0;)
        {
            uint current = pending[--depth];
            if (entries[depth] > distance)
            {
                continue;
            }

            if ((current & BvhNode.LeafBit) == 0)
            {
                search.Enter();
                depth = Push(_tree.Nodes + current, &block, distance, pending, entries, depth);
            }
            else if (search.Visit(order[BvhNode.LeafFirst(current)] + 1, ref distance))
            {
                return true;
            }
        }

        return false;
    }

    // Puts the children that the ray meets aside, the nearest one last.
    private static int Push(BvhNode* node, RayBlock* block, float distance, uint* pending, float* entries, int depth)
    {
        Vector256<float> entry = Vector256<float>.Zero;
        Vector256<float> exit = Vector256.Create(distance);
        for (int axis = 0; axis < 3; axis++)
        {
            float inverse = block->Inverse[axis * RayBlock.Size];
            Vector256<float> step = Vector256.Create(node->Step[axis] * inverse);
            Vector256<float> origin = Vector256.Create(node->Origin[axis]);
            Vector256<float> lower = Lanes8.MultiplyAdd(
                Lanes8.FromBytes(node->Lower + (8 * axis)), step, Lanes8.MultiplyAdd(origin, Vector256.Create(inverse), Vector256.Create(block->LowerShift[axis * RayBlock.Size])));
            Vector256<float> upper = Lanes8.MultiplyAdd(
                Lanes8.FromBytes(node->Lower + BvhNode.LowerToUpper + (8 * axis)), step, Lanes8.MultiplyAdd(origin, Vector256.Create(inverse), Vector256.Create(block->UpperShift[axis * RayBlock.Size])));

            // NaN, of what is too large for numbers, is always the first of two operands here, and counts as no limit.
            entry = Lanes8.Max(inverse < 0 ? upper : lower, entry);
            exit = Lanes8.Min(inverse < 0 ? lower : upper, exit);
        }

        Vector256<float> exists = Vector256.GreaterThan(Vector256.Create(node->Count), Vector256<int>.Indices).AsSingle();
        int first = depth;
        for (uint hits = Lanes8.Bits(Vector256.LessThanOrEqual(entry, exit) & exists); hits != 0; hits &= hits - 1)
        {
            int child = BitOperations.TrailingZeroCount(hits);
            float at = entry[child];
            int place = depth++;
            for (; place > first && entries[place - 1] < at; place--)
            {
                (entries[place], pending[place]) = (entries[place - 1], pending[place - 1]);
            }

            (entries[place], pending[place]) = (at, node->Child[child]);
        }

        return depth;
    }

    private struct Nearest(InstanceTable table, SpaceRay ray, float time, InstanceHit hit) : ISearchOfInstances
    {
        public InstanceHit Hit = hit;

        public bool Visit(int instance, ref float distance)
        {
            table.Meet(instance, ray, time, ref Hit);
            distance = Hit.Distance;
            return false;
        }

        public readonly void Enter()
        {
        }
    }

    private struct Counting(InstanceTable table, SpaceRay ray, float time, InstanceHit hit) : ISearchOfInstances
    {
        private InstanceHit _hit = hit;

        public long Cost { get; private set; }

        public bool Visit(int instance, ref float distance)
        {
            Cost += table.CostOf(instance, ray, time, distance);
            table.Meet(instance, ray, time, ref _hit);
            distance = _hit.Distance;
            return false;
        }

        public void Enter() => Cost++;
    }

    private readonly struct Any(InstanceTable table, SpaceRay ray, float time, float limit, int skipped, int skip) : ISearchOfInstances
    {
        public bool Visit(int instance, ref float distance) => table.IsMet(instance, ray, time, limit, instance == skipped ? skip : -1);

        public void Enter()
        {
        }
    }
}
