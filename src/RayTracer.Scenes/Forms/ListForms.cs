using System.Runtime.InteropServices;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Shapes;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Scenes;

/// <summary>A list of numbers, or of vectors of numbers, that may be long.</summary>
/// <param name="name">The name of the kind.</param>
/// <param name="noun">The elements in messages.</param>
/// <param name="element">The kind of each element.</param>
/// <param name="words">The elements on the reference page; null for the words of one.</param>
internal class ListForm<T>(string name, string noun, ParameterForm element, string? words = null) : ParameterForm(name)
    where T : unmanaged
{
    public override bool Fits(RecordParameter parameter) => parameter.ValueType == typeof(IReadOnlyList<T>);

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) =>
        reader.List(typeof(T), parameter.Key, node, noun, item => element.Read(reader, parameter, item));

    public override Json? Write(SceneWriter writer, object value) => new JsonArray([.. ((IEnumerable<T>)value).Select(v => element.Write(writer, v))]);

    public override JsonObject Schema(RecordParameter parameter) => SceneSchema.List(element.Schema(parameter));

    public override string Words(RecordParameter parameter) => $"list of {words ?? element.Words(parameter)}";

    public override (int Count, byte[] Bytes)? Content(object value)
    {
        T[] values = [.. (IEnumerable<T>)value];
        return (values.Length, MemoryMarshal.AsBytes(values.AsSpan()).ToArray());
    }
}

/// <summary>A list of numbers; where the parameter says so, one number or a colour too.</summary>
internal sealed class NumberListForm() : ListForm<float>("numbers", "numbers", new NumberForm(), "numbers")
{
    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) => (parameter.IsNumber, node.Kind) switch
    {
        (true, JsonKind.Number) => reader.Numbers.Number(parameter, node) is float number ? (float[])[number] : null,
        (true, JsonKind.String) => reader.Numbers.Color(parameter.Key, node) is { } color ? (float[])[color.R, color.G, color.B] : null,
        _ => base.Read(reader, parameter, node),
    };

    public override JsonObject Schema(RecordParameter parameter) => !parameter.IsNumber ? base.Schema(parameter)
        : SceneSchema.AnyOf(SceneSchema.Number("number", parameter), base.Schema(parameter), SceneSchema.Reference("color"));

    public override string Words(RecordParameter parameter) => parameter.IsNumber ? "number, list of numbers, or colour" : base.Words(parameter);

    public override bool IsNumeric(JsonNode? written) => true;
}

/// <summary>Three whole numbers, the corners of a triangle.</summary>
internal sealed class TriangleForm() : ParameterForm("triangle")
{
    public override bool Fits(RecordParameter parameter) => parameter.ValueType == typeof(TriangleIndices);

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) => reader.Numbers.Triangle(parameter.Key, node);

    public override Json? Write(SceneWriter writer, object value) => (TriangleIndices)value is var t ? new JsonArray(t.A, t.B, t.C) : null;

    public override JsonObject Schema(RecordParameter parameter) =>
        new() { ["type"] = "array", ["items"] = new JsonObject { ["type"] = "integer" }, ["minItems"] = 3, ["maxItems"] = 3 };

    public override string Words(RecordParameter parameter) => "three whole numbers";
}
