using RayTracer.Acceleration;
using RayTracer.Materials;

namespace RayTracer.Shapes;

/// <summary>A part of a plane: what <see cref="FlatBatch"/> meets with rays.</summary>
/// <param name="material">The material.</param>
/// <param name="name">A name for messages.</param>
internal abstract unsafe class FlatShape(Material material, string name) : Shape(material, name)
{
    /// <inheritdoc/>
    public override ShapeBatch CreateBatch(IReadOnlyList<Shape> shapes) => new FlatBatch(shapes);

    /// <summary>Writes the shape's entry (see <see cref="FlatBatch"/>) and says which part of the plane it is.</summary>
    internal abstract Outline Pack(float* entry);
}

/// <summary>The outline of a flat shape in its plane, by the two maps of its entry.</summary>
internal enum Outline
{
    /// <summary>All of it.</summary>
    None,

    /// <summary>The points where both maps lie between 0 and 1.</summary>
    Rectangle,

    /// <summary>The points where both maps are at least 0, and their sum at most 1.</summary>
    Triangle,

    /// <summary>The points where the squares of both maps add up to at most 1.</summary>
    Disk,
}
