using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace RayTracer.Cli;

/// <summary>The one JSON object that <c>--json</c> prints.</summary>
internal static class JsonText
{
    /// <summary>Writes an object.</summary>
    public static void Write(Streams streams, JsonObject members)
    {
        using MemoryStream text = new();
        using (Utf8JsonWriter json = new(
            text, new() { Indented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping }))
        {
            members.WriteTo(json);
        }

        streams.Output.WriteLine(Encoding.UTF8.GetString(text.GetBuffer(), 0, (int)text.Length));
    }

    /// <summary>Returns a list.</summary>
    public static JsonArray List(IEnumerable<JsonNode?> items) => [.. items];

    /// <summary>Returns a list of texts.</summary>
    public static JsonArray List(IEnumerable<string> texts) => List(texts.Select(t => (JsonNode?)t));

    /// <summary>Returns a number; null for NaN and infinities, which JSON has not.</summary>
    public static JsonNode? Number(double value) => double.IsFinite(value) ? value : null;
}
