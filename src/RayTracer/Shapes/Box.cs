using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>Describes a <see cref="Box"/>.</summary>
[SceneType("box", "A box parallel to the axes, given by two opposite corners. On each of its faces uv goes from 0 to 1, as on a plane with "
    + "a size: seen from outside with y up, u grows to the right and v upwards; on the top and bottom, −z takes the place of y.")]
public sealed record BoxDescription : ShapeDescription
{
    /// <summary>One corner.</summary>
    [Parameter("One corner.", Unit = "scene units", Required = true)]
    public Vector3 A { get; init; }

    /// <summary>The opposite corner.</summary>
    [Parameter("The opposite corner.", Unit = "scene units", Required = true)]
    public Vector3 B { get; init; } = Vector3.One;

    /// <inheritdoc/>
    public override Vector3 Middle => 0.5f * (A + B);

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with { A = view.At(-Vector3.One), B = view.At(Vector3.One) };

    /// <inheritdoc/>
    public override ShapeDescription? Moved(in ShapeMove move) =>
        move.KeepsAxes ? this with { A = move.Point(A), B = move.Point(B) } : null;

    /// <inheritdoc/>
    public override Shape? Build(SceneBuilder builder)
    {
        Material material = builder.Material(Material);
        for (int axis = 0; axis < 3; axis++)
        {
            if (A[axis] == B[axis])
            {
                builder.Error(this, nameof(B), $"the box is flat: both corners have the same {"xyz"[axis]}");
                return null;
            }
        }

        return new Box(material, Name, A, B);
    }
}

/// <summary>A box parallel to the axes.</summary>
/// <param name="material">The material.</param>
/// <param name="name">A name for messages.</param>
/// <param name="a">One corner.</param>
/// <param name="b">The opposite corner.</param>
internal sealed class Box(Material material, string name, Vector3 a, Vector3 b) : Shape(material, name)
{
    private readonly Vector3 _size = Vector3.Abs(b - a);

    /// <inheritdoc/>
    public override Bounds Bounds { get; } = new(Vector3.Min(a, b), Vector3.Max(a, b));

    /// <inheritdoc/>
    public override float Area => 2 * (_size.X * _size.Y + _size.Y * _size.Z + _size.Z * _size.X);

    /// <inheritdoc/>
    public override ShapeBatch CreateBatch(IReadOnlyList<Shape> shapes) => new KernelBatch<BoxKernel>(shapes);

    /// <inheritdoc/>
    public override Shape? Transformed(Transform by) =>
        by.KeepsAxes ? Moved(by.Point(Bounds.Minimum), by.Point(Bounds.Maximum)) : TurnedBox.Create(this, by);

    /// <summary>Uniformly by area over the faces, three at the most, that are seen from the point.</summary>
    public override void SamplePdf(in Vec3W from, in FloatW distance, in FloatW cosine, out FloatW pdf)
    {
        FloatW areaX = FloatW.Abs(Side(from.X, 0)) * (_size.Y * _size.Z);
        FloatW areaY = FloatW.Abs(Side(from.Y, 1)) * (_size.Z * _size.X);
        pdf = AreaSample.Pdf(distance, cosine, FloatW.MultiplyAdd(FloatW.Abs(Side(from.Z, 2)), _size.X * _size.Y, areaX + areaY));
    }

    /// <inheritdoc/>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        FloatW signX = Side(from.X, 0);
        FloatW signY = Side(from.Y, 1);
        FloatW signZ = Side(from.Z, 2);
        FloatW areaX = FloatW.Abs(signX) * (_size.Y * _size.Z);
        FloatW areaY = FloatW.Abs(signY) * (_size.Z * _size.X);
        FloatW area = FloatW.MultiplyAdd(FloatW.Abs(signZ), _size.X * _size.Y, areaX + areaY);

        // v chooses the face, and what is left of it a point. From inside there is no face, and the minimum takes care of 0/0.
        FloatW rest = v * area;
        MaskW isX = rest < areaX;
        MaskW isY = (rest < areaX + areaY).Except(isX);
        FloatW within = isX.Select(rest / areaX, isY.Select((rest - areaX) / areaY, (rest - areaX - areaY) / (area - areaX - areaY)));
        FloatW first = FloatW.Min(within, FloatBits.OneMinusEpsilon);
        Vec3W normal = new(isX.Select(signX, 0f), isY.Select(signY, 0f), (isX | isY).Select(0f, signZ));

        // The coordinate across the face, from 0 to 1, and the two along it.
        Vec3W place = new(
            isX.Select(Across(signX), first),
            isY.Select(Across(signY), isX.Select(first, u)),
            (isX | isY).Select(u, Across(signZ)));
        Vec3W corner = Bounds.Minimum;
        Vec3W to = new Vec3W(
            FloatW.MultiplyAdd(place.X, _size.X, corner.X - from.X),
            FloatW.MultiplyAdd(place.Y, _size.Y, corner.Y - from.Y),
            FloatW.MultiplyAdd(place.Z, _size.Z, corner.Z - from.Z));
        AreaSample.Sample(to, normal, area, out sample);
        BoxKernel.Uv(place, normal, out sample.U, out sample.V);

        static FloatW Across(FloatW sign) => FloatW.MultiplyAdd(sign, 0.5f, 0.5f);
    }

    /// <summary>Either of two opposite places sees three faces: half of the area.</summary>
    internal override bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point)
    {
        FloatW doubled = v * 2f;
        MaskW isUpper = doubled >= 1f;
        Vec3W from = isUpper.Select((Vec3W)(Bounds.Maximum + _size), Bounds.Minimum - _size);
        return SampleSeen(from, u, isUpper.Select(doubled - 1f, doubled), out point);
    }

    // Rounding may leave nothing of a thin box far away.
    private Box? Moved(Vector3 low, Vector3 high) => high.X > low.X && high.Y > low.Y && high.Z > low.Z ? new(Material, Name, low, high) : null;

    // Which of an axis's two faces is seen: the upper one, the lower one, or none.
    private FloatW Side(FloatW coordinate, int axis) =>
        (coordinate > Bounds.Maximum[axis]).Select(1f, (coordinate < Bounds.Minimum[axis]).Select(-1f, 0f));
}
