using RayTracer.Description;

namespace RayTracer.Shapes;

/// <summary>Describes several shapes that are placed together.</summary>
[SceneType("group", "Shapes that move together. Shapes without a material are made of the group's.")]
public sealed record GroupDescription : ShapeDescription
{
    /// <summary>The shapes.</summary>
    [Parameter("The shapes, in the group's own space.", Required = true)]
    public IReadOnlyList<ShapeDescription> Shapes { get; init; } = [];

    /// <inheritdoc/>
    public override SketchKinds SketchedAs => SketchKinds.None;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with { Shapes = [new SphereDescription().Sketch(view)] };

    /// <summary>Returns null: it is no single shape.</summary>
    public override Shape? Build(SceneBuilder builder) => null;
}
