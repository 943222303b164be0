namespace RayTracer.Description;

/// <summary>
/// Names a record as it is written after <c>"type":</c> in a scene file. The record's abstract base
/// (<see cref="ShapeDescription"/>, <see cref="MaterialDescription"/>, <see cref="TextureDescription"/>) says where it may stand.
/// </summary>
/// <param name="name">The name in scene files, in camelCase.</param>
/// <param name="summary">What the thing is, in one or two sentences.</param>
[AttributeUsage(AttributeTargets.Class)]
public sealed class SceneTypeAttribute(string name, string summary) : Attribute
{
    /// <summary>The name in scene files.</summary>
    public string Name { get; } = name;

    /// <summary>A summary of the type.</summary>
    public string Summary { get; } = summary;
}
