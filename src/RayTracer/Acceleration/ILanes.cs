using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>The meaning of the eight lanes of a register; the triangle test is written once for both ways.</summary>
internal unsafe interface ILanes
{
    /// <summary>Reads a quantity of the triangles.</summary>
    static abstract Vector256<float> OfTriangle(float* from);

    /// <summary>Reads a quantity of the rays.</summary>
    static abstract Vector256<float> OfRay(float* from);
}

/// <summary>Eight triangles and one ray.</summary>
internal readonly unsafe struct TriangleLanes : ILanes
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> OfTriangle(float* from) => Vector256.Load(from);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> OfRay(float* from) => Vector256.Create(*from);
}

/// <summary>One triangle and eight rays.</summary>
internal readonly unsafe struct RayLanes : ILanes
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> OfTriangle(float* from) => Vector256.Create(*from);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> OfRay(float* from) => Vector256.Load(from);
}

/// <summary>Eight pairs of a ray and a triangle.</summary>
internal readonly unsafe struct PairLanes : ILanes
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> OfTriangle(float* from) => Vector256.Load(from);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> OfRay(float* from) => Vector256.Load(from);
}
