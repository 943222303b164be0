using System.Text.Json;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The values of a scene, read as the schema describes them.</summary>
internal static class ParameterValues
{
    /// <summary>A number; null where it is none.</summary>
    public static double? Number(JsonNode? value) =>
        value is JsonValue v && v.GetValueKind() == JsonValueKind.Number ? v.Deserialize<double>() : null;

    /// <summary>A string; null where it is none.</summary>
    public static string? Text(JsonNode? value) =>
        value is JsonValue v && v.GetValueKind() == JsonValueKind.String ? v.GetValue<string>() : null;

    /// <summary>A list of so many numbers; null where it is none.</summary>
    public static double[]? Numbers(JsonNode? value, int count) =>
        value is JsonArray list && list.Count == count && list.All(i => Number(i) is not null) ? [.. list.Select(i => Number(i)!.Value)] : null;

    /// <summary>A number, or the one that all channels of a colour are; null where it is neither.</summary>
    public static double? Grey(JsonNode? value) =>
        Number(value) ?? (Numbers(value, 3) is { } c && c[0] == c[1] && c[1] == c[2] ? c[0] : null);

    /// <summary>A written colour as linear numbers; null where it is none, such as a texture's name.</summary>
    public static double[]? Color(JsonNode? value) => Numbers(value, 3)
        ?? (Text(value) is { } name && (CssColors.Find(name) ?? CssColors.FromHex(name)) is { } color ? [color.R, color.G, color.B] : null);

    /// <summary>A linear colour as #rrggbb.</summary>
    public static string Hex(double[] c) =>
        $"#{SrgbCurve.Encode8((float)c[0]):x2}{SrgbCurve.Encode8((float)c[1]):x2}{SrgbCurve.Encode8((float)c[2]):x2}";

    /// <summary>Numbers as JSON.</summary>
    public static JsonArray List(IEnumerable<double> numbers) => [.. numbers.Select(n => (JsonNode)JsonValue.Create(n))];

    /// <summary>The type that an object says it is; null where it says none.</summary>
    public static CatalogueType? TypeOf(JsonNode? value, string family) =>
        value is JsonObject thing && Text(thing["type"]) is { } name ? PanelContext.Catalogue.Types[family].FirstOrDefault(t => t.Name == name) : null;

    /// <summary>Another type in place of a thing's: what both of them know stays, where it means the same.</summary>
    public static JsonObject Retyped(JsonNode? value, CatalogueType type, CatalogueType? before)
    {
        JsonObject result = new() { ["type"] = type.Name };
        foreach (CatalogueParameter p in type.Parameters)
        {
            JsonNode? written = (value as JsonObject)?[p.Key];
            if (written is not null && Fits(before?.Parameters.FirstOrDefault(q => q.Key == p.Key), p, written))
            {
                result[p.Key] = written.DeepClone();
            }
            else if (p.Required)
            {
                result[p.Key] = p.Default?.DeepClone() ?? Plain(p.Kind);
            }
        }

        return result;
    }

    /// <summary>Returns a new record for a list.</summary>
    public static JsonObject Fresh(CatalogueType type)
    {
        JsonObject result = [];
        foreach (CatalogueParameter p in type.Parameters.Where(p => p.Required))
        {
            result[p.Key] = p.Default?.DeepClone() ?? 0;
        }

        return result;
    }

    // Whether what was written for one parameter may stand for another one of the same name.
    private static bool Fits(CatalogueParameter? before, CatalogueParameter now, JsonNode value) =>
        before is not null && before.Kind == now.Kind && before.Record == now.Record
        && (now.Kind != "choice" || now.Choices.Contains(Text(value), StringComparer.OrdinalIgnoreCase))
        && (now.Kind != "texture" || now.IsNumber || Number(value) is null)
        && AllNumbers(value).All(n => n >= (now.Minimum ?? double.NegativeInfinity) && n <= (now.Maximum ?? double.PositiveInfinity));

    private static IEnumerable<double> AllNumbers(JsonNode? value) =>
        Number(value) is { } n ? [n] : value is JsonArray list ? list.SelectMany(AllNumbers) : [];

    private static JsonNode Plain(string kind) => kind switch
    {
        "texture" or "color" => "white",
        "vector3" => new JsonArray(0, 1, 0),
        "vector2" => new JsonArray(1, 1),
        "number" or "integer" => 1,
        "boolean" => false,
        "material" => new JsonObject { ["type"] = "diffuse" },
        _ => "",
    };
}
