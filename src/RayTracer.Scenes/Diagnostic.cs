namespace RayTracer.Scenes;

/// <summary>The severity of a diagnostic.</summary>
public enum Severity
{
    /// <summary>The scene cannot be rendered.</summary>
    Error,

    /// <summary>The scene can be rendered, but probably not as its author meant it.</summary>
    Warning,

    /// <summary>The scene is rendered as it is meant to be, with something made up that its file does not say.</summary>
    Note,
}

/// <summary>Something to say about a file, as compilers say it.</summary>
/// <param name="File">The file, as its user named it; or the option of the command that gave what is wrong.</param>
/// <param name="Line">The line, from 1; 0 where the message is about no place in the file, or about an option.</param>
/// <param name="Column">The column, from 1, in UTF-16 units; 0 where there is no place.</param>
/// <param name="Severity">The severity.</param>
/// <param name="Message">The fault and what was expected: one sentence without a final stop.</param>
public sealed record Diagnostic(string File, int Line, int Column, Severity Severity, string Message)
{
    /// <summary>The category of the diagnostic.</summary>
    public DiagnosticRule Rule { get; init; } = DiagnosticRule.Content;

    /// <summary>Sorts by position, those without one first; equal ones are given once.</summary>
    public static IReadOnlyList<Diagnostic> Sort(IEnumerable<Diagnostic> diagnostics) =>
        [.. diagnostics.Distinct().OrderBy(d => d.Line).ThenBy(d => d.Column)];

    /// <summary>One diagnostic a line, at most <paramref name="limit"/> of them, then how many more there are.</summary>
    /// <param name="diagnostics">The diagnostics in the order to show.</param>
    /// <param name="limit">The number of diagnostics shown at most.</param>
    public static string Format(IReadOnlyList<Diagnostic> diagnostics, int limit = 20)
    {
        IEnumerable<string> lines = diagnostics.Take(limit).Select(d => d.ToString());
        return string.Join('\n', diagnostics.Count > limit ? lines.Append($"and {diagnostics.Count - limit} more") : lines);
    }

    /// <summary>As compilers write it: <c>scene.json:12:17: error: …</c></summary>
    public override string ToString()
    {
        string place = Line > 0 ? $"{File}:{Line}:{Column}" : Column > 0 ? $"{File}, column {Column}" : File;
        return $"{place}: {Severity.ToString().ToLowerInvariant()}: {Message}";
    }
}

/// <summary>The category of a diagnostic, for tools that count and filter.</summary>
/// <param name="Id">A word of small letters and hyphens, the same in all versions.</param>
/// <param name="Summary">The fault, in one sentence.</param>
public sealed record DiagnosticRule(string Id, string Summary)
{
    /// <summary>The file cannot be opened or decoded.</summary>
    public static DiagnosticRule Unreadable { get; } = new("unreadable-file", "The file cannot be read.");

    /// <summary>It is no JSON.</summary>
    public static DiagnosticRule Syntax { get; } = new("syntax", "The text is not JSON with comments and trailing commas.");

    /// <summary>A key, type, name or word that does not exist.</summary>
    public static DiagnosticRule UnknownWord { get; } = new("unknown-word", "A key, type, name or word is unknown.");

    /// <summary>A value of another kind than is expected.</summary>
    public static DiagnosticRule WrongKind { get; } = new("wrong-kind", "A value is not of the expected kind.");

    /// <summary>A number outside of its range.</summary>
    public static DiagnosticRule OutOfRange { get; } = new("out-of-range", "A number is outside its range.");

    /// <summary>A value that must be there.</summary>
    public static DiagnosticRule Missing { get; } = new("missing-value", "A required value is missing.");

    /// <summary>Anything else that is wrong with a value, or with how values go together.</summary>
    public static DiagnosticRule Content { get; } = new("content", "Something in the scene is impossible or probably not intended.");

    /// <summary>All of them.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [Unreadable, Syntax, UnknownWord, WrongKind, OutOfRange, Missing, Content];
}
