using System.Collections.Concurrent;
using System.Numerics;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Shapes;
using RayTracer.Textures;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Scenes;

/// <summary>
/// A kind of parameter: which parameters are of it, how scene files write their values, and what schema and reference page say of them.
/// Front ends have an editor for each kind whose name they know, and lead to the text for others.
/// </summary>
/// <param name="name">The name in camelCase.</param>
public abstract class ParameterForm(string name)
{
    private static readonly ConcurrentDictionary<RecordParameter, ParameterForm> Found = new();
    private static readonly VectorForm<Vector2> Pair = new("vector2", 2, v => new(v[0], v[1]), v => [v.X, v.Y]);
    private static readonly VectorForm<Vector3> Triple = new("vector3", 3, v => new(v[0], v[1], v[2]), v => [v.X, v.Y, v.Z]);

    /// <summary>All kinds. Of those that fit a parameter, the first counts.</summary>
    public static Registry<ParameterForm> Known { get; } = new(
        "kind of parameter",
        form => [form.Name],
        new NumberForm(),
        new IntegerForm(),
        new BooleanForm(),
        new FileForm(),
        new TextForm(),
        new ChoiceForm(),
        Pair,
        Triple,
        new ColorForm(),
        new ExposureForm(),
        new TextureForm(),
        new ThingForm(SceneTypes.Materials),
        new ThingForm(SceneTypes.Shapes),
        new ThingForm(SceneTypes.Environments),
        new ThingListForm(SceneTypes.Materials, hasReferences: true),
        new ThingListForm(SceneTypes.Shapes, hasReferences: false),
        new NamedThingsForm<TextureDescription>("namedTextures", SceneTypes.Textures),
        new NamedThingsForm<MaterialDescription>("namedMaterials", SceneTypes.Materials),
        new NamedThingsForm<ShapeDescription>("namedShapes", SceneTypes.Shapes),
        new RecordForm(),
        new RecordListForm(),
        new NumberListForm(),
        new ListForm<int>("integers", "whole numbers", new IntegerForm(), "whole numbers"),
        new ListForm<Vector2>("vector2s", "pairs of numbers", Pair),
        new ListForm<Vector3>("vector3s", "triples of numbers", Triple),
        new ListForm<TriangleIndices>("triangles", "triples of whole numbers", new TriangleForm()));

    /// <summary>The name in camelCase, by which front ends choose an editor.</summary>
    public string Name { get; } = name;

    /// <summary>Returns a parameter's kind.</summary>
    /// <exception cref="NotSupportedException">There is none for its type.</exception>
    public static ParameterForm Of(RecordParameter parameter) => Found.GetOrAdd(parameter, p => Known.All.FirstOrDefault(f => f.Fits(p))
        ?? throw new NotSupportedException($"Scene files have no form for {Quotation.Of(p.Key)}, a parameter of type {p.ValueType}."));

    /// <summary>Returns true for a parameter of this kind.</summary>
    public abstract bool Fits(RecordParameter parameter);

    /// <summary>Reads a value; null after an error, which was reported to the reader.</summary>
    public abstract object? Read(RecordReader reader, RecordParameter parameter, JsonNode node);

    /// <summary>Returns a value as a scene file has it.</summary>
    public abstract Json? Write(SceneWriter writer, object value);

    /// <summary>The JSON Schema of the values, without summary and default.</summary>
    public abstract JsonObject Schema(RecordParameter parameter);

    /// <summary>The form of the values in the words of the reference page, in Markdown.</summary>
    public abstract string Words(RecordParameter parameter);

    /// <summary>Returns true where a value consists of numbers alone, so that tracks can change it.</summary>
    /// <param name="written">The node in the file; null where there is none.</param>
    public virtual bool IsNumeric(JsonNode? written) => false;

    /// <summary>Returns the value that is written, whatever its range, for editors; null where it is not of the right form, or consists of things.</summary>
    public virtual object? Parse(RecordParameter parameter, JsonNode node) => null;

    /// <summary>The elements of a long list of numbers and their bytes, as they count in a scene's hash; null for values that count part by part.</summary>
    public virtual (int Count, byte[] Bytes)? Content(object value) => null;
}
