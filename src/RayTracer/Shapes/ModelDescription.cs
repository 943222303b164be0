using RayTracer.Description;

namespace RayTracer.Shapes;

/// <summary>Describes all shapes and lights of a model file, made of the file's own materials.</summary>
[SceneType("model", "Everything in a model file, with its own materials and lights. A material given here replaces all of them.")]
public sealed record ModelDescription : ShapeDescription
{
    /// <summary>The model's file.</summary>
    [Parameter("The model's file.", IsFile = true, Required = true)]
    public string File { get; init; } = "";

    /// <inheritdoc/>
    public override SketchKinds SketchedAs => SketchKinds.Shape;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with { File = view.File ?? "" };

    /// <summary>Returns null: it is no single shape.</summary>
    public override Shape? Build(SceneBuilder builder) => null;
}
