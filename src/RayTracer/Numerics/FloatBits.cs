namespace RayTracer.Numerics;

/// <summary>Floats named by their place among the floats.</summary>
internal static class FloatBits
{
    /// <summary>The largest float below 1.</summary>
    public const float OneMinusEpsilon = 0.99999994f;
}
