using System.Globalization;

namespace RayTracer.Scenes;

/// <summary>The kinds of JSON values.</summary>
public enum JsonKind
{
    /// <summary>Keys and values in braces.</summary>
    Object,

    /// <summary>Values in brackets.</summary>
    Array,

    /// <summary>Text in double quotes.</summary>
    String,

    /// <summary>A number.</summary>
    Number,

    /// <summary>true or false.</summary>
    Boolean,

    /// <summary>null.</summary>
    Null,
}

/// <summary>A value of a JSON text, and where it stands.</summary>
public sealed class JsonNode
{
    internal JsonNode(JsonKind kind, int start, int end, string text = "")
    {
        Kind = kind;
        Start = start;
        End = end;
        Text = text;
    }

    /// <summary>The kind of the value.</summary>
    public JsonKind Kind { get; }

    /// <summary>Offset of the value's first character in the text, in UTF-16 units.</summary>
    public int Start { get; }

    /// <summary>Offset behind the value's last character.</summary>
    public int End { get; }

    /// <summary>A string's text with its escapes resolved; a number or word as it is written; otherwise empty.</summary>
    public string Text { get; }

    /// <summary>The elements of an array; otherwise empty.</summary>
    public IReadOnlyList<JsonNode> Items { get; internal init; } = [];

    /// <summary>The members of an object in their order, those of doubled keys included; otherwise empty.</summary>
    public IReadOnlyList<JsonMember> Members { get; internal init; } = [];

    /// <summary>The nearest float to a number; null for other values.</summary>
    public float? Number => Kind == JsonKind.Number ? float.Parse(Text, NumberStyles.Float, CultureInfo.InvariantCulture) : null;

    /// <summary>The value of the first member of that key; null where there is none.</summary>
    public JsonNode? Find(string key)
    {
        foreach (JsonMember member in Members)
        {
            if (member.Key == key)
            {
                return member.Value;
            }
        }

        return null;
    }
}

/// <summary>A key of an object and its value.</summary>
/// <param name="Key">The key, with its escapes resolved.</param>
/// <param name="Start">Offset of the key's opening quote.</param>
/// <param name="End">Offset behind the key's closing quote.</param>
/// <param name="Value">The value.</param>
public sealed record JsonMember(string Key, int Start, int End, JsonNode Value);
