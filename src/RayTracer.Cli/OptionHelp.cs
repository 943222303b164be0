namespace RayTracer.Cli;

/// <summary>An option of a verb, as help pages and shells see it.</summary>
/// <param name="Names">The names, the long one first.</param>
/// <param name="Form">The form of its value; null where it has none.</param>
/// <param name="Summary">The meaning.</param>
/// <param name="IsRepeatable">True if it may be given several times.</param>
internal sealed record OptionHelp(IReadOnlyList<string> Names, string? Form, string Summary, bool IsRepeatable)
{
    /// <summary>The words that its value is one of; empty where it is something else.</summary>
    public IReadOnlyList<string> Choices { get; } = WordsOf(Form ?? "");

    /// <summary>True if its value is the name of a file or folder.</summary>
    public bool TakesFile => Form is "FILE" or "SCENE" or "FOLDER" or "IMAGE";

    /// <summary>
    /// The words that a value is one of, by its form: <c>full|half</c>. Words that begin with a capital letter stand for something else, as
    /// in <c>N|A..B</c>.
    /// </summary>
    public static IReadOnlyList<string> WordsOf(string form) =>
        form.Split('|') is { Length: > 1 } words && !Array.Exists(words, w => char.IsAsciiLetterUpper(w[0])) ? words : [];
}
