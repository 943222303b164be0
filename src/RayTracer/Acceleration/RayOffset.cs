namespace RayTracer.Acceleration;

/// <summary>
/// How far from a surface a new ray starts: a few dozen units in the last place of the coordinates it was computed from,
/// so that the rule holds in scenes of every scale (after Wächter &amp; Binder, A fast and robust method for avoiding
/// self-intersection, Ray Tracing Gems 2019).
/// </summary>
internal static class RayOffset
{
    /// <summary>Fraction of the largest coordinate: 64 units in the last place.</summary>
    public const float Relative = 1f / (1 << 18);
}
