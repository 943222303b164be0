using System.Numerics;
using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

/// <summary>A point or direction in each lane.</summary>
public readonly struct Vec3W
{
    /// <summary>The coordinates.</summary>
    public readonly FloatW X, Y, Z;

    /// <summary>From coordinates.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W(FloatW x, FloatW y, FloatW z)
    {
        X = x;
        Y = y;
        Z = z;
    }

    /// <summary>The same vector in every lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Vec3W(Vector3 v) => new(v.X, v.Y, v.Z);

    /// <summary>The three numbers from table[first] on, for indices in a register; the one behind them must be readable.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Vec3W Gather(float* table, UIntW first)
    {
        FloatW.Gather(table, first, out FloatW x, out FloatW y, out FloatW z);
        return new(x, y, z);
    }

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W operator +(Vec3W a, Vec3W b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W operator -(Vec3W a, Vec3W b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W operator -(Vec3W a) => new(-a.X, -a.Y, -a.Z);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W operator *(Vec3W a, FloatW s) => new(a.X * s, a.Y * s, a.Z * s);

    /// <summary>a·s + b, each coordinate with one rounding.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W MultiplyAdd(Vec3W a, FloatW s, Vec3W b) => new(
        FloatW.MultiplyAdd(a.X, s, b.X), FloatW.MultiplyAdd(a.Y, s, b.Y), FloatW.MultiplyAdd(a.Z, s, b.Z));

    /// <summary>b − a·s, each coordinate with one rounding.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W NegatedMultiplyAdd(Vec3W a, FloatW s, Vec3W b) => new(
        FloatW.NegatedMultiplyAdd(a.X, s, b.X), FloatW.NegatedMultiplyAdd(a.Y, s, b.Y), FloatW.NegatedMultiplyAdd(a.Z, s, b.Z));

    /// <summary>The scalar product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Dot(Vec3W a, Vec3W b) =>
        FloatW.MultiplyAdd(a.Z, b.Z, FloatW.MultiplyAdd(a.Y, b.Y, a.X * b.X));

    /// <summary>The vector product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W Cross(Vec3W a, Vec3W b) => new(
        FloatW.NegatedMultiplyAdd(a.Z, b.Y, a.Y * b.Z),
        FloatW.NegatedMultiplyAdd(a.X, b.Z, a.Z * b.X),
        FloatW.NegatedMultiplyAdd(a.Y, b.X, a.X * b.Y));

    /// <summary>The vector scaled to length 1; NaN for the null vector.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W Normalize(Vec3W a) => a * (1f / FloatW.Sqrt(Dot(a, a)));

    /// <summary>
    /// The direction of the mirror image of a ray that comes along <paramref name="d"/> onto a surface of normal <paramref name="n"/>.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W Reflect(Vec3W d, Vec3W n) => MultiplyAdd(n, Dot(d, n) * -2f, d);
}
