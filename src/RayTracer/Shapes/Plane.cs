using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>Describes a <see cref="Plane"/>.</summary>
[SceneType("plane", "An infinite plane or, with a size, a rectangle. uv is in scene units from the point; with a size it goes from 0 to 1 "
    + "across the rectangle. Seen from the front with y up, u grows to the right and v upwards; for a level plane (its normal along y), −z "
    + "takes the place of y.")]
public sealed record PlaneDescription : ShapeDescription
{
    /// <summary>A point of the plane; the centre of the rectangle.</summary>
    [Parameter("A point of the plane, where uv is (0, 0); with a size, the centre of the rectangle.",
        Unit = "scene units", Required = true)]
    public Vector3 Point { get; init; }

    /// <summary>The direction perpendicular to the plane.</summary>
    [Parameter("The direction perpendicular to the plane, of any length. A plane that shines does so on this side.", Required = true)]
    public Vector3 Normal { get; init; } = new(0, 1, 0);

    /// <summary>Width and height of the rectangle.</summary>
    [Parameter("Width and height (along u and v) of a rectangle; without it the plane is infinite.",
        Unit = "scene units", Minimum = 0, MinimumIsExclusive = true)]
    public Vector2? Size { get; init; }

    /// <inheritdoc/>
    public override Vector3 Middle => Point;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with { Point = view.At(default), Normal = Vector3.UnitY, Size = view.Shines ? Vector2.One : null };

    /// <inheritdoc/>
    public override ShapeDescription? Moved(in ShapeMove move) =>
        Plane.Mapped(Normal.Unit(), Size, move.Map, move.ShowsUv) is not { } mapped ? null
            : this with { Point = move.Point(Point), Normal = move.Normal(Normal), Size = mapped.Size };

    /// <inheritdoc/>
    public override Shape? Build(SceneBuilder builder)
    {
        Material material = builder.Material(Material);
        if (!builder.HasDirection(this, nameof(Normal), Normal))
        {
            return null;
        }

        if (Size is null && material.Traits.Emits)
        {
            builder.Error(this, nameof(Material), "an infinite plane cannot shine: give it a \"size\"");
        }

        return new Plane(material, Name, Point, Normal.Unit(), Size);
    }
}

/// <summary>A plane (report, section 3.3.5), or a rectangle of it.</summary>
internal sealed unsafe class Plane : FlatShape
{
    /// <summary>From a point and a normal.</summary>
    /// <param name="material">The material.</param>
    /// <param name="name">A name for messages.</param>
    /// <param name="point">A point of the plane, the centre of the rectangle.</param>
    /// <param name="normal">Unit normal.</param>
    /// <param name="size">Width and height of the rectangle; null for a plane without end.</param>
    public Plane(Material material, string name, Vector3 point, Vector3 normal, Vector2? size)
        : base(material, name)
    {
        Point = point;
        Normal = normal;
        Size = size;

        (Tangent, Bitangent) = Sides(normal);
    }

    /// <summary>A point of the plane, the centre of the rectangle.</summary>
    public Vector3 Point { get; }

    /// <summary>Unit normal.</summary>
    public Vector3 Normal { get; }

    /// <summary>Width and height of the rectangle; null for a plane without end.</summary>
    public Vector2? Size { get; }

    /// <summary>Unit direction of growing u.</summary>
    public Vector3 Tangent { get; }

    /// <summary>Unit direction of growing v.</summary>
    public Vector3 Bitangent { get; }

    /// <inheritdoc/>
    public override float Area => Size is { } s ? s.X * s.Y : float.PositiveInfinity;

    /// <inheritdoc/>
    public override Bounds Bounds
    {
        get
        {
            if (Size is not { } size)
            {
                return Bounds.Infinite;
            }

            Vector3 reach = Vector3.Abs(Tangent) * (0.5f * size.X) + Vector3.Abs(Bitangent) * (0.5f * size.Y);
            return new(Point - reach, Point + reach);
        }
    }

