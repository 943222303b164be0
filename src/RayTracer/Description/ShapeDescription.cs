using System.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Description;

/// <summary>Describes a shape.</summary>
public abstract record ShapeDescription
{
    /// <summary>The name that messages and editors use.</summary>
    [Parameter("A name for messages and editors; it need not be unique.")]
    public string Name { get; init; } = "";

    /// <summary>The layer of light that has what shines here.</summary>
    [Parameter("The layer for the light of what shines here when lights are written as layers (--aov lights). Without it: that of the enclosing group, or else the name.")]
    public string LightGroup { get; init; } = "";

    /// <summary>The material of the shape; the same object as <see cref="DefaultMaterial"/> where none is given.</summary>
    [Parameter("The shape's material, or the name of one. Without it, that of the enclosing group.")]
    public MaterialDescription Material { get; init; } = DefaultMaterial;

    /// <summary>The transform of the shape from where its own numbers put it; empty for none.</summary>
    [Parameter("How the shape is moved from where its numbers put it: steps, the first one applied first.")]
    public IReadOnlyList<TransformDescription> Transform { get; init; } = [];

    /// <summary>The motion of the shape in time, after its transform; empty where it rests.</summary>
    [Parameter("How the shape moves in time, from where it is otherwise: keyframes in the order of their times. It is blurred by its movement while the shutter is open.")]
    public IReadOnlyList<KeyframeDescription> Motion { get; init; } = [];

    /// <summary>As what editors offer to add the shape: unless it says otherwise, as a shape, and with a luminaire as a light.</summary>
    public virtual SketchKinds SketchedAs => SketchKinds.Shape | SketchKinds.Light;

    /// <summary>About where the middle is, in the shape's own space: the origin for what consists of others.</summary>
    public virtual Vector3 Middle => default;

    /// <summary>The material of shapes that give none: grey, matt.</summary>
    public static MaterialDescription DefaultMaterial { get; } = new Materials.DiffuseMaterialDescription();

    /// <summary>The shape as an editor adds it to a scene: seen at once.</summary>
    /// <param name="view">The place and the size.</param>
    public virtual ShapeDescription Sketch(SketchView view) => this with { Transform = [new() { Translate = view.At(default) }] };

    /// <summary>The same look at another place by other numbers; null where only a transform can move it there.</summary>
    /// <param name="move">The movement.</param>
    public virtual ShapeDescription? Moved(in ShapeMove move) => null;

    /// <summary>
    /// Makes the shape that this record describes, where its own numbers put it, or reports why it cannot be made and returns null.
    /// </summary>
    /// <param name="builder">Gives access to materials and takes diagnostics.</param>
    public abstract Shape? Build(SceneBuilder builder);
}
