using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace RayTracer.Cli;

/// <summary>Writes the one JSON object that <c>--json</c> prints.</summary>
internal static class JsonText
{
    /// <summary>Writes an object.</summary>
    /// <param name="streams">Where to.</param>
    /// <param name="members">Writes its members.</param>
    public static void Write(Streams streams, Action<Utf8JsonWriter> members)
    {
        using MemoryStream text = new();
        using (Utf8JsonWriter json = new(text, new() { Indented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping }))
        {
            json.WriteStartObject();
            members(json);
            json.WriteEndObject();
        }

        streams.Output.WriteLine(Encoding.UTF8.GetString(text.GetBuffer(), 0, (int)text.Length));
    }

    /// <summary>Writes a list of texts.</summary>
    public static void Strings(Utf8JsonWriter json, string key, IEnumerable<string> texts)
    {
        json.WriteStartArray(key);
        foreach (string text in texts)
        {
            json.WriteStringValue(text);
        }

        json.WriteEndArray();
    }

    /// <summary>Writes a number; NaN and infinities, which JSON has not, as null.</summary>
    public static void Number(Utf8JsonWriter json, string key, double value)
    {
        if (double.IsFinite(value))
        {
            json.WriteNumber(key, value);
        }
        else
        {
            json.WriteNull(key);
        }
    }
}
