using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>
/// The triangles of a leaf: ten rows with as many entries as triangles: x, y and z of the first corner, of the second, of the third, and the
/// triangles' numbers.
/// </summary>
internal static unsafe class TriangleLeaf
{
    /// <summary>Floats a triangle.</summary>
    public const int Rows = 10;

    /// <summary>The axis after a major axis, two bits each.</summary>
    private const int NextAxis = 0b00_10_01;

    /// <summary>The axis before a major axis, two bits each.</summary>
    private const int AxisBefore = 0b01_00_10;

    /// <summary>The first minor axis.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int MinorX(int major) => NextAxis >> (2 * major) & 3;

    /// <summary>The second minor axis.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int MinorY(int major) => AxisBefore >> (2 * major) & 3;

    /// <summary>One ray and all triangles of a leaf.</summary>
    /// <returns>Whether the ray's distance or primitive changed, or, for any hit, whether there is one.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Intersect<TSearch>(float* triangles, uint leaf, RayBlock* rays, int ray)
        where TSearch : ISearch
    {
        int count = BvhNode.LeafCount(leaf);
        float* rows = triangles + ((long)BvhNode.LeafFirst(leaf) * Rows);
        int major = rays->Major[ray];
        int axisX = MinorX(major);
        int axisY = MinorY(major);
        float* px = rows + (axisX * count);
        float* py = rows + (axisY * count);
        float* pz = rows + (major * count);
        int toB = 3 * count;
        int toC = 6 * count;

        Vector256<float> originZ = Lanes8.Broadcast(rays->Origin + (RayBlock.Size * major) + ray);
        Vector256<float> az = Vector256.Load(pz) - originZ;
        Vector256<float> bz = Vector256.Load(pz + toB) - originZ;
        Vector256<float> cz = Vector256.Load(pz + toC) - originZ;
        Vector256<float> originX = Lanes8.Broadcast(rays->Origin + (RayBlock.Size * axisX) + ray);
        Vector256<float> shearX = Lanes8.Broadcast(rays->ShearX + ray);
        Vector256<float> ax = TriangleTest.Shear(Vector256.Load(px) - originX, shearX, az);
        Vector256<float> bx = TriangleTest.Shear(Vector256.Load(px + toB) - originX, shearX, bz);
        Vector256<float> cx = TriangleTest.Shear(Vector256.Load(px + toC) - originX, shearX, cz);
        Vector256<float> originY = Lanes8.Broadcast(rays->Origin + (RayBlock.Size * axisY) + ray);
        Vector256<float> shearY = Lanes8.Broadcast(rays->ShearY + ray);
        Vector256<float> ay = TriangleTest.Shear(Vector256.Load(py) - originY, shearY, az);
        Vector256<float> by = TriangleTest.Shear(Vector256.Load(py + toB) - originY, shearY, bz);
        Vector256<float> cy = TriangleTest.Shear(Vector256.Load(py + toC) - originY, shearY, cz);
        Vector256<float> hit = TriangleTest.Edges(ax, ay, bx, by, cx, cy, out Vector256<float> u, out Vector256<float> v, out Vector256<float> w);
        uint triangleSet = (2u << (count - 1)) - 1;
        if ((Lanes8.Bits(hit) & triangleSet) == 0)
        {
            return false;
        }

        hit = TriangleTest.Settle(hit, ax, ay, bx, by, cx, cy, ref u, ref v, ref w);
        Vector256<float> slack = Lanes8.Broadcast(rays->Slack + ray);
        Vector256<float> t = TriangleTest.Distance(u, v, w, az, bz, cz, Lanes8.Broadcast(rays->Scale + ray));
        Vector256<float> inverseX = Lanes8.Broadcast(rays->Inverse + (RayBlock.Size * axisX) + ray);
        Vector256<float> inverseY = Lanes8.Broadcast(rays->Inverse + (RayBlock.Size * axisY) + ray);
        t = TriangleTest.Clamp(t, Vector256.Load(px) - originX, Vector256.Load(px + toB) - originX, Vector256.Load(px + toC) - originX, inverseX, slack);
        t = TriangleTest.Clamp(t, Vector256.Load(py) - originY, Vector256.Load(py + toB) - originY, Vector256.Load(py + toC) - originY, inverseY, slack);
        Vector256<float> limit = Lanes8.Broadcast(rays->Distance + ray);
        hit &= Vector256.GreaterThan(t, Vector256<float>.Zero);
        if (TSearch.EndsAtAnyHit)
        {
            return (Lanes8.Bits(hit & Vector256.LessThan(t, limit)) & triangleSet) != 0;
        }

        uint hits = Lanes8.Bits(hit & Vector256.LessThanOrEqual(t, limit)) & triangleSet;
        return hits != 0 && Nearest(t, hits, (int*)(rows + (9 * count)), rays, ray);
    }

