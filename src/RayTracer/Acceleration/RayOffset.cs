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
/// On a box, the coordinate that tells is exact: uM from rounding the origin; on one that stands askew, it is a plane's height. In the frame of a shape with an axis, which reaches s from its origin: 3 us
/// each from the two turns into the frame and the turn back, 4 us from the foot on the surface, 3 us from F, whose sign at the origin decides (a torus
/// has it in double precision), and 2√3·uM from the roundings of point and origin: with |origin| + s = M, at most 19 uM.
/// </remarks>
public static class RayOffset
{
    /// <summary>Fraction of the largest coordinate: 24 u, which is 12 to 24 units in the last place.</summary>
    public const float Relative = 1.5f / (1 << 20);
}
