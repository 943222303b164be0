using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>The maps of each lane's instance, into the world and back, as a packet.</summary>
/// <param name="memory">Room for <see cref="Floats"/> floats.</param>
internal readonly unsafe ref struct InstanceMaps(float* memory)
{
    /// <summary>Floats of the widest packet.</summary>
    public const int Floats = InstanceTable.Stride * 16;

    private readonly float* _memory = memory;

    /// <summary>One instance for all lanes.</summary>
    public void Fill(InstanceTable table, int instance, in FloatW time)
    {
        float* scratch = stackalloc float[InstanceTable.Stride];
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            Write(lane, table.MapsAt(instance, table.Moves ? time[lane] : 0, scratch));
        }
    }

    /// <summary>Each lane's own instance.</summary>
    public void Fill(InstanceTable table, in UIntW instance, in FloatW time)
    {
        float* scratch = stackalloc float[InstanceTable.Stride];
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            Write(lane, table.MapsAt((int)instance[lane], table.Moves ? time[lane] : 0, scratch));
        }
    }

    /// <summary>Each lane's own map, without its inverse: for a camera that moves.</summary>
    public void Fill(Motion motion, in FloatW time)
    {
        float* scratch = stackalloc float[InstanceTable.Stride];
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            motion.At(time[lane]).Write(scratch);
            Write(lane, scratch);
        }
    }

    /// <summary>As <see cref="Fill(Motion, in FloatW)"/>, with the inverse.</summary>
    public void FillBothWays(Motion motion, in FloatW time)
    {
        float* scratch = stackalloc float[InstanceTable.Stride];
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            InstanceTable.WriteMaps(motion.At(time[lane]), scratch);
            Write(lane, scratch);
        }
    }

    /// <summary>A point of the space, in the world.</summary>
    public Vec3W Point(in Vec3W p) => new(Row(0, p), Row(4, p), Row(8, p));

    /// <summary>A point of the world, in the space.</summary>
    public Vec3W PointBack(in Vec3W p) => new(Row(12, p), Row(16, p), Row(20, p));

    /// <summary>A vector of the space, in the world.</summary>
    public Vec3W Vector(in Vec3W v) => new(RowLinear(0, v), RowLinear(4, v), RowLinear(8, v));

    /// <summary>A vector of the world, in the space.</summary>
    public Vec3W VectorBack(in Vec3W v) => new(RowLinear(12, v), RowLinear(16, v), RowLinear(20, v));

    /// <summary>A normal of the space, in the world, where it has another length: the inverse transposed times it.</summary>
    public Vec3W NormalOut(in Vec3W n) => new(Column(12, n), Column(13, n), Column(14, n));

    /// <summary>The factor on volumes into the world.</summary>
    public FloatW Determinant() => Vec3W.Dot(new(Number(0), Number(1), Number(2)), Vec3W.Cross(new(Number(4), Number(5), Number(6)), new(Number(8), Number(9), Number(10))));

    /// <summary>The factor on areas into the world, of a surface with the given unit normal in the space.</summary>
    public FloatW AreaFactor(in Vec3W normal)
    {
        Vec3W outside = NormalOut(normal);
        return FloatW.Abs(Determinant()) * FloatW.Sqrt(Vec3W.Dot(outside, outside));
    }

    /// <summary>Moves a surface from the space into the world.</summary>
    /// <param name="hasShading">True if it is shaded with another normal.</param>
    /// <param name="hasTangents">True if it says how points move with u and v.</param>
    /// <param name="surface">In: the surface in the space. Out: in the world, and in the space, from which the instance's rays start.</param>
    public void Describe(bool hasShading, bool hasTangents, ref SurfaceW surface)
    {
        Vec3W inside = surface.Point;
        (surface.InnerPoint, surface.InnerNormal, surface.InnerOffset) = (inside, surface.Normal, surface.Offset);
        surface.Point = Point(inside);
        surface.Normal = Vec3W.Normalize(NormalOut(surface.Normal));

        // New rays meet their own instance from a start in its space. For all else they start here, beyond what the point is rounded by.
        surface.Offset = LargestSum(0, inside) * (RayOffset.Relative / 6);
        if (hasShading)
        {
            surface.Shading = Vec3W.Normalize(NormalOut(surface.Shading));
        }

        if (hasTangents)
        {
            surface.AlongU = Vector(surface.AlongU);
            surface.AlongV = Vector(surface.AlongV);
        }
    }

    private void Write(int lane, float* maps)
    {
        for (int i = 0; i < InstanceTable.Stride; i++)
        {
            _memory[(i * FloatW.Count) + lane] = maps[i];
        }
    }

    private FloatW Number(int i) => FloatW.Load(_memory + (i * FloatW.Count));

    private FloatW Row(int i, in Vec3W p) =>
        FloatW.MultiplyAdd(p.X, Number(i), FloatW.MultiplyAdd(p.Y, Number(i + 1), FloatW.MultiplyAdd(p.Z, Number(i + 2), Number(i + 3))));

    private FloatW RowLinear(int i, in Vec3W v) => FloatW.MultiplyAdd(v.Z, Number(i + 2), FloatW.MultiplyAdd(v.Y, Number(i + 1), v.X * Number(i)));

    private FloatW Column(int i, in Vec3W v) => FloatW.MultiplyAdd(v.Z, Number(i + 8), FloatW.MultiplyAdd(v.Y, Number(i + 4), v.X * Number(i)));

    // The largest sum of magnitudes of a row.
    private FloatW LargestSum(int i, in Vec3W p) => FloatW.Max(Sum(i, p), FloatW.Max(Sum(i + 4, p), Sum(i + 8, p)));

    private FloatW Sum(int i, in Vec3W p) => FloatW.Abs(Number(i) * p.X) + FloatW.Abs(Number(i + 1) * p.Y) + FloatW.Abs(Number(i + 2) * p.Z) + FloatW.Abs(Number(i + 3));
}
