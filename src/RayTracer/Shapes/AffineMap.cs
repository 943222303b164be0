using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>A map from a point to one number, g·p + c, as four floats of a packed table: how flat shapes find their uv.</summary>
internal static unsafe class AffineMap
{
    /// <summary>
    /// Writes the map of gradient <paramref name="gradient"/> that takes <paramref name="origin"/> to <paramref name="value"/>.
    /// </summary>
    public static void Write(float* map, Vector3 gradient, Vector3 origin, float value)
    {
        map[0] = gradient.X;
        map[1] = gradient.Y;
        map[2] = gradient.Z;
        map[3] = value - gradient.Dot(origin);
    }

    /// <summary>Applies one map to every lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Apply(float* map, Vec3W p) =>
        FloatW.MultiplyAdd(p.X, map[0], FloatW.MultiplyAdd(p.Y, map[1], FloatW.MultiplyAdd(p.Z, map[2], map[3])));

    /// <summary>Applies each lane's own map.</summary>
    public static FloatW Apply(in PrimitiveIndex primitives, float* table, int constant, in Vec3W p) =>
        FloatW.MultiplyAdd(p.X, primitives.Read(table, constant), FloatW.MultiplyAdd(
            p.Y, primitives.Read(table, constant + 1), FloatW.MultiplyAdd(
            p.Z, primitives.Read(table, constant + 2), primitives.Read(table, constant + 3))));
}
