namespace RayTracer.Description;

/// <summary>
/// Documents one parameter of a description record. The scene reader, the JSON Schema, the reference page and every
/// editor are made from it. The parameter's default is the value that a new record has.
/// </summary>
/// <param name="summary">The meaning of the parameter, in one or two sentences.</param>
[AttributeUsage(AttributeTargets.Property)]
public sealed class ParameterAttribute(string summary) : Attribute
{
    /// <summary>The meaning of the parameter.</summary>
    public string Summary { get; } = summary;

    /// <summary>The unit of the number, as a reader would write it ("degrees", "scene units"); empty where there is none.</summary>
    public string Unit { get; init; } = "";

    /// <summary>The smallest allowed value of each number.</summary>
    public double Minimum { get; init; } = double.NegativeInfinity;

    /// <summary>The largest allowed value of each number.</summary>
    public double Maximum { get; init; } = double.PositiveInfinity;

    /// <summary>True where <see cref="Minimum"/> itself is refused.</summary>
    public bool MinimumIsExclusive { get; init; }

    /// <summary>True where a scene file must give the parameter.</summary>
    public bool Required { get; init; }

    /// <summary>True where the text is the path of a file, relative to the scene file's folder.</summary>
    public bool IsFile { get; init; }

    /// <summary>
    /// True where a texture stands for a number, so that a number may be written (the red channel counts), where a list of numbers may
    /// be a single one or a colour, or where one number may stand for all of a vector.
    /// </summary>
    public bool IsNumber { get; init; }
}

/// <summary>
/// Names a record as it is written after <c>"type":</c> in a scene file. The record's abstract base
/// (<see cref="ShapeDescription"/>, <see cref="MaterialDescription"/>, <see cref="TextureDescription"/>) says where it may stand.
/// </summary>
/// <param name="name">The name in scene files, in camelCase.</param>
/// <param name="summary">A description of the thing, in one or two sentences.</param>
[AttributeUsage(AttributeTargets.Class)]
public sealed class SceneTypeAttribute(string name, string summary) : Attribute
{
    /// <summary>The name in scene files.</summary>
    public string Name { get; } = name;

    /// <summary>A summary of the type.</summary>
    public string Summary { get; } = summary;
}
