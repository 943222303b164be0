namespace RayTracer.Scenes;

/// <summary>The category of a diagnostic, for tools that count and filter.</summary>
/// <param name="Id">A word of small letters and hyphens, the same in all versions.</param>
/// <param name="Summary">What is wrong.</param>
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
