using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Shapes;

/// <summary>Describes a <see cref="Triangle"/>.</summary>
[SceneType("triangle", "A triangle. Its front, which shines if it is a luminaire, is where the corners are seen counter-clockwise.")]
public sealed record TriangleDescription : ShapeDescription
{
    /// <summary>First corner.</summary>
    [Parameter("First corner.", Unit = "scene units", Required = true)]
    public Vector3 A { get; init; }

    /// <summary>Second corner.</summary>
    [Parameter("Second corner.", Unit = "scene units", Required = true)]
    public Vector3 B { get; init; }

    /// <summary>Third corner.</summary>
    [Parameter("Third corner.", Unit = "scene units", Required = true)]
    public Vector3 C { get; init; }

    /// <summary>uv of the first corner.</summary>
    [Parameter("uv of the first corner.")]
    public Vector2 UvA { get; init; }

    /// <summary>uv of the second corner.</summary>
    [Parameter("uv of the second corner.")]
    public Vector2 UvB { get; init; } = new(1, 0);

    /// <summary>uv of the third corner.</summary>
    [Parameter("uv of the third corner.")]
    public Vector2 UvC { get; init; } = new(0, 1);

    /// <inheritdoc/>
    public override Vector3 Middle => (A + B + C) / 3;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with
    {
        A = view.At(-view.Right - view.Up),
        B = view.At(view.Right - view.Up),
        C = view.At(view.Up),
    };

    /// <inheritdoc/>
    public override ShapeDescription? Moved(in ShapeMove move) =>
        move.Mirrors ? null : this with { A = move.Point(A), B = move.Point(B), C = move.Point(C) };

    /// <inheritdoc/>
    public override Shape? Build(SceneBuilder builder)
    {
        Material material = builder.Material(Material);
        Vector3 normal = (B - A).Cross(C - A);
        if (!(normal.Norm() > 0) || !normal.Unit().IsFinite())
        {
            builder.Error(this, null, "the triangle has no area: its corners lie on one line");
            return null;
        }

        return new Triangle(material, Name, A, B, C, UvA, UvB, UvC);
    }
}

/// <summary>A triangle (report, sections 3.3.3 and 3.3.5); uv is interpolated between its corners.</summary>
internal sealed unsafe class Triangle(Material material, string name, Vector3 a, Vector3 b, Vector3 c, Vector2 uvA, Vector2 uvB, Vector2 uvC)
    : FlatShape(material, name)
{
    /// <summary>First corner.</summary>
    public Vector3 A => a;

    /// <summary>Second corner.</summary>
    public Vector3 B => b;

    /// <summary>Third corner.</summary>
    public Vector3 C => c;

    /// <summary>uv of the corners.</summary>
    public (Vector2 A, Vector2 B, Vector2 C) Uv => (uvA, uvB, uvC);

    /// <summary>Unit normal of the front.</summary>
    public Vector3 Normal { get; } = (b - a).Cross(c - a).Unit();

    /// <inheritdoc/>
    public override float Area { get; } = 0.5f * (b - a).Cross(c - a).Norm();

    /// <inheritdoc/>
    public override Bounds Bounds => new(Vector3.Min(a, Vector3.Min(b, c)), Vector3.Max(a, Vector3.Max(b, c)));

    /// <inheritdoc/>
    public override Shape? Transformed(Transform by)
    {
        // A map that mirrors changes the direction in which the corners go round: the front stays where it was mirrored to.
        (Vector3 p, Vector3 q, Vector3 r) = (by.Point(a), by.Point(b), by.Point(c));
        Triangle moved = by.Determinant < 0 ? new(Material, Name, p, r, q, uvA, uvC, uvB) : new(Material, Name, p, q, r, uvA, uvB, uvC);
        return moved.Normal.IsFinite() && float.IsFinite(moved.Area) ? moved : null;
    }

    /// <inheritdoc/>
    public override IEnumerable<Vector3[]> Wires(Vector3 middle, float reach) =>
        [[a, b, c, a]];

    /// <inheritdoc/>
    internal override Outline Pack(float* entry)
    {
        FlatBatch.WritePlane(entry, Normal, a);

        // The gradient of a corner's coordinate is perpendicular to the opposite side, and 1 over its height long.
        Vector3 towardsB = (c - a).Cross(Normal);
        Vector3 towardsC = Normal.Cross(b - a);
        Vector3 gradientB = towardsB * (1 / (b - a).Dot(towardsB));
        Vector3 gradientC = towardsC * (1 / (c - a).Dot(towardsC));

        // The outline, moved outwards on all three sides: scaled so that the sides are still where the maps are 0 or add up to 1.
        float slack = OutlineSlack.Distance(Bounds);
        float slackB = slack * gradientB.Norm();
        float slackC = slack * gradientC.Norm();
        float scale = 1 / (1 + slack * (gradientB + gradientC).Norm() + slackB + slackC);
        AffineMap.Write(entry + FlatBatch.First, gradientB * scale, a, slackB * scale);
        AffineMap.Write(entry + FlatBatch.Second, gradientC * scale, a, slackC * scale);
        AffineMap.Write(entry + FlatBatch.MapU, gradientB * (uvB.X - uvA.X) + gradientC * (uvC.X - uvA.X), a, uvA.X);
        AffineMap.Write(entry + FlatBatch.MapV, gradientB * (uvB.Y - uvA.Y) + gradientC * (uvC.Y - uvA.Y), a, uvA.Y);
        return Outline.Triangle;
    }

    /// <inheritdoc/>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        Warp.UniformTriangle(u, v, out FloatW toB, out FloatW toC);
        AreaSample.Sample(At(toB, toC, (Vec3W)a - from), Normal, Area, out sample);
        sample.U = FloatW.MultiplyAdd(toB, uvB.X - uvA.X, FloatW.MultiplyAdd(toC, uvC.X - uvA.X, uvA.X));
        sample.V = FloatW.MultiplyAdd(toB, uvB.Y - uvA.Y, FloatW.MultiplyAdd(toC, uvC.Y - uvA.Y, uvA.Y));
    }

    /// <inheritdoc/>
    internal override bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point)
    {
        Warp.UniformTriangle(u, v, out FloatW toB, out FloatW toC);
        point = At(toB, toC, a);
        return true;
    }

    private Vec3W At(FloatW toB, FloatW toC, Vec3W corner) => Vec3W.MultiplyAdd(b - a, toB, Vec3W.MultiplyAdd(c - a, toC, corner));
}
