using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>
/// Up to 64 rays with everything that boxes and triangles are tested with, computed once. All kernels read rays from here, so that
/// they cannot differ in it.
/// </summary>
/// <remarks>
/// Boxes are tested a little enlarged: by 13 uR, with u = 2⁻²⁴ and R the largest distance of coordinates that occurs between the ray's
/// start and the tree's bounds, plus the start's own. Of that, 4 uR cover the rounding of the box test, as it is done anywhere; 3 uR that of the limits
/// that <see cref="TriangleTest{TLanes}"/> puts on a hit; the rest is more than the 4 uR by which a corner moves in the plane of the
/// triangle test (Woop, Benthin &amp; Wald 2013, section 3.3, have the same idea).
/// </remarks>
internal unsafe struct RayBlock
{
    /// <summary>Number of rays that fit.</summary>
    public const int Size = 64;

    /// <summary>Largest coordinate of a start; rays from beyond hit nothing.</summary>
    public const float LargestOrigin = 1e18f;

    private const float Roundoff = 1f / (1 << 24);
    private const float BoxSlack = 13 * Roundoff;
    private const float TriangleSlack = 5 * Roundoff;

    /// <summary>By what factor boxes are enlarged more than <see cref="Slack"/> says.</summary>
    public const float BoxToTriangleSlack = BoxSlack / TriangleSlack;

    /// <summary>The origins of the rays, one axis after another.</summary>
    public fixed float Origin[3 * Size];

    /// <summary>Inverse directions; components near zero are moved away from it.</summary>
    public fixed float Inverse[3 * Size];

    /// <summary>The terms to which planes at lower ends of boxes, times the inverse direction, are added.</summary>
    public fixed float LowerShift[3 * Size];

    /// <summary>The terms to which planes at upper ends of boxes, times the inverse direction, are added.</summary>
    public fixed float UpperShift[3 * Size];

    /// <summary>The movement of a ray along the first minor axis while it moves by one along the major one.</summary>
    public fixed float ShearX[Size];

    /// <summary>The movement of a ray along the second minor axis while it moves by one along the major one.</summary>
    public fixed float ShearY[Size];

    /// <summary>The inverse of the direction's largest component.</summary>
    public fixed float Scale[Size];

    /// <summary>By how much a triangle's own box is enlarged.</summary>
    public fixed float Slack[Size];

    /// <summary>Limit, then distance of the nearest hit.</summary>
    public fixed float Distance[Size];

    /// <summary>The primitive that was hit, or −1.</summary>
    public fixed int Primitive[Size];

    /// <summary>The axis along which each ray moves fastest.</summary>
    public fixed int Major[Size];

    /// <summary>For each ray the triangles of a leaf that it may hit.</summary>
    public fixed byte Candidates[Size];

    /// <summary>Rows of a leaf in which triangle i is the one that ray i may hit.</summary>
    public fixed float Paired[9 * 8];

    /// <summary>Spare, so that what follows begins at a cache line.</summary>
    public fixed float Spare[8];

    /// <summary>Takes rays of a stream.</summary>
    /// <param name="block">The block to fill.</param>
    /// <param name="rays">The stream.</param>
    /// <param name="first">Index of the first ray, or place of the first index.</param>
    /// <param name="count">The number of rays, 1 to 64.</param>
    /// <param name="order">Which rays to take; null for consecutive ones. Only the lower half of each number counts.</param>
    /// <param name="bounds">The tree's bounds.</param>
    /// <returns>The rays that can hit something.</returns>
    public static ulong Load(RayBlock* block, in RayStream rays, int first, int count, ulong* order, in Box4 bounds)
    {
        if (order == null && count == Size)
        {
            Copy(rays.OriginX + first, block->Origin);
            Copy(rays.OriginY + first, block->Origin + Size);
            Copy(rays.OriginZ + first, block->Origin + (2 * Size));
            Copy(rays.DirectionX + first, block->Inverse);
            Copy(rays.DirectionY + first, block->Inverse + Size);
            Copy(rays.DirectionZ + first, block->Inverse + (2 * Size));
            Copy(rays.Distance + first, block->Distance);
        }
        else
        {
            Gather(block, rays, first, count, order);
        }

        new Span<int>(block->Primitive, Size).Fill(-1);
        ulong alive = 0;
        for (int lane = 0; lane < count; lane += 8)
        {
            alive |= (ulong)Prepare(block, lane, bounds) << lane;
        }

        return count == Size ? alive : alive & ((1ul << count) - 1);
    }