    /// <summary>One triangle of a leaf and eight rays with the same major axis.</summary>
    /// <param name="rows">The leaf.</param>
    /// <param name="count">Triangles in the leaf.</param>
    /// <param name="triangle">Which of them.</param>
    /// <param name="rays">The rays.</param>
    /// <param name="lane">First of the eight.</param>
    /// <param name="major">Their major axis.</param>
    /// <param name="rayset">Which of the eight are meant.</param>
    /// <returns>The rays whose distance or primitive changed, or, for any hit, those that have one.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Intersect<TSearch>(float* rows, int count, int triangle, RayBlock* rays, int lane, int major, uint rayset)
        where TSearch : ISearch
    {
        int axisX = MinorX(major);
        int axisY = MinorY(major);
        float* px = rows + (axisX * count) + triangle;
        float* py = rows + (axisY * count) + triangle;
        float* pz = rows + (major * count) + triangle;
        int toB = 3 * count;
        int toC = 6 * count;
        float* origin = rays->Origin + lane;

        Vector256<float> originZ = Vector256.Load(origin + (RayBlock.Size * major));
        Vector256<float> az = Lanes8.Broadcast(pz) - originZ;
        Vector256<float> bz = Lanes8.Broadcast(pz + toB) - originZ;
        Vector256<float> cz = Lanes8.Broadcast(pz + toC) - originZ;
        Vector256<float> originX = Vector256.Load(origin + (RayBlock.Size * axisX));
        Vector256<float> shearX = Vector256.Load(rays->ShearX + lane);
        Vector256<float> ax = TriangleTest.Shear(Lanes8.Broadcast(px) - originX, shearX, az);
        Vector256<float> bx = TriangleTest.Shear(Lanes8.Broadcast(px + toB) - originX, shearX, bz);
        Vector256<float> cx = TriangleTest.Shear(Lanes8.Broadcast(px + toC) - originX, shearX, cz);
        Vector256<float> originY = Vector256.Load(origin + (RayBlock.Size * axisY));
        Vector256<float> shearY = Vector256.Load(rays->ShearY + lane);
        Vector256<float> ay = TriangleTest.Shear(Lanes8.Broadcast(py) - originY, shearY, az);
        Vector256<float> by = TriangleTest.Shear(Lanes8.Broadcast(py + toB) - originY, shearY, bz);
        Vector256<float> cy = TriangleTest.Shear(Lanes8.Broadcast(py + toC) - originY, shearY, cz);
        Vector256<float> hit = TriangleTest.Edges(ax, ay, bx, by, cx, cy, out Vector256<float> u, out Vector256<float> v, out Vector256<float> w);
        if ((Lanes8.Bits(hit) & rayset) == 0)
        {
            return 0;
        }

        hit = TriangleTest.Settle(hit, ax, ay, bx, by, cx, cy, ref u, ref v, ref w);
        Vector256<float> slack = Vector256.Load(rays->Slack + lane);
        Vector256<float> t = TriangleTest.Distance(u, v, w, az, bz, cz, Vector256.Load(rays->Scale + lane));
        Vector256<float> inverseX = Vector256.Load(rays->Inverse + (RayBlock.Size * axisX) + lane);
        Vector256<float> inverseY = Vector256.Load(rays->Inverse + (RayBlock.Size * axisY) + lane);
        t = TriangleTest.Clamp(t, Lanes8.Broadcast(px) - originX, Lanes8.Broadcast(px + toB) - originX, Lanes8.Broadcast(px + toC) - originX, inverseX, slack);
        t = TriangleTest.Clamp(t, Lanes8.Broadcast(py) - originY, Lanes8.Broadcast(py + toB) - originY, Lanes8.Broadcast(py + toC) - originY, inverseY, slack);
        Vector256<float> limit = Vector256.Load(rays->Distance + lane);
        Vector256<float> nearer = Vector256.LessThan(t, limit);
        hit &= Vector256.GreaterThan(t, Vector256<float>.Zero);
        if (TSearch.EndsAtAnyHit)
        {
            return Lanes8.Bits(hit & nearer) & rayset;
        }

        Vector256<int> number = Vector256.Create(((int*)rows)[(9 * count) + triangle]);
        Vector256<int> primitive = Vector256.Load(rays->Primitive + lane);
        hit &= nearer | (Vector256.Equals(t, limit) & Vector256.LessThan(number, primitive).AsSingle());
        uint hits = Lanes8.Bits(hit) & rayset;
        if (hits != 0)
        {
            hit &= Vector256.Equals(Vector256.Create(rayset) & s_bits, s_bits).AsSingle();
            Vector256.ConditionalSelect(hit, t, limit).Store(rays->Distance + lane);
            Vector256.ConditionalSelect(hit.AsInt32(), number, primitive).Store(rays->Primitive + lane);
        }

        return hits;
    }

    private static readonly Vector256<uint> s_bits = Vector256.Create(1u, 2, 4, 8, 16, 32, 64, 128);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool Nearest(Vector256<float> t, uint hits, int* numbers, RayBlock* rays, int ray)
    {
        float distance = rays->Distance[ray];
        int primitive = rays->Primitive[ray];
        int before = primitive;
        for (; hits != 0; hits &= hits - 1)
        {
            int lane = BitOperations.TrailingZeroCount(hits);
            float candidate = t[lane];
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
}
