using System.Text;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// A JSON text, with comments and trailing commas, and its tree. It never changes: <see cref="JsonEdit"/> makes others of it.
/// </summary>
public sealed class JsonText
{
    private JsonText(string text, JsonNode root)
    {
        Text = text;
        Root = root;
    }

    /// <summary>The text.</summary>
    public string Text { get; }

    /// <summary>The tree, with places in <see cref="Text"/>.</summary>
    public JsonNode Root { get; }

    /// <summary>Parses a text.</summary>
    /// <exception cref="SessionException">It is no JSON.</exception>
    public static JsonText Of(string text)
    {
        List<Diagnostic> diagnostics = [];
        SourceText source = new("", text);
        return JsonParser.Parse(source, diagnostics) is { } root ? new(source.Text, root) : throw Fault(diagnostics);
    }

    /// <summary>The text and tree that a reader has parsed.</summary>
    /// <exception cref="SessionException">It is no JSON.</exception>
    public static JsonText Of(SceneReadResult read) =>
        read is { Root: { } root, Source: { } source } ? new(source.Text, root) : throw Fault(read.Diagnostics);

    /// <summary>The text with some parts changed.</summary>
    /// <param name="edits">Changes that do not overlap; of two at the same place, the first one comes first.</param>
    public JsonText With(params IEnumerable<TextEdit> edits)
    {
        StringBuilder text = new();
        int at = 0;
        foreach (TextEdit edit in edits.OrderBy(e => e.From))
        {
            text.Append(Text, at, edit.From - at).Append(edit.Insert);
            at = edit.To;
        }

        return Of(text.Append(Text, at, Text.Length - at).ToString());
    }

    /// <summary>The value at a pointer.</summary>
    /// <exception cref="SessionException">There is none.</exception>
    public JsonNode At(string pointer) =>
        JsonPointer.Find(Root, pointer) ?? throw new SessionException($"there is nothing at {JsonLayout.Quote(pointer)}");

    private static SessionException Fault(IReadOnlyList<Diagnostic> diagnostics)
    {
        Diagnostic? first = diagnostics.FirstOrDefault(d => d.Severity == Severity.Error);
        return new($"first correct the text: line {first?.Line ?? 1}, column {first?.Column ?? 1}: {first?.Message ?? "it is no JSON"}");
    }
}
