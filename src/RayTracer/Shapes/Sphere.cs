using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Shapes;

/// <summary>Describes a <see cref="Sphere"/>.</summary>
[SceneType("sphere", "A sphere. u goes once around the y axis (u = 0.5 faces +z) and grows to the right when seen from outside with y up, "
    + "v from the bottom (0) to the top (1) in proportion to the angle.")]
public sealed record SphereDescription : ShapeDescription
{
    /// <summary>The centre.</summary>
    [Parameter("The centre.", Unit = "scene units", Required = true)]
    public Vector3 Center { get; init; }

    /// <summary>The radius.</summary>
    [Parameter("The radius.", Unit = "scene units", Minimum = 0, MinimumIsExclusive = true)]
    public float Radius { get; init; } = 1;

    /// <inheritdoc/>
    public override Vector3 Middle => Center;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with { Center = view.At(default), Radius = view.Size };

    /// <inheritdoc/>
    public override ShapeDescription? Moved(in ShapeMove move) =>
        move.RoundScale is { } s ? this with { Center = move.Point(Center), Radius = Radius * s } : null;

    /// <inheritdoc/>
    public override Shape Build(SceneBuilder builder) =>
        new Sphere(builder.Material(Material), Name, Center, Radius) { LightSampling = builder.SphereLightSampling };
}

/// <summary>A sphere (report, section 3.3.5).</summary>
/// <param name="material">The material.</param>
/// <param name="name">A name for messages.</param>
/// <param name="center">The centre.</param>
/// <param name="radius">The radius, above zero.</param>
internal sealed class Sphere(Material material, string name, Vector3 center, float radius) : Shape(material, name)
{
    /// <summary>The centre.</summary>
    public Vector3 Center => center;

    /// <summary>The radius.</summary>
    public float Radius => radius;

    /// <summary>The way it is sampled where it shines.</summary>
    public SphereLightSampling LightSampling { get; init; }

    /// <inheritdoc/>
    public override Bounds Bounds => new(center - new Vector3(radius), center + new Vector3(radius));

    /// <inheritdoc/>
    public override float Area => 4 * float.Pi * radius * radius;

    /// <inheritdoc/>
    public override Shape? Transformed(Transform by)
    {
        // uv would be turned too.
        if (by.UniformScale() is not { } scale || (Material.Traits.UsesUv && !(by.X.A == scale && by.Y.B == scale && by.Z.C == scale)))
        {
            return null;
        }

        return new Sphere(Material, Name, by.Point(center), (float)(radius * scale)) { LightSampling = LightSampling };
    }

    /// <inheritdoc/>
    public override IEnumerable<Vector3[]> Wires(Vector3 middle, float reach) =>
    [
        WireLines.Circle(center, Vector3.UnitX, Vector3.UnitY, radius),
        WireLines.Circle(center, Vector3.UnitY, Vector3.UnitZ, radius),
        WireLines.Circle(center, Vector3.UnitZ, Vector3.UnitX, radius),
    ];

    /// <inheritdoc/>
    public override ShapeBatch CreateBatch(IReadOnlyList<Shape> shapes) => new SphereBatch(shapes);

    /// <inheritdoc/>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        SampleDirection(from, u, v, out sample);
        Vec3W normal = (Vec3W.MultiplyAdd(sample.Direction, sample.Distance, from) - center) * (1 / radius);
        SphereBatch.Uv(normal, out sample.U, out sample.V);
    }

    /// <inheritdoc/>
    public override void SamplePdf(in Vec3W from, in FloatW distance, in FloatW cosine, out FloatW pdf)
    {
        if (LightSampling == SphereLightSampling.Surface)
        {
            pdf = AreaSample.Pdf(distance, cosine, Area);
            return;
        }

        Vec3W toCenter = (Vec3W)center - from;
        FloatW sin2Rim = radius * radius / Vec3W.Dot(toCenter, toCenter);
        pdf = ((sin2Rim < 1f) & (cosine > 0f)).Select((1f / (2 * float.Pi)) / RimHeight(sin2Rim), 0f);
    }

    /// <inheritdoc/>
    internal override bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point)
    {
        point = Vec3W.MultiplyAdd(Warp.UniformSphere(u, v), radius, center);
        return true;
    }

    /// <summary>As <see cref="SamplePoint"/>, without uv.</summary>
    internal void SampleDirection(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        if (LightSampling == SphereLightSampling.Cone)
        {
            SampleCone(from, u, v, out sample);
        }
        else
        {
            SampleSurface(from, u, v, out sample);
        }
    }

    /// <summary>
    /// Uniformly in the cone of directions in which the sphere is seen (Shirley, Wang &amp; Zimmerman 1996, section 3.2).
    /// </summary>
    private void SampleCone(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        Vec3W toCenter = (Vec3W)center - from;
        FloatW distance2 = Vec3W.Dot(toCenter, toCenter);
        FloatW inverse2 = 1f / distance2;
        FloatW inverse = FloatW.Sqrt(inverse2);
        FloatW sin2Rim = inverse2 * (radius * radius);

        // u picks a height within that of the rim.
        FloatW height = RimHeight(sin2Rim);
        FloatW below = u * height;
        FloatW sin2 = FloatW.Max(below * (2f - below), 0f);
        FloatW cos = 1f - below;
        FloatW sin = FloatW.Sqrt(sin2);
        FloatW halfChord = FloatW.Sqrt(FloatW.Max(FloatW.NegatedMultiplyAdd(distance2, sin2, radius * radius), 0f));

        LaneMath.SinCosTurn(v, out FloatW sinPhi, out FloatW cosPhi);
        Onb.FromNormal(toCenter * inverse, out Onb frame);
        sample.Direction = frame.ToWorld(new(sin * cosPhi, sin * sinPhi, cos));
        sample.Distance = FloatW.MultiplyAdd(distance2 * inverse, cos, -halfChord);
        sample.Cosine = halfChord * (1 / radius);

        // From inside, an outward light is not seen.
        sample.InversePdf = (sin2Rim < 1f).Select(height * (2 * float.Pi), 0f);
        sample.U = sample.V = default;
    }

    // 1 − cos of the rim, without the cancellation for small and far lights.
    private static FloatW RimHeight(FloatW sin2Rim) => sin2Rim / (1f + FloatW.Sqrt(FloatW.Max(1f - sin2Rim, 0f)));

    /// <summary>Uniformly over the whole surface, as in the report; half of the points are hidden.</summary>
    private void SampleSurface(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        Vec3W normal = Warp.UniformSphere(u, v);
        Vec3W to = Vec3W.MultiplyAdd(normal, radius, (Vec3W)center - from);
        AreaSample.Sample(to, normal, Area, out sample);
    }
}
