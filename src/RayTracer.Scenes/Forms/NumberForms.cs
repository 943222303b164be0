using System.Globalization;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Numerics;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Scenes;

/// <summary>A number.</summary>
internal sealed class NumberForm() : ParameterForm("number")
{
    public override bool Fits(RecordParameter parameter) => parameter.ValueType == typeof(float);

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) => reader.Numbers.Number(parameter, node);

    public override Json? Write(SceneWriter writer, object value) => SceneWriter.Number((float)value);

    public override JsonObject Schema(RecordParameter parameter) => SceneSchema.Number("number", parameter);

    public override string Words(RecordParameter parameter) => "number";

    public override bool IsNumeric(JsonNode? written) => true;

    public override object? Parse(RecordParameter parameter, JsonNode node) => node.Number;
}

/// <summary>A whole number, or an element of a list of them.</summary>
internal sealed class IntegerForm() : ParameterForm("integer")
{
    public override bool Fits(RecordParameter parameter) => parameter.IsInteger;

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) =>
        parameter.IsInteger ? reader.Numbers.Integer(parameter, node) : reader.Numbers.WholeNumber(parameter.Key, node);

    public override Json? Write(SceneWriter writer, object value) => Convert.ToInt64(value, CultureInfo.InvariantCulture);

    public override JsonObject Schema(RecordParameter parameter) => SceneSchema.Number("integer", parameter);

    public override string Words(RecordParameter parameter) => "whole number";

    public override bool IsNumeric(JsonNode? written) => true;

    public override object? Parse(RecordParameter parameter, JsonNode node) => (int?)node.Number;
}

/// <summary>So many numbers in brackets.</summary>
/// <param name="name">The name of the kind, in camelCase.</param>
/// <param name="count">The count of the numbers.</param>
/// <param name="make">Makes a value of its numbers.</param>
/// <param name="numbers">Returns the numbers of a value.</param>
public class VectorForm<T>(string name, int count, Func<float[], T> make, Func<T, float[]> numbers) : ParameterForm(name)
    where T : struct
{
    /// <inheritdoc/>
    public override bool Fits(RecordParameter parameter) => parameter.ValueType == typeof(T);

    /// <inheritdoc/>
    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) =>
        parameter.IsNumber && node.Kind == JsonKind.Number ? reader.Numbers.Number(parameter, node) is float number ? All(number) : null
        : reader.Numbers.Elements(parameter.Key, node, count, parameter) is { } read ? make(read) : null;

    /// <inheritdoc/>
    public override Json? Write(SceneWriter writer, object value) => new JsonArray([.. numbers((T)value).Select(SceneWriter.Number)]);

    /// <inheritdoc/>
    public override JsonObject Schema(RecordParameter parameter)
    {
        JsonObject list = SceneSchema.Numbers(count, SceneSchema.Number("number", parameter));
        return parameter.IsNumber ? SceneSchema.AnyOf(SceneSchema.Number("number", parameter), list) : list;
    }

    /// <inheritdoc/>
    public override string Words(RecordParameter parameter) =>
        $"{(parameter.IsNumber ? "number or " : "")}[{string.Join(", ", Enumerable.Repeat("number", count))}]";

    /// <inheritdoc/>
    public override bool IsNumeric(JsonNode? written) => true;

    /// <inheritdoc/>
    public override object? Parse(RecordParameter parameter, JsonNode node) => node.Number is { } one ? All(one)
        : (float[])[.. node.Items.Select(i => i.Number).OfType<float>()] is var read && read.Length == count && node.Items.Count == count ? make(read) : null;

    private T All(float number) => make([.. Enumerable.Repeat(number, count)]);
}

/// <summary>A colour.</summary>
internal sealed class ColorForm() : VectorForm<Rgb>("color", 3, c => new(c[0], c[1], c[2]), c => [c.R, c.G, c.B])
{
    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) => reader.Numbers.Color(parameter.Key, node, parameter);

    public override JsonObject Schema(RecordParameter parameter) => SceneSchema.Reference("color");

    public override string Words(RecordParameter parameter) => "colour";
}

/// <summary>An exposure: stops, or the word for the one that the picture asks for.</summary>
internal sealed class ExposureForm() : ParameterForm("exposure")
{
    public override bool Fits(RecordParameter parameter) => parameter.ValueType == typeof(Exposure);

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) =>
        node.Kind == JsonKind.String ? Exposure.Named(node.Text) ?? reader.Unknown(
            node, $"unknown value {Quotation.Of(node.Text)} for {Quotation.Of(parameter.Key)}", Exposure.Words, "expected a number or")
        : reader.Numbers.Number(parameter, node) is float stops ? (Exposure)stops : null;

    public override Json? Write(SceneWriter writer, object value) =>
        (Exposure)value is { Rule: ExposureRule.Stops, Stops: var stops } ? SceneWriter.Number(stops) : value.ToString()!;

    public override JsonObject Schema(RecordParameter parameter) =>
        SceneSchema.AnyOf(SceneSchema.Number("number", parameter), new() { ["enum"] = new JsonArray([.. Exposure.Words.Select(w => (Json)w)]) });

    public override string Words(RecordParameter parameter) => $"number, {string.Join(" or ", Exposure.Words.Select(w => $"`\"{w}\"`"))}";

    public override object? Parse(RecordParameter parameter, JsonNode node) => node.Number;
}
