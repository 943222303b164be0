using RayTracer.Description;

namespace RayTracer.Shapes;

/// <summary>Describes a further copy of an object, which takes no memory except for its place.</summary>
[SceneType("instance", "A copy of an object. All instances of an object share its memory, and its materials unless they have one: an instance with a "
    + "material shows the whole object in that. Instances of the same material share memory too.")]
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
