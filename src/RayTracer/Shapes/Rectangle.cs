using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>Describes a <see cref="Rectangle"/>.</summary>
[SceneType("rectangle", "A rectangle, given by a corner and the two edges that start there (a parallelogram, if they are not "
    + "perpendicular). uv is (0, 0) at the corner and (1, 1) at the opposite one. Its front, which shines if it is a luminaire, is where a "
    + "left turn leads from edgeU to edgeV. A plane with a size is a rectangle too, given by its centre and normal.")]
public sealed record RectangleDescription : ShapeDescription
{
    /// <summary>The corner where uv is (0, 0).</summary>
    [Parameter("The corner where uv is (0, 0).", Unit = "scene units", Required = true)]
    public Vector3 Corner { get; init; }

    /// <summary>The edge along which u grows.</summary>
    [Parameter("From the corner along the edge where u grows from 0 to 1.", Unit = "scene units", Required = true)]
    public Vector3 EdgeU { get; init; } = new(1, 0, 0);

    /// <summary>The edge along which v grows.</summary>
    [Parameter("From the corner along the edge where v grows from 0 to 1.", Unit = "scene units", Required = true)]
    public Vector3 EdgeV { get; init; } = new(0, 1, 0);

    /// <inheritdoc/>
    public override Vector3 Middle => Corner + (0.5f * (EdgeU + EdgeV));

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with
    {
        Corner = view.At(-view.Right - view.Up),
        EdgeU = view.Snap(view.Right * (2 * view.Size)),
        EdgeV = view.Snap(view.Up * (2 * view.Size)),
    };

    /// <inheritdoc/>
    public override ShapeDescription? Moved(in ShapeMove move) =>
        move.Mirrors ? null : this with { Corner = move.Point(Corner), EdgeU = move.Vector(EdgeU), EdgeV = move.Vector(EdgeV) };

    /// <inheritdoc/>
    public override Shape? Build(SceneBuilder builder)
    {
        Material material = builder.Material(Material);
        Vector3 normal = EdgeU.Cross(EdgeV);
        if (!(normal.Norm() > 0) || !normal.Unit().IsFinite())
        {
            builder.Error(this, null, "the rectangle has no area: its edges lie on one line");
            return null;
        }

        return new Rectangle(material, Name, Corner, EdgeU, EdgeV);
    }
}

/// <summary>A rectangle or parallelogram.</summary>
/// <param name="material">The material.</param>
/// <param name="name">A name for messages.</param>
/// <param name="corner">The corner where uv is (0, 0).</param>
/// <param name="edgeU">From there to where uv is (1, 0).</param>
/// <param name="edgeV">From there to where uv is (0, 1).</param>
internal sealed unsafe class Rectangle(Material material, string name, Vector3 corner, Vector3 edgeU, Vector3 edgeV) : FlatShape(material, name)
{
    /// <summary>The corner where uv is (0, 0).</summary>
    public Vector3 Corner => corner;

    /// <summary>From the corner to where uv is (1, 0).</summary>
    public Vector3 EdgeU => edgeU;

    /// <summary>From the corner to where uv is (0, 1).</summary>
    public Vector3 EdgeV => edgeV;

    /// <summary>Unit normal of the front.</summary>
    public Vector3 Normal { get; } = edgeU.Cross(edgeV).Unit();

    /// <inheritdoc/>
    public override float Area { get; } = edgeU.Cross(edgeV).Norm();

    /// <inheritdoc/>
    public override Bounds Bounds => new(
        corner + Vector3.Min(edgeU, Vector3.Zero) + Vector3.Min(edgeV, Vector3.Zero),
        corner + Vector3.Max(edgeU, Vector3.Zero) + Vector3.Max(edgeV, Vector3.Zero));

    /// <inheritdoc/>
    public override IEnumerable<Vector3[]> Wires(Vector3 middle, float reach) =>
        [[corner, corner + edgeU, corner + edgeU + edgeV, corner + edgeV, corner]];

    /// <inheritdoc/>
    internal override Outline Pack(float* entry)
    {
        FlatBatch.WritePlane(entry, Normal, corner);

        // The gradient of a coordinate is perpendicular to the other one's edge.
        Vector3 acrossV = edgeV.Cross(Normal);
        Vector3 acrossU = Normal.Cross(edgeU);
        Vector3 gradientU = acrossV * (1 / edgeU.Dot(acrossV));
        Vector3 gradientV = acrossU * (1 / edgeV.Dot(acrossU));
        AffineMap.Write(entry + FlatBatch.MapU, gradientU, corner, 0);
        AffineMap.Write(entry + FlatBatch.MapV, gradientV, corner, 0);

        // The outline is moved outwards on all four sides.
        float slack = OutlineSlack.Distance(Bounds);
        WriteOutline(entry + FlatBatch.First, gradientU, slack * gradientU.Norm());
        WriteOutline(entry + FlatBatch.Second, gradientV, slack * gradientV.Norm());
        return Outline.Rectangle;
    }

    /// <inheritdoc/>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        AreaSample.Sample(At(u, v, (Vec3W)corner - from), Normal, Area, out sample);
        sample.U = u;
        sample.V = v;
    }

    /// <inheritdoc/>
    internal override bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point)
    {
        point = At(u, v, corner);
        return true;
    }

    private Vec3W At(FloatW u, FloatW v, Vec3W origin) => Vec3W.MultiplyAdd(edgeU, u, Vec3W.MultiplyAdd(edgeV, v, origin));

    private void WriteOutline(float* map, Vector3 gradient, float slack)
    {
        float scale = 1 / (1 + (2 * slack));
        AffineMap.Write(map, gradient * scale, corner, slack * scale);
    }
}
