using RayTracer.Description;

namespace RayTracer.Shapes;

/// <summary>Describes one more appearance of an object, which takes no memory of its own but for its place.</summary>
[SceneType("instance", "One appearance of an object. All instances of an object share its memory and its materials.")]
public sealed record InstanceDescription : ShapeDescription
{
    /// <summary>The shape shown; null only while nothing has been said.</summary>
    [Parameter("The name of one of the scene's objects, or a shape.", Required = true)]
    public ShapeDescription? Of { get; init; }

    /// <inheritdoc/>
    public override SketchKinds SketchedAs => SketchKinds.Shape;

    /// <summary>Returns null: it is no single shape.</summary>
    public override Shape? Build(SceneBuilder builder) => null;
}
