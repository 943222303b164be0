using System.Globalization;
using System.Text.Json.Nodes;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;
using JsonNode = RayTracer.Scenes.JsonNode;

namespace RayTracer.Session;

/// <summary>
/// Edits of a JSON text by pointer. Each changes only the characters that it is about; what is inserted follows the indentation and
/// style of what stands around it.
/// </summary>
public static class JsonEdit
{
    /// <summary>
    /// Sets or inserts a value; parents that are missing are made. In an array, the step "-" stands for the place behind the last.
    /// </summary>
    /// <exception cref="SessionException">A parent is neither object nor array, or an array has no such place.</exception>
    public static JsonText Set(this JsonText text, string pointer, Json? value)
    {
        string[] steps = JsonPointer.Parse(pointer);
        JsonNode node = text.Root;
        for (int i = 0; i < steps.Length; i++)
        {
            if (JsonPointer.Step(node, steps[i]) is not { } next)
            {
                return text.With(Insert(text, node, JsonPointer.Of(steps[..i]), steps[i], Nest(value, steps[(i + 1)..])));
            }

            node = next;
        }

        return text.With(new TextEdit(node.Start, node.End, Print(text, value, node.Start)));
    }

    /// <summary>As <see cref="Set"/>, with the value as it is to be written.</summary>
    /// <exception cref="SessionException">It is no JSON, or as for <see cref="Set"/>.</exception>
    public static JsonText SetText(this JsonText text, string pointer, string json)
    {
        JsonText value = JsonText.Of(json);
        string written = value.Text[value.Root.Start..value.Root.End];
        if (JsonPointer.Find(text.Root, pointer) is null)
        {
            text = text.Set(pointer, JsonValue.Create(0));
            pointer = pointer.EndsWith("/-", StringComparison.Ordinal) ? LastOf(text, JsonPointer.Parent(pointer)!) : pointer;
        }

        JsonNode node = text.At(pointer);
        return text.With(new TextEdit(node.Start, node.End, written));
    }

    /// <summary>
    /// Removes a member of an object or an element of an array, with its comma, and with its line and the comment behind it where it has
    /// the line for itself.
    /// </summary>
    /// <exception cref="SessionException">There is nothing there, or it is the whole text.</exception>
    public static JsonText Remove(this JsonText text, string pointer)
    {
        (JsonNode container, int index) = Locate(text, pointer);
        string t = text.Text;
        (int start, int end) = Span(container, index);
        int comma = JsonTrivia.Comma(t, end);
        int to = comma < 0 ? end : comma + 1;
        int from = start;
        int lineStart = JsonTrivia.LineStart(t, start);
        int lineEnd = JsonTrivia.BehindComments(t, to);
        int newLine = lineEnd < t.Length ? t.AsSpan(lineEnd).IndexOfAnyExcept(' ', '\t') + lineEnd : -1;
        if (t.AsSpan(lineStart, start - lineStart).IsWhiteSpace() && newLine >= 0 && t[newLine] == '\n')
        {
            (from, to) = (lineStart, newLine + 1);
        }
        else
        {
            bool isLast = index == Count(container) - 1;
            bool isFollowed = !isLast && !t.AsSpan(to, Span(container, index + 1).Start - to).Contains('\n');
            if (isFollowed)
            {
                to = BehindSpaces(t, to);
            }
            else
            {
                while (JsonTrivia.IsSpace(t[from - 1]))
                {
                    from--;
                }

                to = Count(container) == 1 && BehindSpaces(t, to) == container.End - 1 ? container.End - 1 : to;
            }
        }

        List<TextEdit> edits = [new(from, to, "")];
        if (comma < 0 && index > 0)
        {
            int before = JsonTrivia.Comma(t, Span(container, index - 1).End);
            edits.Add(new(before, before + 1, ""));
        }

        return text.With(edits);
    }

    /// <summary>Gives a member of an object another key.</summary>
    /// <exception cref="SessionException">There is no such member, or there is one of the new key already.</exception>
    public static JsonText Rename(this JsonText text, string pointer, string key)
    {
        (JsonNode container, int index) = Locate(text, pointer);
        if (container.Kind != JsonKind.Object)
        {
            throw new SessionException("elements of a list have no key");
        }

        JsonMember member = container.Members[index];
        return member.Key == key ? text
            : container.Find(key) is null ? text.With(new TextEdit(member.Start, member.End, JsonLayout.Quote(key)))
            : throw new SessionException($"there is {JsonLayout.Quote(key)} already");
    }

    /// <summary>Puts a copy of a value behind it, as it is written.</summary>
    /// <param name="text">The text.</param>
    /// <param name="pointer">The value.</param>
    /// <param name="key">The copy's key, where it is a member of an object.</param>
    /// <returns>The text, and the pointer of the copy.</returns>
    /// <exception cref="SessionException">There is no such value, or there is one of the new key already.</exception>
    public static (JsonText Text, string Pointer) Duplicate(this JsonText text, string pointer, string key = "")
    {
        (JsonNode container, int index) = Locate(text, pointer);
        (int start, int end) = Span(container, index);
        string parent = JsonPointer.Parent(pointer)!;
        if (container.Kind == JsonKind.Array)
        {
            return (text.With(InsertBehind(text, container, index, text.Text[start..end])), JsonPointer.Append(parent, index + 1));
        }

        if (container.Find(key) is not null)
        {
            throw new SessionException($"there is {JsonLayout.Quote(key)} already");
        }

        string copy = JsonLayout.Quote(key) + text.Text[container.Members[index].End..end];
        return (text.With(InsertBehind(text, container, index, copy)), JsonPointer.Append(parent, key));
    }

