using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using RayTracer.Description;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Scenes;

/// <summary>Makes the JSON Schema of scene files, with which editors complete, explain and check what is typed.</summary>
public static class SceneSchema
{
    private static readonly JsonSerializerOptions Layout =
        new() { WriteIndented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>The schema (draft 2020-12), made from the description records.</summary>
    public static string Generate()
    {
        JsonObject definitions = new()
        {
            ["color"] = Color(),
            ["texture"] = Texture(),
            ["material"] = Material(),
            ["shape"] = OneOf(SceneTypes.Shapes),
            ["environment"] = OneOf(SceneTypes.Environments),
        };
        foreach (RecordType listed in SceneTypes.Families.SelectMany(f => f.Types).Concat(SceneTypes.Parts)
            .SelectMany(t => t.Parameters).Where(p => p.RecordType is { } record && (p.IsList || RecordType.Of(record).HoldsItself)).Select(p => RecordType.Of(p.RecordType!)).Distinct())
        {
            definitions[listed.Name] = Record(listed);
        }

        foreach (TypeFamily family in SceneTypes.Families)
        {
            foreach (RecordType type in family.Types)
            {
                definitions[Name(family, type)] = Record(type);
            }
        }

        JsonObject schema = new()
        {
            ["$schema"] = "https://json-schema.org/draft/2020-12/schema",
            ["title"] = "Scene",
            ["allowComments"] = true,
            ["allowTrailingCommas"] = true,
        };
        foreach ((string key, Json? value) in Record(SceneTypes.Scene).ToArray())
        {
            schema[key] = value?.DeepClone();
        }

        schema["properties"]!["$schema"] = new JsonObject { ["type"] = "string", ["description"] = "The path of this schema, for editors." };
        schema["$defs"] = definitions;
        return schema.ToJsonString(Layout) + "\n";
    }

    private static string Name(TypeFamily family, RecordType type) => $"{family.Noun}.{type.Name}";

    internal static JsonObject Reference(string definition) => new() { ["$ref"] = $"#/$defs/{definition}" };

    private static JsonObject OneOf(TypeFamily family) =>
        new() { ["type"] = "object", ["required"] = new JsonArray("type"), ["oneOf"] = new JsonArray([.. family.Types.Select(t => Reference(Name(family, t)))]) };

    private static JsonObject Color() => new()
    {
        ["description"] = "A colour: a CSS name or #rrggbb (both sRGB), or [red, green, blue] (linear), or one number for a grey.",
        ["anyOf"] = new JsonArray(
            new JsonObject { ["enum"] = new JsonArray([.. CssColors.Names.Select(n => (Json?)n)]) },
            new JsonObject { ["type"] = "string", ["pattern"] = "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$" },
            new JsonObject { ["type"] = "number", ["minimum"] = 0 },
            Numbers(3, new() { ["minimum"] = 0 })),
    };

    private static JsonObject Texture() => new()
    {
        ["description"] = "A texture, a colour, or the name of a texture.",
        ["anyOf"] = new JsonArray(
            Reference("color"), new JsonObject { ["type"] = "string", ["pattern"] = "^[^#]" }, OneOf(SceneTypes.Textures)),
    };

    private static JsonObject Material() => new()
    {
        ["description"] = "A material, or the name of one.",
        ["anyOf"] = new JsonArray(new JsonObject { ["type"] = "string" }, OneOf(SceneTypes.Materials)),
    };

    internal static JsonObject Record(RecordType type)
    {
        JsonObject properties = [];
        JsonArray required = [];
        JsonObject record = new() { ["type"] = "object" };
        if (type.Summary.Length > 0)
        {
            record["description"] = type.Summary;
            properties["type"] = new JsonObject { ["const"] = type.Name, ["description"] = type.Summary };
            required.Add("type");
        }

        foreach (RecordParameter parameter in type.Parameters)
        {
            properties[parameter.Key] = Parameter(parameter);
            if (parameter.Required)
            {
                required.Add(parameter.Key);
            }
        }

        record["properties"] = properties;
        record["required"] = required;
        record["additionalProperties"] = false;
        return record;
    }

    private static JsonObject Parameter(RecordParameter parameter)
    {
        JsonObject json = new() { ["description"] = parameter.Summary + (parameter.Unit.Length > 0 ? $" Unit: {parameter.Unit}." : "") };
        foreach ((string key, Json? value) in ParameterForm.Of(parameter).Schema(parameter).ToArray())
        {
            json[key] = value?.DeepClone();
        }

        if (!parameter.Required && parameter.Default is { } standard && standard is not System.Collections.ICollection)
        {
            json["default"] = Json.Parse(SceneWriter.WriteValue(parameter, standard));
        }

        return json;
    }

    // A shape's name is that of an object; those of others are in their definitions.
    internal static JsonObject Thing(TypeFamily family) =>
        family == SceneTypes.Shapes ? AnyOf(new() { ["type"] = "string" }, Reference(family.Noun)) : Reference(family.Noun);

    internal static JsonObject AnyOf(params JsonObject[] forms) => new() { ["anyOf"] = new JsonArray([.. forms]) };

    internal static JsonObject List(JsonObject item) => new() { ["type"] = "array", ["items"] = item };

    internal static JsonObject Number(string type, RecordParameter parameter)
    {
        JsonObject number = new() { ["type"] = type };
        if (double.IsFinite(parameter.Minimum))
        {
            number[parameter.MinimumIsExclusive ? "exclusiveMinimum" : "minimum"] = parameter.Minimum;
        }

        if (double.IsFinite(parameter.Maximum))
        {
            number["maximum"] = parameter.Maximum;
        }

        return number;
    }

    internal static JsonObject Numbers(int count, JsonObject item)
    {
        item["type"] = "number";
        return new() { ["type"] = "array", ["items"] = item, ["minItems"] = count, ["maxItems"] = count };
    }
}
