using RayTracer.Shapes;

namespace RayTracer.Description;

/// <summary>Describes a shape.</summary>
public abstract record ShapeDescription
{
    /// <summary>The name that messages and editors use.</summary>
    [Parameter("A name for messages and editors; it need not be unique.")]
    public string Name { get; init; } = "";

    /// <summary>What the shape is made of.</summary>
    [Parameter("What the shape is made of: a material, or the name of one.")]
    public MaterialDescription Material { get; init; } = new Materials.DiffuseMaterialDescription();

    /// <summary>Makes the shape that this record describes, or reports why it cannot be made and returns null.</summary>
    /// <param name="builder">Gives access to materials and takes diagnostics.</param>
    public abstract Shape? Build(SceneBuilder builder);
}
