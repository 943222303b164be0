namespace RayTracer.Acceleration;

/// <summary>
/// How far from a surface a new ray starts: some units in the last place of the coordinates it was computed from,
/// so that the rule holds in scenes of every scale (after Wächter &amp; Binder, A fast and robust method for avoiding
/// self-intersection, Ray Tracing Gems 2019).
/// </summary>
/// <remarks>
/// Errors along the normal, with unit roundoff u = 2⁻²⁴ and M the largest coordinate. On a plane: √14·uM from the height that moves the
/// point onto it, √3·uM each from rounding that point and the origin, and √14·uM from the origin's height as the next ray finds it, 11 uM in all. On a
/// sphere of radius r: 7 ur from normal and difference to the centre, 2√3·uM from the roundings of point and origin, and 7 ur from the roots, at most 17 uM.
/// </remarks>
internal static class RayOffset
{
    /// <summary>Fraction of the largest coordinate: 24 u, which is 12 to 24 units in the last place.</summary>
    public const float Relative = 1.5f / (1 << 20);
}
