using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>
/// A tree over the triangles of a mesh. Rays cannot slip between triangles that share an edge. A hit is the same to the bit, however it is looked
/// for: it counts at distances above zero and below the ray's limit, and of equally near triangles the one of the lowest number is
/// hit. Both sides of a triangle count. Triangles without area, with missing corners, or with coordinates that are not finite or beyond ±10¹⁸, and rays
/// whose origins or directions are not finite or beyond reason, never hit.
/// </summary>
internal sealed unsafe class TriangleBvh
{
    private const int LeafSize = 8;

    // Below so many rays, sorting costs more than it saves.
    private const int WorthSorting = 1024;
    private readonly WideBvh _tree;
    private readonly NativeMemoryBlock _triangles;

    private TriangleBvh(WideBvh tree, NativeMemoryBlock triangles)
    {
        _tree = tree;
        _triangles = triangles;
    }

    /// <summary>Triangles in the tree, without those that can never be hit.</summary>
    public int Count => _tree.Count;

    /// <summary>Lower corner of the box of all triangles; infinite where there are none.</summary>
    public Vector3 Lower => _tree.Bounds.Lower.AsVector3();

    /// <summary>Upper corner of the box of all triangles; infinite and negative where there are none.</summary>
    public Vector3 Upper => _tree.Bounds.Upper.AsVector3();

    /// <summary>The size and shape of the tree, memory of the triangles included.</summary>
    public BvhStatistics Statistics => _tree.Statistics with { MemoryBytes = _tree.MemoryBytes + _triangles.Bytes };

    /// <summary>Builds a tree, which keeps its own copy of the triangles.</summary>
    /// <param name="positions">The corners.</param>
    /// <param name="indices">Three corners a triangle.</param>
    /// <param name="threads">Number of threads; the tree is the same with any.</param>
    /// <exception cref="ArgumentException">The indices are not three a triangle, or there are more than 2²⁸ triangles.</exception>
    public static TriangleBvh Build(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> indices, int threads)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(threads, 1);
        if (indices.Length % 3 != 0)
        {
            throw new ArgumentException("Triangles need three indices each.", nameof(indices));
        }

