using System.Text.Json;
using System.Text.RegularExpressions;

namespace RayTracer.Scenes.Tests;

/// <summary>Validates JSON by the keywords of JSON Schema (draft 2020-12) that the scene schema uses; any other keyword is an error.</summary>
internal sealed class SchemaValidator(JsonElement root)
{
    public bool Accepts(JsonElement value) => Accepts(root, value);

    private bool Accepts(JsonElement schema, JsonElement value) =>
        schema.ValueKind == JsonValueKind.False ? false : schema.EnumerateObject().All(rule => Keeps(schema, rule, value));

    private bool Keeps(JsonElement schema, JsonProperty rule, JsonElement value)
    {
        bool isObject = value.ValueKind == JsonValueKind.Object;
        bool isArray = value.ValueKind == JsonValueKind.Array;
        bool isString = value.ValueKind == JsonValueKind.String;
        bool isNumber = value.ValueKind == JsonValueKind.Number;
        return rule.Name switch
        {
            "$schema" or "$defs" or "title" or "description" or "default" or "allowComments" or "allowTrailingCommas" => true,
            "$ref" => Accepts(root.GetProperty("$defs").GetProperty(rule.Value.GetString()!["#/$defs/".Length..]), value),
            "type" => IsOf(rule.Value.GetString()!, value),
            "const" => JsonElement.DeepEquals(rule.Value, value),
            "enum" => rule.Value.EnumerateArray().Any(e => JsonElement.DeepEquals(e, value)),
            "anyOf" => rule.Value.EnumerateArray().Any(s => Accepts(s, value)),
            "oneOf" => rule.Value.EnumerateArray().Count(s => Accepts(s, value)) == 1,
            "pattern" => !isString || Regex.IsMatch(value.GetString()!, rule.Value.GetString()!),
            "minLength" => !isString || value.GetString()!.Length >= rule.Value.GetInt32(),
            "minimum" => !isNumber || value.GetDouble() >= rule.Value.GetDouble(),
            "exclusiveMinimum" => !isNumber || value.GetDouble() > rule.Value.GetDouble(),
            "maximum" => !isNumber || value.GetDouble() <= rule.Value.GetDouble(),
            "items" => !isArray || value.EnumerateArray().All(i => Accepts(rule.Value, i)),
            "minItems" => !isArray || value.GetArrayLength() >= rule.Value.GetInt32(),
            "maxItems" => !isArray || value.GetArrayLength() <= rule.Value.GetInt32(),
            "required" => !isObject || rule.Value.EnumerateArray().All(k => value.TryGetProperty(k.GetString()!, out _)),
            "properties" => !isObject || value.EnumerateObject().All(m => !rule.Value.TryGetProperty(m.Name, out JsonElement s) || Accepts(s, m.Value)),
            "additionalProperties" => !isObject || value.EnumerateObject().All(m => IsListed(schema, m.Name) || Accepts(rule.Value, m.Value)),
            _ => throw new NotSupportedException($"unknown keyword {rule.Name}"),
        };
    }

    private static bool IsListed(JsonElement schema, string key) =>
        schema.TryGetProperty("properties", out JsonElement properties) && properties.TryGetProperty(key, out _);

    private static bool IsOf(string type, JsonElement value) => type switch
    {
        "integer" => value.ValueKind == JsonValueKind.Number && value.GetDouble() == Math.Floor(value.GetDouble()),
        "boolean" => value.ValueKind is JsonValueKind.True or JsonValueKind.False,
        _ => value.ValueKind.ToString().Equals(type, StringComparison.OrdinalIgnoreCase),
    };
}
