using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Shapes;

/// <summary>Describes a <see cref="Disk"/>.</summary>
[SceneType("disk", "A disk. uv goes from 0 to 1 across the square around it, as on a plane with a size: seen from the front with y up, u "
    + "grows to the right and v upwards; for a level disk (its normal along y), −z takes the place of y.")]
public sealed record DiskDescription : ShapeDescription
{
    /// <summary>The centre.</summary>
    [Parameter("The centre.", Unit = "scene units", Required = true)]
    public Vector3 Center { get; init; }

    /// <summary>The direction perpendicular to the disk.</summary>
    [Parameter("The direction perpendicular to the disk, of any length. A disk that shines does so on this side.", Required = true)]
    public Vector3 Normal { get; init; } = new(0, 1, 0);

    /// <summary>The radius.</summary>
    [Parameter("The radius.", Unit = "scene units", Minimum = 0, MinimumIsExclusive = true)]
    public float Radius { get; init; } = 1;

    /// <inheritdoc/>
    public override Vector3 Middle => Center;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with { Center = view.At(default), Normal = view.Facing, Radius = view.Size };

    /// <inheritdoc/>
    public override ShapeDescription? Moved(in ShapeMove move) =>
        move.RoundScale is { } s ? this with { Center = move.Point(Center), Normal = move.Normal(Normal), Radius = Radius * s } : null;

    /// <inheritdoc/>
    public override Shape? Build(SceneBuilder builder)
    {
        Material material = builder.Material(Material);
        if (!builder.HasDirection(this, nameof(Normal), Normal))
        {
            return null;
        }

        return new Disk(material, Name, Center, Normal.Unit(), Radius);
    }
}

/// <summary>A disk.</summary>
/// <param name="material">The material.</param>
/// <param name="name">A name for messages.</param>
/// <param name="center">The centre.</param>
/// <param name="normal">Unit normal of the front.</param>
/// <param name="radius">The radius, above zero.</param>
internal sealed unsafe class Disk(Material material, string name, Vector3 center, Vector3 normal, float radius) : FlatShape(material, name)
{
    // The square around it has the axes and the uv.
    private readonly Plane _square = new(material, name, center, normal, new Vector2(2 * radius));

    /// <summary>The centre.</summary>
    public Vector3 Center => center;

    /// <summary>Unit normal of the front.</summary>
    public Vector3 Normal => normal;

    /// <summary>The radius.</summary>
    public float Radius => radius;

    /// <summary>Unit direction of growing u.</summary>
    public Vector3 Tangent => _square.Tangent;

    /// <summary>Unit direction of growing v.</summary>
    public Vector3 Bitangent => _square.Bitangent;

    /// <inheritdoc/>
    public override float Area => float.Pi * radius * radius;

    /// <inheritdoc/>
    public override Bounds Bounds
    {
        get
        {
            Vector3 squared = (Tangent * Tangent) + (Bitangent * Bitangent);
            Vector3 reach = new Vector3(float.Sqrt(squared.X), float.Sqrt(squared.Y), float.Sqrt(squared.Z)) * radius;
            return new(center - reach, center + reach);
        }
    }

    /// <inheritdoc/>
    public override IEnumerable<Vector3[]> Wires(Vector3 middle, float reach) =>
        [WireLines.Circle(center, Tangent, Bitangent, radius)];

    /// <inheritdoc/>
    internal override Outline Pack(float* entry)
    {
        _square.Pack(entry);
        float outline = 1 / (radius + OutlineSlack.Distance(Bounds));
        AffineMap.Write(entry + FlatBatch.First, Tangent * outline, center, 0);
        AffineMap.Write(entry + FlatBatch.Second, Bitangent * outline, center, 0);
        return Outline.Disk;
    }

    /// <inheritdoc/>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        Warp.ConcentricDisk(u, v, out FloatW x, out FloatW y);
        AreaSample.Sample(At(x, y, (Vec3W)center - from), normal, Area, out sample);
        sample.U = FloatW.MultiplyAdd(x, 0.5f, 0.5f);
        sample.V = FloatW.MultiplyAdd(y, 0.5f, 0.5f);
    }

    /// <inheritdoc/>
    internal override bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point)
    {
        Warp.ConcentricDisk(u, v, out FloatW x, out FloatW y);
        point = At(x, y, center);
        return true;
    }

    private Vec3W At(FloatW x, FloatW y, Vec3W middle) => Vec3W.MultiplyAdd(Tangent * radius, x, Vec3W.MultiplyAdd(Bitangent * radius, y, middle));
}