        fixed (Vector3* corners = positions)
        fixed (int* numbers = indices)
        {
            TriangleBounds triangles = new(corners, positions.Length, numbers, indices.Length / 3);
            WideBvh tree = BvhBuilder.Build(triangles, LeafSize, threads);
            NativeMemoryBlock packed = TrianglePacker.Pack(tree, triangles, threads);
            tree.ReleaseOrder();
            return new(tree, packed);
        }
    }

    /// <summary>Finds the nearest hit of each ray.</summary>
    /// <param name="rays">The rays; distances and primitives are written.</param>
    /// <param name="mode">The strategy of the traversal; the result is the same.</param>
    public void ClosestHit(in RayStream rays, TraversalMode mode = TraversalMode.Automatic) => Trace<ClosestSearch>(rays, mode);

    /// <summary>Finds out which rays hit anything.</summary>
    /// <param name="rays">The rays; primitives are written: 0 for a hit, −1 for none.</param>
    /// <param name="mode">The strategy of the traversal; the result is the same.</param>
    public void AnyHit(in RayStream rays, TraversalMode mode = TraversalMode.Automatic) => Trace<AnySearch>(rays, mode);

    /// <summary>Finds the nearest hit of a ray.</summary>
    /// <param name="origin">The point from which it starts.</param>
    /// <param name="direction">Its direction, of any length.</param>
    /// <param name="distance">In: the limit. Out: the distance in multiples of the direction, if there is a hit.</param>
    /// <param name="primitive">The triangle; −1 where there is none.</param>
    /// <returns>True if there is a hit.</returns>
    public bool ClosestHit(Vector3 origin, Vector3 direction, ref float distance, out int primitive)
    {
        (distance, primitive, _) = TraceOne<ClosestSearch>(origin, direction, distance);
        return primitive >= 0;
    }

    /// <summary>Returns whether a ray hits anything.</summary>
    /// <param name="origin">The point from which it starts.</param>
    /// <param name="direction">Its direction, of any length.</param>
    /// <param name="distance">The limit, in multiples of the direction.</param>
    public bool AnyHit(Vector3 origin, Vector3 direction, float distance) => TraceOne<AnySearch>(origin, direction, distance).Primitive >= 0;

    /// <summary>
    /// What it costs a ray by itself to find its nearest hit: visited nodes plus tested triangles. A measure of the tree, and the same whatever mode
    /// pictures are rendered with.
    /// </summary>
    /// <param name="origin">The point from which it starts.</param>
    /// <param name="direction">Its direction, of any length.</param>
    /// <param name="distance">The limit, in multiples of the direction.</param>
    public long Cost(Vector3 origin, Vector3 direction, float distance) => TraceOne<CountingSearch>(origin, direction, distance).Cost;

    private (float Distance, int Primitive, long Cost) TraceOne<TSearch>(Vector3 origin, Vector3 direction, float distance)
        where TSearch : ISearch
    {
        RayBlock rays;
        TraversalStack stack;
        stack.Cost = 0;
        if (!RayBlock.Load(&rays, new(origin, direction), distance, _tree.Bounds))
        {
            return (distance, -1, 0);
        }

        TriangleLeaves<TSearch> leaves = new((float*)_triangles.Pointer, &rays, 0, &stack);
        bool any = SingleRayTraversal.Follow<TSearch, TriangleLeaves<TSearch>>(_tree.Nodes, &rays, 0, 0, &stack, ref leaves);
        GC.KeepAlive(this);
        return TSearch.EndsAtAnyHit ? (distance, any ? 0 : -1, stack.Cost) : (rays.Distance[0], rays.Primitive[0], stack.Cost);
    }

    private void Trace<TSearch>(in RayStream rays, TraversalMode mode)
        where TSearch : ISearch
    {
        byte* memory = stackalloc byte[sizeof(BlockWorkspace) + 64];
        BlockWorkspace* workspace = Align(memory);
        if (mode == TraversalMode.Automatic)
        {
            mode = rays.Count < WorthSorting || RayCoherence.IsHigh(rays) ? TraversalMode.Blocks : TraversalMode.Sorted;
        }

        switch (mode)
        {
            case TraversalMode.Single:
                TraceSingly<TSearch>(rays, workspace);
                break;
            case TraversalMode.Sorted:
                for (int first = 0; first < rays.Count; first += RayOrder.Capacity)
                {
                    int count = Math.Min(RayOrder.Capacity, rays.Count - first);
                    TraceBlocks<TSearch>(rays, 0, count, RayOrder.OfThread.Sort(rays, first, count), workspace);
                }

                break;
            default:
                TraceBlocks<TSearch>(rays, 0, rays.Count, null, workspace);
                break;
        }

        GC.KeepAlive(this);
    }

    private void TraceSingly<TSearch>(in RayStream rays, BlockWorkspace* workspace)
        where TSearch : ISearch
    {
        RayBlock* block = &workspace->Rays;
        for (int first = 0; first < rays.Count; first += RayBlock.Size)
        {
            int count = Math.Min(RayBlock.Size, rays.Count - first);
            ulong alive = RayBlock.Load(block, rays, first, count, null, _tree.Bounds);
            ulong hit = 0;
            for (ulong left = alive; left != 0; left &= left - 1)
            {
                int ray = BitOperations.TrailingZeroCount(left);
                TriangleLeaves<TSearch> leaves = new((float*)_triangles.Pointer, block, ray, &workspace->Single);
                bool any = SingleRayTraversal.Follow<TSearch, TriangleLeaves<TSearch>>(_tree.Nodes, block, ray, 0, &workspace->Single, ref leaves);
                hit |= any ? 1ul << ray : 0;
            }

            Store<TSearch>(rays, block, first, count, null, hit);
        }
    }

    private void TraceBlocks<TSearch>(in RayStream rays, int start, int end, ulong* order, BlockWorkspace* workspace)
        where TSearch : ISearch
    {
        BlockTraversal<TSearch> traversal = new(_tree.Nodes, (float*)_triangles.Pointer, workspace);
        for (int first = start; first < end; first += RayBlock.Size)
        {
            int count = Math.Min(RayBlock.Size, end - first);
            ulong alive = RayBlock.Load(&workspace->Rays, rays, first, count, order, _tree.Bounds);
            ulong free = traversal.Follow(alive);
            Store<TSearch>(rays, &workspace->Rays, first, count, order, alive & ~free);
        }
    }

    private static void Store<TSearch>(in RayStream rays, RayBlock* block, int first, int count, ulong* order, ulong hit)
        where TSearch : ISearch
    {
        RayStream to = rays;
        if (TSearch.EndsAtAnyHit)
        {
            for (int i = 0; i < count; i++)
            {
                int ray = order == null ? first + i : (int)(uint)order[first + i];
                to.Primitive[ray] = (int)(hit >> i & 1) - 1;
            }
        }
        else
        {
            for (int i = 0; i < count; i++)
            {
                // The distance is the limit still where nothing was hit.
                int ray = order == null ? first + i : (int)(uint)order[first + i];
                to.Primitive[ray] = block->Primitive[i];
                to.Distance[ray] = block->Distance[i];
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static BlockWorkspace* Align(byte* memory) => (BlockWorkspace*)(((nint)memory + 63) & ~63);
}

/// <summary>The way in which a stream of rays goes through a tree. All ways find the same hits, to the bit.</summary>
internal enum TraversalMode
{
    /// <summary>By what the rays look like: blocks as they come where neighbours point the same way, else sorted.</summary>
    Automatic,

    /// <summary>One ray after another: one ray against eight boxes or eight triangles.</summary>
    Single,

    /// <summary>Blocks of 64 rays in the order in which they come.</summary>
    Blocks,

    /// <summary>Blocks of 64 rays after sorting all by origin and direction.</summary>
    Sorted,
}
