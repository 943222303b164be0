using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>A box that stands askew: what a <see cref="Box"/> becomes when it is turned.</summary>
/// <param name="material">The material.</param>
/// <param name="name">A name for messages.</param>
/// <param name="center">The middle.</param>
/// <param name="axes">Three unit vectors, perpendicular to each other, along its edges: where the axes of the box went.</param>
/// <param name="half">Half the lengths of the edges.</param>
internal sealed class TurnedBox(Material material, string name, Vector3 center, (Vector3 X, Vector3 Y, Vector3 Z) axes, Vector3 half) : Shape(material, name)
{
    // The same box parallel to the axes around the origin: light does not care.
    private readonly Box _upright = new(material, name, -half, half);

    /// <summary>The middle.</summary>
    public Vector3 Center => center;

    /// <summary>Unit vectors along the edges.</summary>
    public (Vector3 X, Vector3 Y, Vector3 Z) Axes => axes;

    /// <summary>Half the lengths of the edges.</summary>
    public Vector3 Half => half;

    /// <inheritdoc/>
    public override Bounds Bounds
    {
        get
        {
            Vector3 reach = (Vector3.Abs(axes.X) * half.X) + (Vector3.Abs(axes.Y) * half.Y) + (Vector3.Abs(axes.Z) * half.Z);
            return new(center - reach, center + reach);
        }
    }

    /// <inheritdoc/>
    public override float Area => _upright.Area;

    /// <summary>
    /// The image of a box under a map; null where its edges would no longer be perpendicular to each other, or have no length.
    /// </summary>
    /// <param name="box">The box.</param>
    /// <param name="by">The map.</param>
    public static TurnedBox? Create(Box box, in Transform by)
    {
        Vector3 half = 0.5f * (box.Bounds.Maximum - box.Bounds.Minimum);
        (Vector3 x, Vector3 y, Vector3 z) = (by.Vector(Vector3.UnitX), by.Vector(Vector3.UnitY), by.Vector(Vector3.UnitZ));
        (float a, float b, float c) = (x.Norm(), y.Norm(), z.Norm());
        bool isBox = IsRightAngle(x.Dot(y), a * b) && IsRightAngle(y.Dot(z), b * c) && IsRightAngle(z.Dot(x), c * a);
        half *= new Vector3(a, b, c);
        return isBox && half.IsFinite() && half is { X: > 0, Y: > 0, Z: > 0 }
            ? new(box.Material, box.Name, by.Point((0.5f * box.Bounds.Minimum) + (0.5f * box.Bounds.Maximum)), (x * (1 / a), y * (1 / b), z * (1 / c)), half)
            : null;
    }

    /// <inheritdoc/>
    public override IEnumerable<Vector3[]> Wires(Vector3 middle, float reach) =>
        WireLines.Box(_upright.Bounds).Select(l => l.Select(p => center + (axes.X * p.X) + (axes.Y * p.Y) + (axes.Z * p.Z)).ToArray());

    /// <inheritdoc/>
    public override ShapeBatch CreateBatch(IReadOnlyList<Shape> shapes) => new KernelBatch<TurnedBoxKernel>(shapes);

    /// <inheritdoc/>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        _upright.SamplePoint(Within(from), u, v, out sample);
        sample.Direction = Turned(sample.Direction);
    }

    /// <inheritdoc/>
    internal override bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point)
    {
        _upright.SampleSurface(u, v, out Vec3W upright);
        point = Turned(upright) + center;
        return true;
    }

    /// <inheritdoc/>
    public override void SamplePdf(in Vec3W from, in FloatW distance, in FloatW cosine, out FloatW pdf) => _upright.SamplePdf(Within(from), distance, cosine, out pdf);

    // Angles of maps that were given in single precision.
    private static bool IsRightAngle(float product, float lengths) => float.Abs(product) <= 1e-6f * lengths;

    private Vec3W Turned(Vec3W p) => Vec3W.MultiplyAdd(axes.X, p.X, Vec3W.MultiplyAdd(axes.Y, p.Y, (Vec3W)axes.Z * p.Z));

    private Vec3W Within(in Vec3W point)
    {
        Vec3W p = point - center;
        return new(Vec3W.Dot(axes.X, p), Vec3W.Dot(axes.Y, p), Vec3W.Dot(axes.Z, p));
    }
}
