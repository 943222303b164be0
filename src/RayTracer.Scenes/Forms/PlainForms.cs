using System.Text.Json.Nodes;
using RayTracer.Description;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Scenes;

/// <summary>true or false.</summary>
internal sealed class BooleanForm() : ParameterForm("boolean")
{
    public override bool Fits(RecordParameter parameter) => parameter.ValueType == typeof(bool);

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) =>
        reader.Is(node, JsonKind.Boolean, "true or false", parameter.Key) ? node.Text == "true" : null;

    public override Json? Write(SceneWriter writer, object value) => (bool)value;

    public override JsonObject Schema(RecordParameter parameter) => new() { ["type"] = "boolean" };

    public override string Words(RecordParameter parameter) => "`true` or `false`";
}

/// <summary>Text.</summary>
internal sealed class TextForm() : ParameterForm("text")
{
    public override bool Fits(RecordParameter parameter) => parameter.ValueType == typeof(string);

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) =>
        reader.Is(node, JsonKind.String, "a string", parameter.Key) ? node.Text : null;

    public override Json? Write(SceneWriter writer, object value) => (string)value;

    public override JsonObject Schema(RecordParameter parameter) => new() { ["type"] = "string" };

    public override string Words(RecordParameter parameter) => "text";
}

/// <summary>The path of a file, relative to the scene file's folder.</summary>
internal sealed class FileForm() : ParameterForm("file")
{
    public override bool Fits(RecordParameter parameter) => parameter.IsFile;

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node)
    {
        if (!reader.Is(node, JsonKind.String, "the path of a file", parameter.Key))
        {
            return null;
        }

        if (node.Text.Length == 0 || node.Text.Contains('\0', StringComparison.Ordinal))
        {
            reader.Error(node, $"{Quotation.Of(node.Text)} is not a file path");
            return null;
        }

        return node.Text;
    }

    public override Json? Write(SceneWriter writer, object value) => writer.FileName((string)value);

    public override JsonObject Schema(RecordParameter parameter) => new() { ["type"] = "string", ["minLength"] = 1 };

    public override string Words(RecordParameter parameter) => "path";
}

/// <summary>One of a few words.</summary>
internal sealed class ChoiceForm() : ParameterForm("choice")
{
    public override bool Fits(RecordParameter parameter) => NamedValues.Of(parameter.ValueType) is not null;

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) =>
        !reader.Is(node, JsonKind.String, $"one of {string.Join(", ", parameter.Choices)}", parameter.Key) ? null
        : parameter.Choice(node.Text) ?? reader.Unknown(
            node, $"unknown value {Quotation.Of(node.Text)} for {Quotation.Of(parameter.Key)}", parameter.Choices, "expected one of");

    public override Json? Write(SceneWriter writer, object value) => NamedValues.NameOf(value);

    public override JsonObject Schema(RecordParameter parameter) => new() { ["enum"] = new JsonArray([.. parameter.Choices.Select(c => (Json?)c)]) };

    public override string Words(RecordParameter parameter) => string.Join(", ", parameter.Choices.Select(c => $"`\"{c}\"`"));

    public override object? Parse(RecordParameter parameter, JsonNode node) => node.Kind == JsonKind.String ? parameter.Choice(node.Text) : null;
}
