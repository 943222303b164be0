using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>Describes a <see cref="Torus"/>.</summary>
[SceneType("torus", "A torus: a ring bent from a tube. u goes once around the axis, as on a sphere (u = 0.5 faces +z if it lies flat), v "
    + "once around the tube, from the inner side (0) over the bottom, outer side (0.5) and top.")]
public sealed record TorusDescription : ShapeDescription
{
    /// <summary>The centre.</summary>
    [Parameter("The centre.", Unit = "scene units", Required = true)]
    public Vector3 Center { get; init; }

    /// <summary>The direction through the hole.</summary>
    [Parameter("The direction through the hole, of any length.")]
    public Vector3 Axis { get; init; } = new(0, 1, 0);

    /// <summary>The radius of the ring.</summary>
    [Parameter("The radius of the ring: from the centre to the middle of the tube.",
        Unit = "scene units", Minimum = 0, MinimumIsExclusive = true)]
    public float Radius { get; init; } = 1;

    /// <summary>The radius of the tube.</summary>
    [Parameter("The radius of the tube, less than that of the ring.", Unit = "scene units", Minimum = 0, MinimumIsExclusive = true)]
    public float TubeRadius { get; init; } = 0.25f;

    /// <inheritdoc/>
    public override Vector3 Middle => Center;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with { Center = view.At(default), Radius = view.Size, TubeRadius = 0.3f * view.Size };

    /// <inheritdoc/>
    public override ShapeDescription? Moved(in ShapeMove move) =>
        move.RoundScale is not { } s ? null
            : this with { Center = move.Point(Center), Axis = move.Direction(Axis), Radius = Radius * s, TubeRadius = TubeRadius * s };

    /// <inheritdoc/>
    public override Shape? Build(SceneBuilder builder)
    {
        Material material = builder.Material(Material);
        if (!builder.HasDirection(this, nameof(Axis), Axis))
        {
            return null;
        }

        if (!(TubeRadius < Radius))
        {
            builder.Error(this, nameof(TubeRadius), $"the tube must be thinner than the ring, or it meets itself: less than {Radius:R}, but it is {TubeRadius:R}");
            return null;
        }

        return new Torus(material, Name, Center, Axis, Radius, TubeRadius);
    }
}

/// <summary>A torus.</summary>
/// <param name="material">The material.</param>
/// <param name="name">A name for messages.</param>
/// <param name="center">The centre.</param>
/// <param name="axis">The direction through the hole.</param>
/// <param name="radius">From the centre to the middle of the tube.</param>
/// <param name="tubeRadius">The tube's own radius, above zero and less than <paramref name="radius"/>.</param>
internal sealed class Torus(Material material, string name, Vector3 center, Vector3 axis, float radius, float tubeRadius) : Shape(material, name)
{
    /// <summary>The centre.</summary>
    public Vector3 Center => center;

    /// <summary>The direction through the hole, of any length.</summary>
    public Vector3 Axis => axis;

    /// <summary>From the centre to the middle of the tube.</summary>
    public float Radius => radius;

    /// <summary>The tube's own radius.</summary>
    public float TubeRadius => tubeRadius;

    /// <inheritdoc/>
    public override float Area => 4 * float.Pi * float.Pi * radius * tubeRadius;

    /// <inheritdoc/>
    public override Bounds Bounds
    {
        get
        {
            Vector3 reach = Frame.DiskReach(radius) + new Vector3(tubeRadius);
            return new(center - reach, center + reach);
        }
    }

    /// <summary>The space of <see cref="TorusKernel"/>.</summary>
    internal LocalFrame Frame { get; } = LocalFrame.FromAxis(center, axis);

    /// <inheritdoc/>
    public override IEnumerable<Vector3[]> Wires(Vector3 middle, float reach)
    {
        Vector3 along = axis.Unit();
        (Vector3 u, Vector3 v) = WireLines.Across(along);
        Vector3[] around = [u, (u + v).Unit(), v, (v - u).Unit(), -u, (-u - v).Unit(), -v, (u - v).Unit()];
        return
        [
            WireLines.Circle(center, u, v, radius + tubeRadius), WireLines.Circle(center, u, v, radius - tubeRadius),
            WireLines.Circle(center + (along * tubeRadius), u, v, radius), WireLines.Circle(center - (along * tubeRadius), u, v, radius),
            .. around.Select(a => WireLines.Circle(center + (a * radius), a, along, tubeRadius)),
        ];
    }

    /// <inheritdoc/>
    public override ShapeBatch CreateBatch(IReadOnlyList<Shape> shapes) => new KernelBatch<TorusKernel>(shapes);

    /// <summary>Uniformly by area over the whole surface. Parts that it hides itself are found by the shadow ray.</summary>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        FloatW turn = TubeTurn(v);
        LocalFrame.AtTurn(u, out FloatW x, out FloatW y);
        LocalFrame.AtTurn(turn, out FloatW up, out FloatW outward);
        FloatW distance = FloatW.MultiplyAdd(outward, tubeRadius, radius);
        Vec3W point = new(x * distance, y * distance, up * tubeRadius);
        Vec3W normal = new(x * outward, y * outward, up);
        AreaSample.Sample((Vec3W)center - from + Frame.ToWorld(point), Frame.ToWorld(normal), Area, out sample);
        sample.U = u;
        sample.V = turn;
    }

    /// <inheritdoc/>
    internal override bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point) => SampleSeen(center, u, v, out point);

    /// <summary>
    /// The turn around the tube, from its inner side, below which a part <paramref name="v"/> of the area lies: circles around the axis are
    /// longer outside. Of the angle φ, the area is φ − e·sin φ with e the ratio of the radii: this is Kepler's equation (Kepler 1609).
    /// </summary>
    private FloatW TubeTurn(FloatW v)
    {
        float ratio = tubeRadius / radius;
        FloatW mirrored = FloatW.Min(v, 1f - v);
        FloatW mean = mirrored * (2 * float.Pi);

        // Newton's steps from above fall towards the root, since the function is convex up to π. These are upper bounds of it.
        FloatW angle = FloatW.Min(FloatW.Min(mean / (1 - ratio), mean + ratio), LaneMath.Pow(mean * (float.Pi * float.Pi), 1f / 3f));
        for (int step = 0; step < 6; step++)
        {
            LaneMath.SinCos(angle, out FloatW sin, out FloatW cos);
            FloatW excess = FloatW.NegatedMultiplyAdd(sin, ratio, angle) - mean;
            angle -= excess / FloatW.NegatedMultiplyAdd(cos, ratio, 1f);
        }

        FloatW turn = FloatW.Max(FloatW.Min(angle * (0.5f / float.Pi), 0.5f), 0f);
        return (v <= 0.5f).Select(turn, 1f - turn);
    }
}
