using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayTracer.Acceleration;

/// <summary>
/// The triangles of a leaf: ten rows with as many entries as triangles: x, y and z of the first corner, of the second, of the third, and the
/// triangles' numbers.
/// </summary>
internal static unsafe class TriangleLeaf
{
    /// <summary>Floats a triangle.</summary>
    public const int Rows = 10;

    // The axes after and before each major axis, two bits each.
    private const int AxisAfter = 0b00_10_01;
    private const int AxisBefore = 0b01_00_10;

    /// <summary>The first minor axis.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int MinorX(int major) => AxisAfter >> (2 * major) & 3;

    /// <summary>The second minor axis.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int MinorY(int major) => AxisBefore >> (2 * major) & 3;

    /// <summary>Asks for the memory of a node or leaf that will be visited soon.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Prefetch(BvhNode* nodes, float* triangles, uint reference)
    {
        if (Sse.IsSupported)
        {
            byte* leaf = (byte*)(triangles + ((nint)BvhNode.LeafFirst(reference) * Rows));
            byte* place = (reference & BvhNode.LeafBit) != 0 ? leaf : (byte*)(nodes + reference);
            Sse.Prefetch0(place);
            Sse.Prefetch0(place + 64);
            Sse.Prefetch0(place + 128);
        }
    }

    /// <summary>One ray and all triangles of a leaf.</summary>
    /// <returns>True if the ray's distance or primitive changed, or, for any hit, whether there is one.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Intersect<TSearch>(float* rows, int count, RayBlock* rays, int ray, int major)
        where TSearch : ISearch
    {
        nint stride = count;
        float* x = rows + (MinorX(major) * stride);
        float* y = rows + (MinorY(major) * stride);
        float* z = rows + (major * stride);
        float* origin = rays->Origin;
        uint candidates = TriangleTest<TriangleLanes>.Candidates<TSearch>(
            Vector256.Load(x), Vector256.Load(x + (3 * stride)), Vector256.Load(x + (6 * stride)),
            Vector256.Load(y), Vector256.Load(y + (3 * stride)), Vector256.Load(y + (6 * stride)),
            Vector256.Load(z), Vector256.Load(z + (3 * stride)), Vector256.Load(z + (6 * stride)),
            origin + (RayBlock.Size * MinorX(major)), origin + (RayBlock.Size * MinorY(major)), origin + (RayBlock.Size * major), rays, ray, out uint sure);
        uint triangles = (2u << (count - 1)) - 1;
        return (candidates & triangles) != 0 && ((sure & triangles) != 0 || Update<TSearch>(rows, count, rays, ray, major));
    }

    /// <summary>All triangles of a leaf and rays with the same major axis, ray by ray.</summary>
    /// <returns>The rays whose distance or primitive changed, or, for any hit, those that have one.</returns>
    public static ulong IntersectRays<TSearch>(float* rows, int count, RayBlock* rays, ulong set, int major)
        where TSearch : ISearch
    {
        nint stride = count;
        float* x = rows + (MinorX(major) * stride);
        float* y = rows + (MinorY(major) * stride);
        float* z = rows + (major * stride);
        Vector256<float> ax = Vector256.Load(x);
        Vector256<float> bx = Vector256.Load(x + (3 * stride));
        Vector256<float> cx = Vector256.Load(x + (6 * stride));
        Vector256<float> ay = Vector256.Load(y);
        Vector256<float> by = Vector256.Load(y + (3 * stride));
        Vector256<float> cy = Vector256.Load(y + (6 * stride));
        Vector256<float> az = Vector256.Load(z);
        Vector256<float> bz = Vector256.Load(z + (3 * stride));
        Vector256<float> cz = Vector256.Load(z + (6 * stride));
        float* originX = rays->Origin + (RayBlock.Size * MinorX(major));
        float* originY = rays->Origin + (RayBlock.Size * MinorY(major));
        float* originZ = rays->Origin + (RayBlock.Size * major);
        uint triangles = (2u << (count - 1)) - 1;

        // No call may stand in this loop: it would throw the triangles out of their registers.
        byte* met = rays->Candidates;
        Vector256<byte>.Zero.Store(met);
        Vector256<byte>.Zero.Store(met + 32);
        ulong candidates = 0;
        ulong certain = 0;
        for (ulong left = set; left != 0; left &= left - 1)
        {
            int ray = BitOperations.TrailingZeroCount(left);
            uint hits = TriangleTest<TriangleLanes>.Candidates<TSearch>(ax, bx, cx, ay, by, cy, az, bz, cz, originX, originY, originZ, rays, ray, out uint sure);
            met[ray] = (byte)(hits & triangles);
            candidates |= ((hits & triangles) != 0 ? 1ul : 0ul) << ray;
            certain |= ((sure & triangles) != 0 ? 1ul : 0ul) << ray;
        }

        ulong changed = certain;
        candidates &= ~certain;
        while (candidates != 0)
        {
            int lane = BitOperations.TrailingZeroCount(candidates) & ~7;
            changed |= (ulong)UpdatePairs<TSearch>(rows, count, rays, lane, major) << lane;
            candidates &= ~(0xfful << lane);
        }

        return changed & set;
    }

