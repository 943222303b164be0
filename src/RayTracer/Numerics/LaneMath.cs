using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

/// <summary>The project's own transcendental functions, whose bits are the same on every machine.</summary>
public static class LaneMath
{
    /// <summary>Placeholder.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Pow(float x, float y) => x * y;
}
