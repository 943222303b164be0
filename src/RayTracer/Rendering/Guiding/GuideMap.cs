using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// The map between directions and the unit square, which keeps areas: the turn around z, and the height (Müller, Gross &amp; Novák 2017,
/// section 3.2). So a density in the square, over 4π, is one per steradian.
/// </summary>
internal static class GuideMap
{
    /// <summary>Steradians of the whole square.</summary>
    public const float Solid = 4 * float.Pi;

    /// <summary>Returns the point of a unit direction.</summary>
    public static void ToSquare(in Vec3W direction, out FloatW u, out FloatW v)
    {
        FloatW turn = LaneMath.Atan2(direction.Y, direction.X) * (0.5f / float.Pi);
        turn = (turn < 0f).Select(turn + 1f, turn);
        u = FloatW.Min(turn, FloatBits.OneMinusEpsilon);
        v = FloatW.Max(FloatW.Min(FloatW.MultiplyAdd(direction.Z, 0.5f, 0.5f), FloatBits.OneMinusEpsilon), 0f);
    }

    /// <summary>Returns the unit direction of a point.</summary>
    public static Vec3W ToDirection(in FloatW u, in FloatW v)
    {
        FloatW z = FloatW.MultiplyAdd(v, 2f, -1f);
        FloatW radius = FloatW.Sqrt(FloatW.Max(FloatW.NegatedMultiplyAdd(z, z, 1f), 0f));
        LaneMath.SinCosTurn(u, out FloatW sin, out FloatW cos);
        return new(radius * cos, radius * sin, z);
    }
}