    /// <summary>One triangle of a leaf and rays with the same major axis, eight rays at a time.</summary>
    /// <returns>The rays whose distance or primitive changed, or, for any hit, those that have one.</returns>
    public static ulong IntersectTriangle<TSearch>(float* rows, int count, int triangle, RayBlock* rays, ulong set, int major)
        where TSearch : ISearch
    {
        nint stride = count;
        float* x = rows + (MinorX(major) * stride) + triangle;
        float* y = rows + (MinorY(major) * stride) + triangle;
        float* z = rows + (major * stride) + triangle;
        Vector256<float> ax = Vector256.Create(*x);
        Vector256<float> bx = Vector256.Create(x[3 * stride]);
        Vector256<float> cx = Vector256.Create(x[6 * stride]);
        Vector256<float> ay = Vector256.Create(*y);
        Vector256<float> by = Vector256.Create(y[3 * stride]);
        Vector256<float> cy = Vector256.Create(y[6 * stride]);
        Vector256<float> az = Vector256.Create(*z);
        Vector256<float> bz = Vector256.Create(z[3 * stride]);
        Vector256<float> cz = Vector256.Create(z[6 * stride]);
        float* originX = rays->Origin + (RayBlock.Size * MinorX(major));
        float* originY = rays->Origin + (RayBlock.Size * MinorY(major));
        float* originZ = rays->Origin + (RayBlock.Size * major);
        ulong candidates = 0;
        ulong certain = 0;
        for (int lane = 0; lane < RayBlock.Size; lane += 8)
        {
            if ((set >> lane & 0xff) != 0)
            {
                uint hits = TriangleTest<RayLanes>.Candidates<TSearch>(ax, bx, cx, ay, by, cy, az, bz, cz, originX, originY, originZ, rays, lane, out uint sure);
                candidates |= (ulong)hits << lane;
                certain |= (ulong)sure << lane;
            }
        }

        ulong changed = certain & set;
        candidates &= set & ~certain;
        while (candidates != 0)
        {
            int lane = BitOperations.TrailingZeroCount(candidates) & ~7;
            ulong eight = 0xfful << lane;
            int number = ((int*)rows)[(9 * count) + triangle];
            changed |= (ulong)Update<TSearch>(rows + triangle, count, number, rays, lane, major, (uint)((candidates & eight) >> lane)) << lane;
            candidates &= ~eight;
        }

        return changed;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool Update<TSearch>(float* rows, int count, RayBlock* rays, int ray, int major)
        where TSearch : ISearch
    {
        uint candidates = (2u << (count - 1)) - 1;
        Vector256<float> distances = TriangleTest<TriangleLanes>.Distance(rows, count, rays, ray, major);
        float distance = rays->Distance[ray];
        Vector256<float> near = Vector256.GreaterThan(distances, Vector256<float>.Zero);
        if (TSearch.EndsAtAnyHit)
        {
            return (Lanes8.Bits(near & Vector256.LessThan(distances, Vector256.Create(distance))) & candidates) != 0;
        }

        uint hits = Lanes8.Bits(near & Vector256.LessThanOrEqual(distances, Vector256.Create(distance))) & candidates;
        int* numbers = (int*)rows + (9 * count);
        int primitive = rays->Primitive[ray];
        int before = primitive;
        for (; hits != 0; hits &= hits - 1)
        {
            int lane = BitOperations.TrailingZeroCount(hits);
            float candidate = distances[lane];

            // With no hit yet the primitive is −1, and a hit at the limit does not count.
            if (candidate < distance || (candidate == distance && numbers[lane] < primitive))
            {
                distance = candidate;
                primitive = numbers[lane];
            }
        }

        rays->Distance[ray] = distance;
        rays->Primitive[ray] = primitive;
        return primitive != before;
    }

    /// <summary>Eight rays, each with the triangles that it may hit, one after another.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static uint UpdatePairs<TSearch>(float* rows, int count, RayBlock* rays, int lane, int major)
        where TSearch : ISearch
    {
        uint changed = 0;
        Vector256<int> left = Vector256.ConvertToInt32(Lanes8.FromBytes(rays->Candidates + lane));
        while (left != Vector256<int>.Zero)
        {
            // The lowest bit's place, from the exponent of its value.
            Vector256<int> lowest = left & -left;
            uint active = ~Vector256.Equals(left, Vector256<int>.Zero).ExtractMostSignificantBits() & 0xff;
            Vector256<int> triangle = (Vector256.ConvertToSingle(lowest).AsInt32() >>> 23) - Vector256.Create(127);
            triangle &= Vector256.Create(7);
            left ^= lowest;
            for (int row = 0; row < 9; row++)
            {
                Lanes8.Permute(Vector256.Load(rows + (row * count)), triangle).Store(rays->Paired + (8 * row));
            }

            Vector256<int> numbers = Lanes8.Permute(Vector256.Load((int*)rows + (9 * count)), triangle);
            Vector256<float> distances = TriangleTest<PairLanes>.Distance(rays->Paired, 8, rays, lane, major);
            changed |= Shorten<TSearch>(distances, numbers, rays, lane, active);
        }

        return changed;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static uint Update<TSearch>(float* rows, int count, int number, RayBlock* rays, int lane, int major, uint candidates)
        where TSearch : ISearch =>
        Shorten<TSearch>(TriangleTest<RayLanes>.Distance(rows, count, rays, lane, major), Vector256.Create(number), rays, lane, candidates);

    /// <summary>Shortens those of eight rays for which a hit is nearer, or as near and of a lower number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Shorten<TSearch>(Vector256<float> distances, Vector256<int> numbers, RayBlock* rays, int lane, uint candidates)
        where TSearch : ISearch
    {
        Vector256<float> limits = Vector256.Load(rays->Distance + lane);
        Vector256<float> near = Vector256.GreaterThan(distances, Vector256<float>.Zero);
        Vector256<float> nearer = Vector256.LessThan(distances, limits);
        if (TSearch.EndsAtAnyHit)
        {
            return Lanes8.Bits(near & nearer) & candidates;
        }

        // With no hit yet the primitive is −1, and a hit at the limit does not count.
        Vector256<int> primitives = Vector256.Load(rays->Primitive + lane);
        Vector256<float> hit = near & (nearer | (Vector256.Equals(distances, limits) & Vector256.LessThan(numbers, primitives).AsSingle())) & Lanes8.FromBits(candidates);
        Vector256.ConditionalSelect(hit, distances, limits).Store(rays->Distance + lane);
        Vector256.ConditionalSelect(hit.AsInt32(), numbers, primitives).Store(rays->Primitive + lane);
        return Lanes8.Bits(hit);
    }
}

/// <summary>The leaves of a tree of triangles, as one ray of a block meets them; its hit is stored there.</summary>
/// <param name="triangles">The triangles of all leaves.</param>
/// <param name="rays">The block.</param>
/// <param name="ray">Which of its rays.</param>
/// <param name="stack">Counts.</param>
internal readonly unsafe struct TriangleLeaves<TSearch>(float* triangles, RayBlock* rays, int ray, TraversalStack* stack) : ILeaves
    where TSearch : ISearch
{
    private readonly int _major = rays->Major[ray];

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Prefetch(BvhNode* nodes, uint reference) => TriangleLeaf.Prefetch(nodes, triangles, reference);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Meet(uint leaf, ref float distance)
    {
        int count = BvhNode.LeafCount(leaf);
        if (TSearch.Counts)
        {
            stack->Cost += count;
        }

        if (!TriangleLeaf.Intersect<TSearch>(triangles + ((nint)BvhNode.LeafFirst(leaf) * TriangleLeaf.Rows), count, rays, ray, _major))
        {
            return false;
        }

        distance = TSearch.EndsAtAnyHit ? distance : rays->Distance[ray];
        return true;
    }
}
