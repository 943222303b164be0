using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>Lines that shapes are drawn with in views from elsewhere; each is a chain of points.</summary>
public static class WireLines
{
    private const int CirclePoints = 32;

    /// <summary>A circle around a point.</summary>
    /// <param name="center">The point.</param>
    /// <param name="u">A unit vector in its plane.</param>
    /// <param name="v">Another one, perpendicular to it.</param>
    /// <param name="radius">The radius.</param>
    public static Vector3[] Circle(Vector3 center, Vector3 u, Vector3 v, float radius) => [.. Enumerable.Range(0, CirclePoints + 1).Select(i =>
    {
        LaneMath.SinCosTurn(i % CirclePoints / (float)CirclePoints, out float sin, out float cos);
        return center + (((u * cos) + (v * sin)) * radius);
    })];

    /// <summary>A parallelogram around a point, with half its edges.</summary>
    public static Vector3[] Square(Vector3 center, Vector3 u, Vector3 v) => [center - u - v, center + u - v, center + u + v, center - u + v, center - u - v];

    /// <summary>The edges of a box: a ring below, a ring above, and the four between them; none where the box has no end.</summary>
    public static IEnumerable<Vector3[]> Box(Bounds box)
    {
        if (!box.IsFinite)
        {
            return [];
        }

        Vector3[] c = [.. box.Corners()];
        return [[c[0], c[1], c[3], c[2], c[0]], [c[4], c[5], c[7], c[6], c[4]], [c[0], c[4]], [c[1], c[5]], [c[2], c[6]], [c[3], c[7]]];
    }

    /// <summary>Two unit vectors perpendicular to an axis and to each other.</summary>
    public static (Vector3 U, Vector3 V) Across(Vector3 axis)
    {
        Vector3 a = axis.Unit();
        Vector3 u = a.Cross(MathF.Abs(a.X) < 0.5f ? Vector3.UnitX : Vector3.UnitY).Unit();
        return (u, a.Cross(u));
    }
}
