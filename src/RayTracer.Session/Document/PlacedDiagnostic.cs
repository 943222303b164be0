using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>A diagnostic and the part of the text that it is about.</summary>
/// <param name="Line">The line, from 1; 0 where it is about no place.</param>
/// <param name="Column">The column, from 1; 0 where it is about no place.</param>
/// <param name="From">Offset of the part's first character.</param>
/// <param name="To">Offset behind its last character.</param>
/// <param name="Severity">"error", "warning" or "note".</param>
/// <param name="Message">The fault: one sentence without a final stop.</param>
public sealed record PlacedDiagnostic(int Line, int Column, int From, int To, string Severity, string Message)
{
    /// <summary>
    /// Finds the parts of a text that its diagnostics are about: a word, a number, a string; of objects and arrays the opening bracket.
    /// </summary>
    public static IReadOnlyList<PlacedDiagnostic> Of(SceneReadResult read, IReadOnlyList<Diagnostic> diagnostics) => [.. diagnostics.Select(d =>
    {
        string text = read.Source?.Text ?? "";
        int from = d.Line > 0 ? Math.Min(read.Source!.Offset(d.Line, d.Column), text.Length) : 0;
        int to = d.Line > 0 ? EndOfWord(text, from) : 0;
        return new PlacedDiagnostic(d.Line, d.Column, from, to, d.Severity.ToString().ToLowerInvariant(), d.Message);
    })];

    private static int EndOfWord(string text, int from)
    {
        if (from == text.Length || text[from] is '\n' or '\r')
        {
            return from;
        }

        int to = from + 1;
        if (text[from] == '"')
        {
            while (to < text.Length && text[to] is not ('"' or '\n' or '\r'))
            {
                to += text[to] == '\\' ? 2 : 1;
            }

            return Math.Min(to + 1, text.Length);
        }

        while (char.IsLetterOrDigit(text[from]) && to < text.Length && (char.IsLetterOrDigit(text[to]) || text[to] is '.' or '-' or '+' or '_'))
        {
            to++;
        }

        return to;
    }
}
