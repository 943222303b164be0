using System.Globalization;
using System.Text.Json.Nodes;

namespace RayTracer.Session;

/// <summary>Every text of a face of the session, in one place: the Studio's pages are built with the same file.</summary>
public static class SessionTexts
{
    private static readonly JsonObject All = Read("english");

    /// <summary>A text by its place, such as "viewport.exposure" or "commands.save.1".</summary>
    /// <exception cref="KeyNotFoundException">There is none.</exception>
    public static string Of(string place) =>
        Find(place) as JsonValue is { } text ? text.GetValue<string>() : throw new KeyNotFoundException($"There is no text {place}.");

    /// <summary>A text in which values take the places that are in braces, in their order.</summary>
    /// <exception cref="KeyNotFoundException">There is none.</exception>
    public static string Of(string place, params ReadOnlySpan<object> values)
    {
        string text = Of(place);
        foreach (object value in values)
        {
            int from = text.IndexOf('{', StringComparison.Ordinal);
            int to = text.IndexOf('}', StringComparison.Ordinal);
            if (from < 0)
            {
                break;
            }

            // Braces in a value are none of the text's.
            string written = Convert.ToString(value, CultureInfo.InvariantCulture)!.Replace('{', '\uE000').Replace('}', '\uE001');
            text = text[..from] + written + text[(to + 1)..];
        }

        return text.Replace('\uE000', '{').Replace('\uE001', '}');
    }

    /// <summary>The keys of a group of texts, in their order.</summary>
    /// <exception cref="KeyNotFoundException">There is no such group.</exception>
    public static IReadOnlyList<string> Keys(string place) => Find(place) as JsonObject is { } group ? [.. group.Select(g => g.Key)] : throw new KeyNotFoundException($"There are no texts {place}.");

    /// <summary>A list of texts, or of the first and second of pairs.</summary>
    /// <exception cref="KeyNotFoundException">There is no such list.</exception>
    public static int Count(string place) =>
        Find(place) as JsonArray is { } list ? list.Count : throw new KeyNotFoundException($"There is no list of texts {place}.");

    /// <summary>One of the files beside the texts.</summary>
    internal static JsonObject Read(string name)
    {
        using Stream stream = typeof(SessionTexts).Assembly.GetManifestResourceStream($"texts/{name}.json")!;
        return JsonNode.Parse(stream)!.AsObject();
    }

    private static System.Text.Json.Nodes.JsonNode? Find(string place)
    {
        System.Text.Json.Nodes.JsonNode? at = All;
        foreach (string step in place.Split('.'))
        {
            at = at switch
            {
                JsonObject group => group[step],
                JsonArray list when int.TryParse(step, NumberStyles.None, CultureInfo.InvariantCulture, out int i) && i < list.Count => list[i],
                _ => null,
            };
        }

        return at;
    }
}
