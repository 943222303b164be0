using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// The space in which a shape with an axis is met: the origin on the axis, z along it, and x and y such that a picture wrapped around
/// an upright shape faces +z of the world, as on a sphere: x is to the right and y to the front. In a packed table, twelve floats.
/// </summary>
/// <param name="Origin">The world point of the local origin.</param>
/// <param name="Right">Unit vector of local x.</param>
/// <param name="Front">Unit vector of local y.</param>
/// <param name="Axis">Unit vector of local z.</param>
internal readonly record struct LocalFrame(Vector3 Origin, Vector3 Right, Vector3 Front, Vector3 Axis)
{
    /// <summary>Floats that a frame takes in a table.</summary>
    public const int Constants = 12;

    /// <summary>The frame around an axis through a point. Every number is the exact one, rounded.</summary>
    public static LocalFrame FromAxis(Vector3 origin, Vector3 axis)
    {
        double length = double.Sqrt((double)axis.X * axis.X + (double)axis.Y * axis.Y + (double)axis.Z * axis.Z);
        (double x, double y, double z) = (axis.X / length, axis.Y / length, axis.Z / length);

        // Right is axis × (0, 0, 1), and for an axis along z the world's right. Front is right × axis.
        double across = double.Sqrt(x * x + y * y);
        (double rightX, double rightY) = across > 1e-6 ? (y / across, -x / across) : (1, 0);
        return new(
            origin,
            new((float)rightX, (float)rightY, 0),
            new((float)(rightY * z), (float)(-rightX * z), (float)(rightX * y - rightY * x)),
            new((float)x, (float)y, (float)z));
    }

    /// <summary>The extent, along each of the world's axes, of a disk of a radius around a point of the axis.</summary>
    public Vector3 DiskReach(float radius)
    {
        Vector3 squared = (Right * Right) + (Front * Front);
        return new Vector3(float.Sqrt(squared.X), float.Sqrt(squared.Y), float.Sqrt(squared.Z)) * radius;
    }

    /// <summary>Writes the frame into a table.</summary>
    public unsafe void Write(float* entry)
    {
        ReadOnlySpan<Vector3> rows = [Origin, Right, Front, Axis];
        for (int i = 0; i < Constants; i++)
        {
            entry[i] = rows[i / 3][i % 3];
        }
    }

    /// <summary>Brings world points into the frame of a table's entry.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Vec3W PointToLocal(float* q, Vec3W p) => ToLocal(q, p - new Vec3W(q[0], q[1], q[2]));

    /// <summary>Brings world directions into the frame of a table's entry.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Vec3W ToLocal(float* q, Vec3W v) => new(
        Vec3W.Dot(v, new Vec3W(q[3], q[4], q[5])), Vec3W.Dot(v, new Vec3W(q[6], q[7], q[8])), Vec3W.Dot(v, new Vec3W(q[9], q[10], q[11])));

    /// <summary>The local vector as the world sees it.</summary>
    public Vec3W ToWorld(in Vec3W v) => Vec3W.MultiplyAdd(Right, v.X, Vec3W.MultiplyAdd(Front, v.Y, (Vec3W)Axis * v.Z));

    /// <summary>The turn around the axis of local points: 0.5 in front, growing to the right.</summary>
    public static FloatW Turn(in Vec3W p) => FloatW.MultiplyAdd(LaneMath.Atan2(p.X, p.Y), 0.5f / float.Pi, 0.5f);

    /// <summary>Sine and cosine along local x and y of a turn as <see cref="Turn"/> counts it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void AtTurn(FloatW turn, out FloatW x, out FloatW y)
    {
        LaneMath.SinCosTurn(turn, out FloatW sin, out FloatW cos);
        x = -sin;
        y = -cos;
    }
}

/// <summary>The local frames of the shapes that the lanes of a packet have hit.</summary>
internal readonly unsafe struct LocalFrameW
{
    private readonly Vec3W _origin, _right, _front, _axis;

    public LocalFrameW(in PrimitiveIndex primitives, float* table)
    {
        _origin = primitives.ReadVector(table, 0);
        _right = primitives.ReadVector(table, 3);
        _front = primitives.ReadVector(table, 6);
        _axis = primitives.ReadVector(table, 9);
    }

    /// <summary>Brings world points into the frames.</summary>
    public Vec3W PointToLocal(in Vec3W p)
    {
        Vec3W v = p - _origin;
        return new(Vec3W.Dot(v, _right), Vec3W.Dot(v, _front), Vec3W.Dot(v, _axis));
    }

    /// <summary>Brings world directions into the frames.</summary>
    public Vec3W ToLocal(in Vec3W v) => new(Vec3W.Dot(v, _right), Vec3W.Dot(v, _front), Vec3W.Dot(v, _axis));

    /// <summary>The local vector as the world sees it.</summary>
    public Vec3W ToWorld(in Vec3W v) => Vec3W.MultiplyAdd(_right, v.X, Vec3W.MultiplyAdd(_front, v.Y, _axis * v.Z));

    /// <summary>The local point as the world sees it.</summary>
    public Vec3W PointToWorld(in Vec3W p) =>
        Vec3W.MultiplyAdd(_right, p.X, Vec3W.MultiplyAdd(_front, p.Y, Vec3W.MultiplyAdd(_axis, p.Z, _origin)));
}