    /// <summary>The pointer of the last element of an array.</summary>
    internal static string LastOf(JsonText text, string pointer) => JsonPointer.Append(pointer, text.At(pointer).Items.Count - 1);

    private static IEnumerable<TextEdit> Insert(JsonText text, JsonNode container, string pointer, string step, Json? value)
    {
        bool fits = container.Kind == JsonKind.Object
            || (container.Kind == JsonKind.Array && (step == "-" || JsonPointer.Index(step) == container.Items.Count));
        if (!fits)
        {
            throw new SessionException($"there is nothing at {JsonLayout.Quote(step)} in {(pointer.Length > 0 ? JsonLayout.Quote(pointer) : "the scene")}");
        }

        string key = container.Kind == JsonKind.Object ? JsonLayout.Quote(step) + ": " : "";
        int count = Count(container);
        if (count > 0)
        {
            int like = Span(container, count - 1).Start;
            return InsertBehind(text, container, count - 1, key + Print(text, value, like, key.Length));
        }

        return [InsertInEmpty(text, container, key, value)];
    }

    private static TextEdit InsertInEmpty(JsonText text, JsonNode container, string key, Json? value)
    {
        string t = text.Text;
        string inside = t[(container.Start + 1)..(container.End - 1)];
        string outer = JsonTrivia.Indent(t, container.Start);
        string inner = outer + JsonTrivia.IndentUnit(text);
        string line = key + JsonLayout.OneLine(value);
        if (inside.Trim(' ', '\t').Length == 0 && container != text.Root && container.Start - JsonTrivia.LineStart(t, container.Start) + line.Length < 110)
        {
            return new(container.Start + 1, container.End - 1, container.Kind == JsonKind.Object ? $" {line} " : line);
        }

        string entry = $"\n{inner}{key}{Layout(text, value, inner, key.Length)}";
        return inside.Contains('\n')
            ? new(container.Start + 1 + inside.TrimEnd().Length, container.Start + 1 + inside.TrimEnd().Length, entry)
            : new(container.End - 1 - (inside.Length - inside.TrimEnd().Length), container.End - 1, $"{entry}\n{outer}");
    }

    private static List<TextEdit> InsertBehind(JsonText text, JsonNode container, int index, string entry)
    {
        string t = text.Text;
        (int start, int end) = Span(container, index);
        int before = index == 0 ? container.Start + 1 : JsonTrivia.Comma(t, Span(container, index - 1).End) + 1;
        bool isOnOwnLine = t.AsSpan(before, start - before).Contains('\n');
        string gap = isOnOwnLine ? "\n" + JsonTrivia.Indent(t, start) : " ";
        int comma = JsonTrivia.Comma(t, end);
        int behind = comma < 0 ? end : comma + 1;
        int at = isOnOwnLine ? JsonTrivia.BehindComments(t, behind) : behind;
        return comma < 0 ? [new(end, end, ","), new(at, at, gap + entry)] : [new(at, at, gap + entry + ",")];
    }

    private static string Print(JsonText text, Json? value, int at, int used = 0) =>
        Layout(text, value, JsonTrivia.Indent(text.Text, at), used + at - JsonTrivia.LineStart(text.Text, at) - JsonTrivia.Indent(text.Text, at).Length);

    // Laid out for a line that begins with that indent, in the text's own units.
    private static string Layout(JsonText text, Json? value, string indent, int used)
    {
        string unit = JsonTrivia.IndentUnit(text);
        string[] lines = JsonLayout.Print(value, 0, used + indent.Length).Split('\n');
        return string.Join('\n', lines.Select((line, i) =>
        {
            string rest = line.TrimStart(' ');
            return i == 0 ? line : indent + string.Concat(Enumerable.Repeat(unit, (line.Length - rest.Length) / 2)) + rest;
        }));
    }

    private static Json? Nest(Json? value, string[] steps)
    {
        // It may be a part of what was sent.
        value = value?.DeepClone();
        foreach (string step in steps.Reverse())
        {
            value = step is "-" or "0" ? new JsonArray(value) : new JsonObject { [step] = value };
        }

        return value;
    }

    private static (JsonNode Container, int Index) Locate(JsonText text, string pointer)
    {
        JsonNode node = text.At(pointer);
        JsonNode container = text.At(JsonPointer.Parent(pointer) ?? throw new SessionException("the whole scene cannot be removed, renamed or copied"));
        int index = 0;
        while (!ReferenceEquals(container.Kind == JsonKind.Array ? container.Items[index] : container.Members[index].Value, node))
        {
            index++;
        }

        return (container, index);
    }

    private static int Count(JsonNode container) => container.Kind == JsonKind.Array ? container.Items.Count : container.Members.Count;

    private static (int Start, int End) Span(JsonNode container, int index) => container.Kind == JsonKind.Array
        ? (container.Items[index].Start, container.Items[index].End)
        : (container.Members[index].Start, container.Members[index].Value.End);

    private static int BehindSpaces(string text, int at)
    {
        while (JsonTrivia.IsSpace(text[at]))
        {
            at++;
        }

        return at;
    }
}

/// <summary>The replacement of a part of a text.</summary>
/// <param name="From">Offset of the part.</param>
/// <param name="To">Offset behind it.</param>
/// <param name="Insert">The text that replaces it.</param>
public readonly record struct TextEdit(int From, int To, string Insert);
