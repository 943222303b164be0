using System.Numerics;

namespace RayTracer.Numerics;

/// <summary>
/// The products of <see cref="Vector3"/> with a fixed order of operations: the framework's own round differently from
/// machine to machine.
/// </summary>
public static class Vector3Exact
{
    /// <summary>The scalar product.</summary>
    public static float Dot(this Vector3 a, Vector3 b) =>
        float.FusedMultiplyAdd(a.Z, b.Z, float.FusedMultiplyAdd(a.Y, b.Y, a.X * b.X));

    /// <summary>The vector product.</summary>
    public static Vector3 Cross(this Vector3 a, Vector3 b) => new(
        float.FusedMultiplyAdd(-a.Z, b.Y, a.Y * b.Z),
        float.FusedMultiplyAdd(-a.X, b.Z, a.Z * b.X),
        float.FusedMultiplyAdd(-a.Y, b.X, a.X * b.Y));

    /// <summary>The Euclidean length.</summary>
    public static float Norm(this Vector3 a)
    {
        // Squares of large and small numbers are out of range: a length that can be held is found all the same.
        float square = a.Dot(a);
        return square is > 1e-30f and < float.PositiveInfinity
            ? float.Sqrt(square)
            : (float)double.Sqrt(((double)a.X * a.X) + ((double)a.Y * a.Y) + ((double)a.Z * a.Z));
    }

    /// <summary>The vector scaled to length 1; NaN for the null vector.</summary>
    public static Vector3 Unit(this Vector3 a) => a * (1f / a.Norm());

    /// <summary>The largest of the coordinates.</summary>
    public static float Largest(this Vector3 a) => float.Max(a.X, float.Max(a.Y, a.Z));

    /// <summary>True where every coordinate is finite.</summary>
    public static bool IsFinite(this Vector3 a) => float.IsFinite(a.X) && float.IsFinite(a.Y) && float.IsFinite(a.Z);
}
