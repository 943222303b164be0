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
        JsonObject definitions = new() { ["color"] = Color(), ["texture"] = Texture(), ["material"] = Material(), ["shape"] = OneOf(SceneTypes.Shapes), ["environment"] = OneOf(SceneTypes.Environments) };
        foreach (RecordType listed in SceneTypes.Families.SelectMany(f => f.Types).Concat(SceneTypes.Parts)
            .SelectMany(t => t.Parameters).Where(p => p.Kind == ParameterKind.Records).Select(p => RecordType.Of(p.RecordType!)).Distinct())
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

    private static JsonObject Reference(string definition) => new() { ["$ref"] = $"#/$defs/{definition}" };

    private static JsonObject OneOf(TypeFamily family) =>
        new() { ["type"] = "object", ["required"] = new JsonArray("type"), ["oneOf"] = new JsonArray([.. family.Types.Select(t => Reference(Name(family, t)))]) };

    private static JsonObject Color() => new()
    {
        ["description"] = "A colour: a CSS name or #rrggbb (both sRGB), or [red, green, blue] (linear).",
        ["anyOf"] = new JsonArray(
            new JsonObject { ["enum"] = new JsonArray([.. CssColors.Names.Select(n => (Json?)n)]) },
            new JsonObject { ["type"] = "string", ["pattern"] = "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$" },
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

    private static JsonObject Record(RecordType type)
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
        foreach ((string key, Json? value) in Form(parameter).ToArray())
        {
            json[key] = value?.DeepClone();
        }

        if (!parameter.Required && parameter.Default is { } standard && standard is not System.Collections.ICollection)
        {
            json["default"] = Json.Parse(SceneWriter.WriteValue(standard));
        }

        return json;
    }

    private static JsonObject Form(RecordParameter parameter) => parameter.Kind switch
    {
        ParameterKind.Number => Number("number", parameter),
        ParameterKind.Integer => Number("integer", parameter),
        ParameterKind.Boolean => new() { ["type"] = "boolean" },
        ParameterKind.Text => new() { ["type"] = "string" },
        ParameterKind.File => new() { ["type"] = "string", ["minLength"] = 1 },
        ParameterKind.Choice => new() { ["enum"] = new JsonArray([.. parameter.Choices.Select(c => (Json?)c)]) },
        ParameterKind.Vector2 => Numbers(2, Number("number", parameter)),
        ParameterKind.Vector3 => Numbers(3, Number("number", parameter)),
        ParameterKind.Color => Reference("color"),
        ParameterKind.Texture when parameter.IsNumber => new() { ["anyOf"] = new JsonArray(Number("number", parameter), Reference("texture")) },
        ParameterKind.Texture => Reference("texture"),
        ParameterKind.Material => Reference("material"),
        ParameterKind.Materials => List(Reference("material")),
        ParameterKind.Shape => new() { ["anyOf"] = new JsonArray(new JsonObject { ["type"] = "string" }, Reference("shape")) },
        ParameterKind.Shapes => List(Reference("shape")),
        ParameterKind.Environment => Reference("environment"),
        ParameterKind.Records => List(Reference(RecordType.Of(parameter.RecordType!).Name)),
        ParameterKind.Numbers when parameter.IsNumber => new() { ["anyOf"] = new JsonArray(Number("number", parameter), List(Number("number", parameter)), Reference("color")) },
        ParameterKind.Numbers => List(Number("number", parameter)),
        ParameterKind.Integers => List(new() { ["type"] = "integer" }),
        ParameterKind.Vector2s => List(Numbers(2, Number("number", parameter))),
        ParameterKind.Vector3s => List(Numbers(3, Number("number", parameter))),
        ParameterKind.Triangles => List(new() { ["type"] = "array", ["items"] = new JsonObject { ["type"] = "integer" }, ["minItems"] = 3, ["maxItems"] = 3 }),
        ParameterKind.NamedShapes => new() { ["type"] = "object", ["additionalProperties"] = new JsonObject { ["anyOf"] = new JsonArray(new JsonObject { ["type"] = "string" }, Reference("shape")) } },
        ParameterKind.NamedTextures => new() { ["type"] = "object", ["additionalProperties"] = Reference("texture") },
        ParameterKind.NamedMaterials => new() { ["type"] = "object", ["additionalProperties"] = Reference("material") },
        _ => Record(RecordType.Of(parameter.ValueType)),
    };

    private static JsonObject List(JsonObject item) => new() { ["type"] = "array", ["items"] = item };

    private static JsonObject Number(string type, RecordParameter parameter)
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

    private static JsonObject Numbers(int count, JsonObject item)
    {
        item["type"] = "number";
        return new() { ["type"] = "array", ["items"] = item, ["minItems"] = count, ["maxItems"] = count };
    }
}
