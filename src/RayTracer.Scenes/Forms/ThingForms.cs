using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Textures;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Scenes;

/// <summary>A shape, material, texture or environment, or the name of one.</summary>
internal class ThingForm(TypeFamily family) : ParameterForm(family.Noun)
{
    public override bool Fits(RecordParameter parameter) => parameter.Family == family && !parameter.HoldsRecords;

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) => reader.Thing(family, parameter.Key, node);

    public override Json? Write(SceneWriter writer, object value) => writer.Thing(value);

    public override JsonObject Schema(RecordParameter parameter) => SceneSchema.Thing(family);

    public override string Words(RecordParameter parameter) => $"[{family.Noun}](#{family.Noun}s)";
}

/// <summary>A texture, a colour, or a texture's name; where the parameter says so, a number too.</summary>
internal sealed class TextureForm() : ThingForm(SceneTypes.Textures)
{
    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node)
    {
        if (parameter.IsNumber && node.Kind == JsonKind.Number)
        {
            return reader.Numbers.Number(parameter, node) is float number ? reader.Solid(node, new(number, number, number)) : null;
        }

        TextureDescription? texture = reader.Texture(parameter.Key, node, parameter);
        if (texture is not null && parameter.RangeComplaint(texture) is { } complaint)
        {
            reader.Error(node, $"{Quotation.Of(parameter.Key)} {complaint}", DiagnosticRule.OutOfRange);
            return null;
        }

        return texture;
    }

    public override JsonObject Schema(RecordParameter parameter) =>
        parameter.IsNumber ? SceneSchema.AnyOf(SceneSchema.Number("number", parameter), base.Schema(parameter)) : base.Schema(parameter);

    public override string Words(RecordParameter parameter) => (parameter.IsNumber ? "number or " : "") + base.Words(parameter);

    public override bool IsNumeric(JsonNode? written) => written is null or { Kind: JsonKind.Number or JsonKind.Array }
        || (written.Kind == JsonKind.String && (written.Text.StartsWith('#') || CssColors.Find(written.Text) is not null));
}

/// <summary>A list of shapes or materials.</summary>
/// <param name="family">The shapes or materials.</param>
/// <param name="hasReferences">True where elements may be names.</param>
internal sealed class ThingListForm(TypeFamily family, bool hasReferences) : ParameterForm($"{family.Noun}s")
{
    public override bool Fits(RecordParameter parameter) => parameter.Family == family && parameter.IsList;

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) => reader.List(
        family.Base, parameter.Key, node, Name, item => hasReferences ? reader.Thing(family, parameter.Key, item) : reader.Inline(item, family, parameter.Key));

    public override Json? Write(SceneWriter writer, object value) =>
        new JsonArray([.. ((IEnumerable<object>)value).Select(thing => hasReferences ? writer.Thing(thing) : writer.Inline(thing))]);

    public override JsonObject Schema(RecordParameter parameter) => SceneSchema.List(SceneSchema.Reference(family.Noun));

    public override string Words(RecordParameter parameter) => $"list of [{Name}](#{Name})";
}

/// <summary>Shapes, materials or textures by their names.</summary>
internal sealed class NamedThingsForm<T>(string name, TypeFamily family) : ParameterForm(name)
    where T : class
{
    public override bool Fits(RecordParameter parameter) => parameter.ValueType == typeof(IReadOnlyDictionary<string, T>);

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) =>
        reader.Is(node, JsonKind.Object, "an object { … }", parameter.Key) ? reader.Named(family) : null;

    public override Json? Write(SceneWriter writer, object value) => writer.Named((IReadOnlyDictionary<string, T>)value);

    public override JsonObject Schema(RecordParameter parameter) => new() { ["type"] = "object", ["additionalProperties"] = SceneSchema.Thing(family) };

    public override string Words(RecordParameter parameter) => $"object: names and [{family.Noun}s](#{family.Noun}s)";
}

/// <summary>An object of parameters.</summary>
internal sealed class RecordForm() : ParameterForm("record")
{
    public override bool Fits(RecordParameter parameter) => parameter.IsRecord;

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node) => reader.Record(parameter.Key, node, parameter.RecordType!);

    public override Json? Write(SceneWriter writer, object value) => writer.Inline(value);

    // What may hold one of its kind is named, as it would have no end.
    public override JsonObject Schema(RecordParameter parameter) => RecordType.Of(parameter.RecordType!) is { HoldsItself: true, Name: var name } ? SceneSchema.Reference(name)
        : SceneSchema.Record(RecordType.Of(parameter.RecordType!));

    public override string Words(RecordParameter parameter) => $"[{RecordType.Of(parameter.RecordType!).Name}](#{RecordType.Of(parameter.RecordType!).Name})";
}

/// <summary>A list of objects of parameters; one alone may stand without the brackets.</summary>
internal sealed class RecordListForm() : ParameterForm("records")
{
    public override bool Fits(RecordParameter parameter) => parameter is { IsList: true, RecordType: not null };

    public override object? Read(RecordReader reader, RecordParameter parameter, JsonNode node)
    {
        object? Record(JsonNode item) => reader.Record(parameter.Key, item, parameter.RecordType!);
        return node.Kind == JsonKind.Object
            ? RecordReader.List(parameter.RecordType!, [node], Record)
            : reader.List(parameter.RecordType!, parameter.Key, node, "objects { … }", Record);
    }

    public override Json? Write(SceneWriter writer, object value) => new JsonArray([.. ((IEnumerable<object>)value).Select(writer.Inline)]);

    public override JsonObject Schema(RecordParameter parameter) => SceneSchema.AnyOf(
        SceneSchema.Reference(RecordType.Of(parameter.RecordType!).Name),
        SceneSchema.List(SceneSchema.Reference(RecordType.Of(parameter.RecordType!).Name)));

    public override string Words(RecordParameter parameter) =>
        $"one or a list of [{RecordType.Of(parameter.RecordType!).Name}s](#{RecordType.Of(parameter.RecordType!).Name})";
}
