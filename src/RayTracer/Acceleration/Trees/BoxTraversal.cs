using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>The goal of a search among things in boxes.</summary>
internal interface IBoxSearch
{
    /// <summary>Looks at a thing whose box the ray meets.</summary>
    /// <param name="thing">Its number in the tree.</param>
    /// <param name="distance">The largest distance at which hits count.</param>
    /// <returns>True if the search is over.</returns>
    bool Visit(int thing, ref float distance);

    /// <summary>Told of each node.</summary>
    void Enter();
}

/// <summary>Leads one ray by itself through a tree over boxes of one thing each, nearer children first.</summary>
internal static unsafe class BoxTraversal
{
    /// <summary>Visits all things whose boxes a ray meets within a distance.</summary>
    /// <param name="tree">The tree, with one thing a leaf.</param>
    /// <param name="ray">The ray.</param>
    /// <param name="distance">The largest distance at which hits count.</param>
    /// <param name="search">The treatment of the things found.</param>
    /// <returns>True if the search ended before all were visited.</returns>
    [SkipLocalsInit]
    public static bool Follow<TSearch>(WideBvh tree, in SpaceRay ray, float distance, ref TSearch search)
        where TSearch : struct, IBoxSearch
    {
        RayBlock block;
        SpaceRay copy = ray;
        int primitive;
        if (tree.Count == 0 || RayBlock.Load(&block, copy.AsStream(&copy, &distance, &primitive), 0, 1, null, tree.Bounds) == 0)
        {
            return false;
        }

        uint* pending = stackalloc uint[TraversalStack.Capacity];
        float* entries = stackalloc float[TraversalStack.Capacity];
        ReadOnlySpan<int> order = tree.Order;
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
                depth = Push(tree.Nodes + current, &block, distance, pending, entries, depth);
            }
            else if (search.Visit(order[BvhNode.LeafFirst(current)], ref distance))
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
}