    /// <summary>Takes one ray, as the first of the block.</summary>
    /// <param name="block">The block to fill.</param>
    /// <param name="ray">The ray.</param>
    /// <param name="distance">The largest distance at which hits count.</param>
    /// <param name="bounds">The tree's bounds.</param>
    /// <returns>True if it can hit something.</returns>
    public static bool Load(RayBlock* block, in SpaceRay ray, float distance, in Box4 bounds)
    {
        Vector128<float> origin = ray.Origin.AsVector128();
        Vector128<float> direction = ray.Direction.AsVector128();
        Vector128<float> sizes = Vector128.Abs(direction);
        int major = sizes[0] >= sizes[1] && sizes[0] >= sizes[2] ? 0 : sizes[1] >= sizes[2] ? 1 : 2;
        (float largest, float along) = (sizes[major], direction[major]);
        block->Major[0] = major;
        block->ShearX[0] = direction[TriangleLeaf.MinorX(major)] / along;
        block->ShearY[0] = direction[TriangleLeaf.MinorY(major)] / along;
        block->Scale[0] = 1f / along;
        block->Distance[0] = distance;
        block->Primitive[0] = -1;

        // The operations and their order are those of many rays.
        Vector128<float> far = Vector128.Abs(origin);
        Vector128<float> reaches = far + Lanes8.Max(Vector128.Abs(bounds.Lower - origin), Vector128.Abs(bounds.Upper - origin));
        float reach = 0f;
        for (int axis = 0; axis < 3; axis++)
        {
            reach = reach > reaches[axis] ? reach : reaches[axis];
        }

        block->Slack[0] = reach * TriangleSlack;
        Vector128<float> slack = Vector128.Create(reach * BoxSlack);
        Vector128<float> least = Vector128.Create(largest * (1f / (1L << 40)));
        Vector128<float> inverse = Vector128<float>.One / (Lanes8.Max(sizes, least) | (direction & Vector128.Create(-0f)));
        Vector128<float> lower = -((origin + slack) * inverse);
        Vector128<float> upper = -((origin - slack) * inverse);
        for (int axis = 0; axis < 3; axis++)
        {
            block->Origin[axis * Size] = origin[axis];
            block->Inverse[axis * Size] = inverse[axis];
            block->LowerShift[axis * Size] = lower[axis];
            block->UpperShift[axis * Size] = upper[axis];
        }

        Vector128<float> nothing = direction * 0f;
        return largest > 1f / LargestOrigin && largest < LargestOrigin && far[0] + far[1] + far[2] + nothing[0] + nothing[1] + nothing[2] < LargestOrigin && distance > 0f;
    }

    private static void Copy(float* from, float* to) => new ReadOnlySpan<float>(from, Size).CopyTo(new(to, Size));

    /// <summary>Takes rays one by one; the last one fills its register.</summary>
    private static void Gather(RayBlock* block, in RayStream rays, int first, int count, ulong* order)
    {
        RayStream from = rays;
        for (int i = 0; i < (count + 7 & ~7); i++)
        {
            int place = first + Math.Min(i, count - 1);
            int ray = order == null ? place : (int)(uint)order[place];
            block->Origin[i] = from.OriginX[ray];
            block->Origin[Size + i] = from.OriginY[ray];
            block->Origin[(2 * Size) + i] = from.OriginZ[ray];
            block->Inverse[i] = from.DirectionX[ray];
            block->Inverse[Size + i] = from.DirectionY[ray];
            block->Inverse[(2 * Size) + i] = from.DirectionZ[ray];
            block->Distance[i] = from.Distance[ray];
        }
    }

