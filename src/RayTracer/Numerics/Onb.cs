using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

/// <summary>An orthonormal basis (the report's class of that name): W is the normal, U and V span the surface.</summary>
public readonly struct Onb
{
    /// <summary>The axes: unit vectors, perpendicular to one another, right-handed.</summary>
    public readonly Vec3W U, V, W;

    /// <summary>From axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Onb(in Vec3W u, in Vec3W v, in Vec3W w)
    {
        U = u;
        V = v;
        W = w;
    }

    /// <summary>
    /// A basis around a unit vector, without branches (Duff et al., Building an orthonormal basis, revisited, JCGT 2017).
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void FromNormal(in Vec3W n, out Onb frame)
    {
        FloatW sign = FloatW.CopySign(1f, n.Z);
        FloatW a = -1f / (sign + n.Z);
        FloatW b = n.X * n.Y * a;
        FloatW signX = sign * n.X;
        frame = new(
            new Vec3W(FloatW.MultiplyAdd(signX * n.X, a, 1f), sign * b, -signX),
            new Vec3W(b, FloatW.MultiplyAdd(n.Y * n.Y, a, sign), -n.Y),
            n);
    }

    /// <summary>The vector with the given coordinates along U, V and W.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W ToWorld(Vec3W local) =>
        Vec3W.MultiplyAdd(U, local.X, Vec3W.MultiplyAdd(V, local.Y, W * local.Z));

    /// <summary>The coordinates of a vector along U, V and W.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W ToLocal(Vec3W world) => new(Vec3W.Dot(world, U), Vec3W.Dot(world, V), Vec3W.Dot(world, W));
}
