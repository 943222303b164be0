using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace RayTracer.Scenes;

/// <summary>Lays JSON out for readers: what fits on a line stands on one.</summary>
public static class JsonLayout
{
    private const int Width = 110;

    private static readonly JsonSerializerOptions Compact = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>The text of a value, without a line end after it.</summary>
    /// <param name="value">The value.</param>
    /// <param name="indent">Spaces before the lines after the first.</param>
    /// <param name="used">Characters already on the first line, beyond the indent.</param>
    public static string Print(System.Text.Json.Nodes.JsonNode? value, int indent = 0, int used = 0)
    {
        string line = OneLine(value);
        if (indent + used + line.Length <= Width || value is not (JsonObject or JsonArray))
        {
            return line;
        }

        string gap = "\n" + new string(' ', indent);
        IEnumerable<string> parts = value is JsonObject members
            ? members.Select(m => Member(m.Key, m.Value, indent + 2))
            : ((JsonArray)value).Select(item => Print(item, indent + 2));
        (char open, char close) = value is JsonObject ? ('{', '}') : ('[', ']');
        return $"{open}{gap}  {string.Join($",{gap}  ", parts)}{gap}{close}";
    }

    private static string Member(string key, System.Text.Json.Nodes.JsonNode? value, int indent)
    {
        string start = Quote(key) + ": ";
        return start + Print(value, indent, start.Length);
    }

    /// <summary>The text of a value on one line.</summary>
    public static string OneLine(System.Text.Json.Nodes.JsonNode? value) => value switch
    {
        JsonObject { Count: > 0 } members => $"{{ {string.Join(", ", members.Select(m => $"{Quote(m.Key)}: {OneLine(m.Value)}"))} }}",
        JsonArray items => $"[{string.Join(", ", items.Select(OneLine))}]",
        null => "null",
        _ => value.ToJsonString(Compact),
    };

    /// <summary>A string in double quotes.</summary>
    public static string Quote(string text) => JsonSerializer.Serialize(text, Compact);
}