    /// <summary>Computes what follows from origin and direction, which stands where the inverse will.</summary>
    /// <returns>The lanes whose rays can hit something.</returns>
    private static uint Prepare(RayBlock* block, int lane, in Box4 bounds)
    {
        Vector256<float> x = Vector256.Load(block->Inverse + lane);
        Vector256<float> y = Vector256.Load(block->Inverse + Size + lane);
        Vector256<float> z = Vector256.Load(block->Inverse + (2 * Size) + lane);
        Vector256<float> sizeX = Vector256.Abs(x);
        Vector256<float> sizeY = Vector256.Abs(y);
        Vector256<float> sizeZ = Vector256.Abs(z);
        Vector256<float> alongX = Vector256.GreaterThanOrEqual(sizeX, sizeY) & Vector256.GreaterThanOrEqual(sizeX, sizeZ);
        Vector256<float> alongY = Vector256.AndNot(Vector256.GreaterThanOrEqual(sizeY, sizeZ), alongX);
        Vector256<float> major = Select(alongX, alongY, x, y, z);
        Vector256<float> largest = Vector256.Abs(major);
        Select(alongX.AsInt32(), alongY.AsInt32(), 0, 1, 2).Store(block->Major + lane);
        (Select(alongX, alongY, y, z, x) / major).Store(block->ShearX + lane);
        (Select(alongX, alongY, z, x, y) / major).Store(block->ShearY + lane);
        (Vector256<float>.One / major).Store(block->Scale + lane);

        Vector256<float> reach = Vector256<float>.Zero;
        Vector256<float> farthest = Vector256<float>.Zero;
        for (int axis = 0; axis < 3; axis++)
        {
            Vector256<float> origin = Vector256.Load(block->Origin + (axis * Size) + lane);
            Vector256<float> size = Vector256.Abs(origin);
            Vector256<float> toLower = Vector256.Abs(Vector256.Create(bounds.Lower[axis]) - origin);
            Vector256<float> toUpper = Vector256.Abs(Vector256.Create(bounds.Upper[axis]) - origin);
            reach = Lanes8.Max(reach, size + Lanes8.Max(toLower, toUpper));
            farthest += size;
        }

        (reach * TriangleSlack).Store(block->Slack + lane);
        Vector256<float> slack = reach * BoxSlack;
        Vector256<float> least = largest * (1f / (1L << 40));
        PrepareAxis(block, lane, x, least, slack);
        PrepareAxis(block, Size + lane, y, least, slack);
        PrepareAxis(block, (2 * Size) + lane, z, least, slack);

        // A comparison with NaN is false.
        Vector256<float> sane = Vector256.GreaterThan(largest, Vector256.Create(1f / LargestOrigin)) & Vector256.LessThan(largest, Vector256.Create(LargestOrigin));
        sane &= Vector256.LessThan(farthest + (x * 0f) + (y * 0f) + (z * 0f), Vector256.Create(LargestOrigin));
        return Lanes8.Bits(sane & Vector256.GreaterThan(Vector256.Load(block->Distance + lane), Vector256<float>.Zero));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void PrepareAxis(RayBlock* block, int lane, Vector256<float> direction, Vector256<float> least, Vector256<float> slack)
    {
        Vector256<float> sign = direction & Vector256.Create(-0f);
        Vector256<float> inverse = Vector256<float>.One / (Lanes8.Max(Vector256.Abs(direction), least) | sign);
        Vector256<float> origin = Vector256.Load(block->Origin + lane);
        inverse.Store(block->Inverse + lane);
        (-((origin + slack) * inverse)).Store(block->LowerShift + lane);
        (-((origin - slack) * inverse)).Store(block->UpperShift + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Select(Vector256<float> first, Vector256<float> second, Vector256<float> a, Vector256<float> b, Vector256<float> c) =>
        Vector256.ConditionalSelect(first, a, Vector256.ConditionalSelect(second, b, c));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<int> Select(Vector256<int> first, Vector256<int> second, int a, int b, int c) =>
        Vector256.ConditionalSelect(first, Vector256.Create(a), Vector256.ConditionalSelect(second, Vector256.Create(b), Vector256.Create(c)));
}