    /// <inheritdoc/>
    public override Shape? Transformed(Transform by)
    {
        Vector3 point = by.Point(Point);
        return point.IsFinite() && Mapped(Normal, Size, by, Material.Traits.UsesUv) is { } mapped
            ? new Plane(Material, Name, point, mapped.Normal, mapped.Size) : null;
    }

    /// <summary>
    /// What a map makes of a unit normal and a size. A plane without end is one again; a rectangle, or uv that is seen, only where its sides
    /// become what the plane's rule makes them: otherwise null.
    /// </summary>
    internal static (Vector3 Normal, Vector2? Size)? Mapped(Vector3 normal, Vector2? size, Transform by, bool showsUv)
    {
        Vector3 moved = by.Inverse().TransposedVector(normal).Unit();
        if (!moved.IsFinite() || (size is null && !showsUv))
        {
            return moved.IsFinite() ? (moved, null) : null;
        }

        (Vector3 tangent, Vector3 bitangent) = Sides(normal);
        (Vector3 newTangent, Vector3 newBitangent) = Sides(moved);
        Vector3 width = by.Vector(tangent * (size?.X ?? 1));
        Vector3 height = by.Vector(bitangent * (size?.Y ?? 1));
        bool isSame = (newTangent - width.Unit()).Norm() < 1e-6f && (newBitangent - height.Unit()).Norm() < 1e-6f;
        bool keepsUv = size is not null || (by.UniformScale() is { } scale && double.Abs(scale - 1) < 1e-6);
        return isSame && keepsUv ? (moved, size is null ? null : new Vector2(width.Norm(), height.Norm())) : null;
    }

    // u runs to the right as seen from the front with y up; on a floor, with −z up.
    private static (Vector3 Tangent, Vector3 Bitangent) Sides(Vector3 normal)
    {
        bool isLevel = normal.X * normal.X + normal.Z * normal.Z < 1e-6f;
        Vector3 tangent = (isLevel ? new Vector3(0, 0, -1) : new Vector3(0, 1, 0)).Cross(normal).Unit();
        return (tangent, normal.Cross(tangent));
    }

    /// <inheritdoc/>
    public override IEnumerable<Vector3[]> Wires(Vector3 middle, float reach) =>
    [
        Size is { } size ? WireLines.Square(Point, Tangent * (size.X / 2), Bitangent * (size.Y / 2))
            : WireLines.Square(middle - (Normal * (middle - Point).Dot(Normal)), Tangent * reach, Bitangent * reach),
    ];

    /// <inheritdoc/>
    internal override Outline Pack(float* entry)
    {
        FlatBatch.WritePlane(entry, Normal, Point);
        Vector2 size = Size ?? Vector2.One;
        float center = Size is null ? 0 : 0.5f;
        AffineMap.Write(entry + FlatBatch.MapU, Tangent * (1 / size.X), Point, center);
        AffineMap.Write(entry + FlatBatch.MapV, Bitangent * (1 / size.Y), Point, center);

        // The outline is moved outwards on all four sides.
        Vector2 outline = size + new Vector2(2 * OutlineSlack.Distance(Bounds));
        AffineMap.Write(entry + FlatBatch.First, Tangent * (1 / outline.X), Point, center);
        AffineMap.Write(entry + FlatBatch.Second, Bitangent * (1 / outline.Y), Point, center);

        return Size is null ? Outline.None : Outline.Rectangle;
    }

    /// <inheritdoc/>
    public override void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample)
    {
        AreaSample.Sample(At(u, v, (Vec3W)Point - from), Normal, Area, out sample);
        sample.U = u;
        sample.V = v;
    }

    /// <inheritdoc/>
    internal override bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point)
    {
        point = At(u, v, Point);
        return true;
    }

    private Vec3W At(FloatW u, FloatW v, Vec3W middle)
    {
        Vector2 size = Size!.Value;
        return Vec3W.MultiplyAdd(Tangent * size.X, u - 0.5f, Vec3W.MultiplyAdd(Bitangent * size.Y, v - 0.5f, middle));
    }
}
