using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>What is in the leaves of a tree, as one ray meets it.</summary>
internal unsafe interface ILeaves
{
    /// <summary>Asks for the memory of a node or leaf that will be visited soon.</summary>
    void Prefetch(BvhNode* nodes, uint reference);

    /// <summary>Meets a ray with what is in a leaf.</summary>
    /// <param name="leaf">Refers to the leaf.</param>
    /// <param name="distance">The largest distance at which hits count.</param>
    /// <returns>True if there is a hit, for any hit.</returns>
    bool Meet(uint leaf, ref float distance);
}

/// <summary>One ray through a tree: eight boxes at a time, nearer children first.</summary>
internal static unsafe class SingleRayTraversal
{
    /// <summary>Leads a ray through a tree over boxes.</summary>
    /// <param name="tree">The tree.</param>
    /// <param name="ray">The ray.</param>
    /// <param name="distance">The largest distance at which hits count.</param>
    /// <param name="leaves">What is in the boxes.</param>
    /// <param name="visited">The number of nodes visited, where that is counted.</param>
    /// <returns>True if there is a hit, for any hit.</returns>
    public static bool Follow<TSearch, TLeaves>(WideBvh tree, in SpaceRay ray, float distance, ref TLeaves leaves, out long visited)
        where TSearch : ISearch
        where TLeaves : struct, ILeaves
    {
        RayBlock block;
        TraversalStack stack;
        stack.Cost = 0;
        bool isMet = tree.Count > 0 && RayBlock.Load(&block, ray, distance, tree.Bounds) && Follow<TSearch, TLeaves>(tree.Nodes, &block, 0, 0, &stack, ref leaves);
        visited = stack.Cost;
        return isMet;
    }

