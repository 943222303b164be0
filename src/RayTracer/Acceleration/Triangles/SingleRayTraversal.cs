using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>One ray through a tree of triangles: eight boxes or eight triangles at a time, nearer children first.</summary>
internal static unsafe class SingleRayTraversal
{
    /// <summary>Follows a ray.</summary>
    /// <param name="nodes">The tree's nodes.</param>
    /// <param name="triangles">The tree's leaves.</param>
    /// <param name="rays">The rays: one of them is traced, and its hit is stored there.</param>
    /// <param name="ray">Which one.</param>
    /// <param name="start">Node or leaf to begin with.</param>
    /// <param name="stack">Memory to work with.</param>
    /// <returns>True if there is a hit, for any hit.</returns>
    /// <remarks>Long, because a call in the loop would cost more than what is in it.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static bool Follow<TSearch>(BvhNode* nodes, float* triangles, RayBlock* rays, int ray, uint start, TraversalStack* stack)
        where TSearch : ISearch
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
        int major = rays->Major[ray];
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
                TriangleLeaf.Prefetch(nodes, triangles, pending[depth - 1]);
            }

            int count = BvhNode.LeafCount(current);
            if (TSearch.Counts)
            {
                stack->Cost += count;
            }

            if (TriangleLeaf.Intersect<TSearch>(triangles + ((nint)BvhNode.LeafFirst(current) * TriangleLeaf.Rows), count, rays, ray, major))
            {
                if (TSearch.EndsAtAnyHit)
                {
                    return true;
                }

                distance = rays->Distance[ray];
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
