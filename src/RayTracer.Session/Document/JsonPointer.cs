using System.Globalization;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Places in a JSON text (RFC 6901): <c>/shapes/3/material</c>; in keys, <c>~1</c> is a slash and <c>~0</c> a tilde.</summary>
public static class JsonPointer
{
    /// <summary>The steps of a pointer, unescaped; none for the whole text.</summary>
    /// <exception cref="SessionException">It is no pointer.</exception>
    public static string[] Parse(string pointer)
    {
        if (pointer.Length == 0)
        {
            return [];
        }

        return pointer[0] == '/'
            ? [.. pointer[1..].Split('/').Select(s => s.Replace("~1", "/", StringComparison.Ordinal).Replace("~0", "~", StringComparison.Ordinal))]
            : throw new SessionException($"{JsonLayout.Quote(pointer)} is not a JSON pointer: it must start with a slash");
    }

    /// <summary>The pointer of some steps.</summary>
    public static string Of(params IEnumerable<string> steps) => string.Concat(steps.Select(s => "/" + Escape(s)));

    /// <summary>A pointer with one more step.</summary>
    public static string Append(string pointer, string step) => $"{pointer}/{Escape(step)}";

    /// <summary>A pointer with one more step, into an array.</summary>
    public static string Append(string pointer, int index) => string.Create(CultureInfo.InvariantCulture, $"{pointer}/{index}");

    /// <summary>A pointer without its last step; null for that of the whole text.</summary>
    public static string? Parent(string pointer) => pointer.Length == 0 ? null : pointer[..pointer.LastIndexOf('/')];

    /// <summary>The last step of a pointer, unescaped; empty for that of the whole text.</summary>
    public static string Last(string pointer) => Parse(pointer).LastOrDefault("");

    /// <summary>The place of a step into an array; −1 where it is none.</summary>
    public static int Index(string step) =>
        (step == "0" || (step.Length > 0 && step[0] != '0')) && int.TryParse(step, NumberStyles.None, CultureInfo.InvariantCulture, out int index) ? index : -1;

    /// <summary>The value at a pointer; null where there is none.</summary>
    public static JsonNode? Find(JsonNode root, string pointer)
    {
        JsonNode? node = root;
        foreach (string step in Parse(pointer))
        {
            node = Step(node, step);
            if (node is null)
            {
                return null;
            }
        }

        return node;
    }

    /// <summary>The value one step into another; null where there is none.</summary>
    public static JsonNode? Step(JsonNode node, string step) =>
        node.Kind == JsonKind.Array ? Index(step) is var index && index >= 0 && index < node.Items.Count ? node.Items[index] : null : node.Find(step);

    /// <summary>The pointer of a value of a tree; null where it is none.</summary>
    public static string? To(JsonNode root, JsonNode value)
    {
        string pointer = "";
        JsonNode node = root;
        while (!ReferenceEquals(node, value))
        {
            (JsonNode inner, string step)? next = null;
            for (int i = 0; i < node.Items.Count && next is null; i++)
            {
                next = Holds(node.Items[i], value) ? (node.Items[i], i.ToString(CultureInfo.InvariantCulture)) : null;
            }

            next ??= node.Members.Where(m => Holds(m.Value, value)).Select(m => ((JsonNode, string)?)(m.Value, m.Key)).FirstOrDefault();
            if (next is not (JsonNode found, string name))
            {
                return null;
            }

            (node, pointer) = (found, Append(pointer, name));
        }

        return pointer;
    }

    private static bool Holds(JsonNode outer, JsonNode inner) => outer.Start <= inner.Start && inner.End <= outer.End;

    private static string Escape(string step) =>
        step.Replace("~", "~0", StringComparison.Ordinal).Replace("/", "~1", StringComparison.Ordinal);
}
