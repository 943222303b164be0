using System.Globalization;
using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>
/// How people write where in a scene a property stands: <c>camera.position</c>, <c>shapes[2].radius</c>, <c>shapes.ball.center[1]</c>, <c>materials["my glass"].refractiveIndex</c>.
/// Keys and names in which <c>.</c>, <c>[</c>, <c>]</c>, <c>=</c> or <c>"</c> occur stand in brackets and double quotes.
/// </summary>
internal sealed class PropertyPath
{
    private static readonly System.Buffers.SearchValues<char> Signs = System.Buffers.SearchValues.Create(".[]=\"");

    private readonly string _text;
    private readonly List<PathStep> _steps = [];

    private PropertyPath(string text) => _text = text;

    /// <summary>The path as it is written; the whole text where it is none.</summary>
    public string Text => Complaint is null ? _text[..End] : _text;

    /// <summary>Its keys, names and numbers.</summary>
    public IReadOnlyList<PathStep> Steps => _steps;

    /// <summary>The end of the path in the text that it was read from.</summary>
    public int End { get; private set; }

    /// <summary>The complaint about the text; null where it is a path.</summary>
    public string? Complaint { get; private set; }

    private char? Next => End < _text.Length ? _text[End] : null;

    /// <summary>Reads a path.</summary>
    /// <param name="text">A text that begins with it.</param>
    /// <param name="behind">The sign that must stand behind it; null for the end of the text.</param>
    public static PropertyPath Read(string text, char? behind = null)
    {
        PropertyPath path = new(text);
        do
        {
            path.End += path.Next == '.' && path._steps.Count > 0 ? 1 : 0;
            path.Complaint = path.Next == '[' ? path.Bracket() : path.Key();
        }
        while (path.Complaint is null && path.Next is '.' or '[');
        path.Complaint ??= path.Next == behind ? null : path.Expected(path.End, path.Next is null ? $"\"{behind}\" and a value" : "\".\" or \"[\"");
        return path;
    }

    /// <summary>A key or name as it is written in a path.</summary>
    /// <param name="word">The key or name.</param>
    /// <param name="isFirst">True where the path begins with it.</param>
    public static string Word(string word, bool isFirst) =>
        word.Length == 0 || word.AsSpan().ContainsAny(Signs) || word.All(char.IsAsciiDigit) ? $"[\"{word}\"]" : isFirst ? word : $".{word}";

    private string? Key()
    {
        int length = _text.AsSpan(End).IndexOfAny(Signs);
        int end = length < 0 ? _text.Length : End + length;
        return end > End ? Add(_text[End..end], null, end) : Expected(End, "a key");
    }

    private string? Bracket()
    {
        bool isQuoted = _text.AsSpan(End).StartsWith("[\"");
        int first = End + (isQuoted ? 2 : 1);
        int end = _text.IndexOf(isQuoted ? "\"]" : "]", first, StringComparison.Ordinal);
        if (end < 0)
        {
            return Expected(_text.Length, "\"]\"");
        }

        string key = _text[first..end];
        return isQuoted ? Add(key, null, end + 2)
            : key.Length == 0 || !key.All(char.IsAsciiDigit) ? Expected(first, "the number of an element from 0, or a name in double quotes,")
            : Add(key, int.TryParse(key, NumberStyles.None, CultureInfo.InvariantCulture, out int index) ? index : int.MaxValue, end + 1);
    }

    private string? Add(string key, int? index, int end)
    {
        _steps.Add(new(key, index, End, end));
        End = end;
        return null;
    }

    private string Expected(int at, string what) => $"expected {what} at column {at + 1}, but found {(at < _text.Length ? Quotation.Of(_text[at..(at + 1)]) : "the end")}";
}

/// <summary>One step of a <see cref="PropertyPath"/>.</summary>
/// <param name="Key">The key or name; the digits of a number.</param>
/// <param name="Index">The number of an element in brackets, from 0; null for a key or name.</param>
/// <param name="Start">The offset of its first character in the path's text.</param>
/// <param name="End">The offset behind its last character.</param>
internal readonly record struct PathStep(string Key, int? Index, int Start, int End);
