using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;

namespace RayTracer.Shapes;

/// <summary>Describes a <see cref="Cylinder"/>.</summary>
[SceneType("cylinder", "A cylinder between two points of its axis. u goes once around the axis, as on a sphere (u = 0.5 faces +z if it is "
    + "upright), v from the bottom (0) to the top (1). On the caps, uv goes from 0 to 1 across the square around them, as on disks.")]
public sealed record CylinderDescription : ShapeDescription
{
    /// <summary>The middle of the bottom.</summary>
    [Parameter("The middle of the bottom.", Unit = "scene units", Required = true)]
    public Vector3 Bottom { get; init; }

    /// <summary>The middle of the top.</summary>
    [Parameter("The middle of the top.", Unit = "scene units", Required = true)]
    public Vector3 Top { get; init; } = new(0, 1, 0);

    /// <summary>The radius.</summary>
    [Parameter("The radius.", Unit = "scene units", Minimum = 0, MinimumIsExclusive = true)]
    public float Radius { get; init; } = 1;

    /// <summary>True where the ends are closed.</summary>
    [Parameter("Whether the ends are closed by disks. Without them it is a pipe, whose inside is visible but does not shine.")]
    public bool Caps { get; init; } = true;

    /// <inheritdoc/>
    public override Vector3 Middle => 0.5f * (Bottom + Top);

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with { Bottom = view.At(-Vector3.UnitY), Top = view.At(Vector3.UnitY), Radius = 0.6f * view.Size };

    /// <inheritdoc/>
    public override ShapeDescription? Moved(in ShapeMove move) =>
        move.RoundScale is { } s ? this with { Bottom = move.Point(Bottom), Top = move.Point(Top), Radius = Radius * s } : null;

    /// <inheritdoc/>
    public override Shape? Build(SceneBuilder builder)
    {
        Material material = builder.Material(Material);
        return ConicalShape.HasAxis(builder, this, Bottom, Top) ? new Cylinder(material, Name, Bottom, Top, Radius, Caps) : null;
    }
}

/// <summary>A cylinder.</summary>
/// <param name="material">The material.</param>
/// <param name="name">A name for messages.</param>
/// <param name="bottom">The middle of the bottom.</param>
/// <param name="top">The middle of the top.</param>
/// <param name="radius">The radius, above zero.</param>
/// <param name="caps">True if the ends are closed.</param>
internal sealed class Cylinder(Material material, string name, Vector3 bottom, Vector3 top, float radius, bool caps)
    : ConicalShape(material, name, bottom, top, radius, radius, caps)
{
    /// <inheritdoc/>
    public override ShapeBatch CreateBatch(IReadOnlyList<Shape> shapes) => new KernelBatch<ConicalKernel>(shapes);
}