    /// <summary>Follows a ray.</summary>
    /// <param name="nodes">The tree's nodes.</param>
    /// <param name="rays">The rays, of which one is traced.</param>
    /// <param name="ray">Which one.</param>
    /// <param name="start">Node or leaf to begin with.</param>
    /// <param name="stack">Memory to work with.</param>
    /// <param name="leaves">The tree's leaves.</param>
    /// <returns>True if there is a hit, for any hit.</returns>
    /// <remarks>Long, because a call in the loop would cost more than what is in it.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static bool Follow<TSearch, TLeaves>(BvhNode* nodes, RayBlock* rays, int ray, uint start, TraversalStack* stack, ref TLeaves leaves)
        where TSearch : ISearch
        where TLeaves : struct, ILeaves
    {
        const int size = RayBlock.Size;
        float* constants = rays->Inverse + ray;
        bool negativeX = constants[0] < 0f;
        bool negativeY = constants[size] < 0f;
        bool negativeZ = constants[2 * size] < 0f;
        int nearX = negativeX ? 24 : 0;
        int nearY = negativeY ? 32 : 8;
        int nearZ = negativeZ ? 40 : 16;
        float* lowerShift = rays->LowerShift + ray;
        float* upperShift = rays->UpperShift + ray;
        Vector256<float> inverseX = Lanes8.Broadcast(constants);
        Vector256<float> inverseY = Lanes8.Broadcast(constants + size);
        Vector256<float> inverseZ = Lanes8.Broadcast(constants + (2 * size));
        Vector256<float> nearShiftX = Lanes8.Broadcast(negativeX ? upperShift : lowerShift);
        Vector256<float> nearShiftY = Lanes8.Broadcast((negativeY ? upperShift : lowerShift) + size);
        Vector256<float> nearShiftZ = Lanes8.Broadcast((negativeZ ? upperShift : lowerShift) + (2 * size));
        Vector256<float> farShiftX = Lanes8.Broadcast(negativeX ? lowerShift : upperShift);
        Vector256<float> farShiftY = Lanes8.Broadcast((negativeY ? lowerShift : upperShift) + size);
        Vector256<float> farShiftZ = Lanes8.Broadcast((negativeZ ? lowerShift : upperShift) + (2 * size));

        int octant = (negativeX ? 1 : 0) | (negativeY ? 2 : 0);
        octant = negativeZ ? octant ^ 3 : octant;
        Vector256<int> shifts = negativeZ ? Vector256.Create(21, 18, 15, 12, 9, 6, 3, 0) : Vector256.Create(0, 3, 6, 9, 12, 15, 18, 21);
        int backward = negativeZ ? 7 : 0;
        float distance = rays->Distance[ray];
        uint* pending = stack->Reference;
        float* entries = stack->Entry;
        int depth = 0;
        uint current = start;
        while (true)
        {
            while ((current & BvhNode.LeafBit) == 0)
            {
                BvhNode* node = nodes + current;
                if (TSearch.Counts)
                {
                    stack->Cost++;
                }

                Vector256<float> stepX = Lanes8.Broadcast(node->Step) * inverseX;
                Vector256<float> stepY = Lanes8.Broadcast(node->Step + 1) * inverseY;
                Vector256<float> stepZ = Lanes8.Broadcast(node->Step + 2) * inverseZ;
                Vector256<float> originX = Lanes8.Broadcast(node->Origin);
                Vector256<float> originY = Lanes8.Broadcast(node->Origin + 1);
                Vector256<float> originZ = Lanes8.Broadcast(node->Origin + 2);
                byte* planes = node->Lower;
                Vector256<float> entryX = Lanes8.MultiplyAdd(Lanes8.FromBytes(planes + nearX), stepX, Lanes8.MultiplyAdd(originX, inverseX, nearShiftX));
                Vector256<float> entryY = Lanes8.MultiplyAdd(Lanes8.FromBytes(planes + nearY), stepY, Lanes8.MultiplyAdd(originY, inverseY, nearShiftY));
                Vector256<float> entryZ = Lanes8.MultiplyAdd(Lanes8.FromBytes(planes + nearZ), stepZ, Lanes8.MultiplyAdd(originZ, inverseZ, nearShiftZ));
                Vector256<float> exitX = Lanes8.MultiplyAdd(Lanes8.FromBytes(planes + (24 - nearX)), stepX, Lanes8.MultiplyAdd(originX, inverseX, farShiftX));
                Vector256<float> exitY = Lanes8.MultiplyAdd(Lanes8.FromBytes(planes + (40 - nearY)), stepY, Lanes8.MultiplyAdd(originY, inverseY, farShiftY));
                Vector256<float> exitZ = Lanes8.MultiplyAdd(Lanes8.FromBytes(planes + (56 - nearZ)), stepZ, Lanes8.MultiplyAdd(originZ, inverseZ, farShiftZ));

                // NaN, of what is too large for numbers, is always the first of two operands here, and counts as no limit.
                Vector256<float> entry = Lanes8.Max(Lanes8.Max(entryX, entryY), Lanes8.Max(entryZ, Vector256<float>.Zero));
                Vector256<float> exit = Lanes8.Min(Lanes8.Min(exitX, exitY), Lanes8.Min(exitZ, Vector256.Create(distance)));
                Vector256<float> passed = Vector256.LessThanOrEqual(entry, exit) & Vector256.GreaterThan(Vector256.Create(node->Count), Vector256<int>.Indices).AsSingle();
                uint hits = Lanes8.Bits(passed);
                if (hits == 0)
                {
                    goto next;
                }

                uint* children = node->Child;
                if ((hits & (hits - 1)) == 0)
                {
                    current = children[BitOperations.TrailingZeroCount(hits)];
                    continue;
                }

                if (TSearch.EndsAtAnyHit)
                {
                    current = children[BitOperations.TrailingZeroCount(hits)];
                    hits &= hits - 1;
                    Lanes8.Permute(Vector256.Load((int*)children), CompressTable.Permutation(hits)).Store((int*)pending + depth);
                }
                else
                {
                    // The last one in the order is the nearest: it comes next, the others are put aside.
                    int packed = node->Order[octant];
                    Vector256<int> order = Lanes8.ShiftRight(packed, shifts);
                    hits = Lanes8.Bits(Lanes8.Permute(passed, order));
                    int nearest = BitOperations.Log2(hits);
                    current = children[packed >> (3 * (nearest ^ backward)) & 7];
                    hits ^= 1u << nearest;
                    order = Lanes8.Permute(order, CompressTable.Permutation(hits));
                    Lanes8.Permute(entry, order).Store(entries + depth);
                    Lanes8.Permute(Vector256.Load((int*)children), order).Store((int*)pending + depth);
                }

                depth += BitOperations.PopCount(hits);
                leaves.Prefetch(nodes, pending[depth - 1]);
            }

            if (leaves.Meet(current, ref distance) && TSearch.EndsAtAnyHit)
            {
                return true;
            }

        next:
            do
            {
                if (depth == 0)
                {
                    return false;
                }

                depth--;
            }
            while (!TSearch.EndsAtAnyHit && entries[depth] > distance);
            current = pending[depth];
        }
    }
}
