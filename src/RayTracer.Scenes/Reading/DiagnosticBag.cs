using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Collects what is wrong in one file.</summary>
internal sealed class DiagnosticBag(SourceText source)
{
    // Nobody reads suggestions beyond this, and searching them takes long.
    private const int MostSuggestions = 200;

    /// <summary>The diagnostics so far.</summary>
    public List<Diagnostic> Diagnostics { get; } = [];

    /// <summary>True where words that are unknown still get suggestions.</summary>
    public bool GivesHints => Diagnostics.Count < MostSuggestions;

    public void Error(JsonNode at, string message, DiagnosticRule? rule = null) => Error(at.Start, message, rule);

    public void Error(int at, string message, DiagnosticRule? rule = null) => Diagnostics.Add(source.Error(at, message) with { Rule = rule ?? DiagnosticRule.Content });

    /// <summary>Takes an error, and returns nothing in place of what could not be read.</summary>
    public T? Fail<T>(JsonNode at, string message, DiagnosticRule? rule = null)
    {
        Error(at, message, rule);
        return default;
    }

    /// <summary>Reports a value of another kind, and returns nothing in its place.</summary>
    public T? Expected<T>(JsonNode at, string expected, string key) =>
        Fail<T>(at, $"expected {expected}{(key.Length > 0 ? $" for {Quotation.Of(key)}" : "")}, but found {Describe(at)}", DiagnosticRule.WrongKind);

    /// <summary>Reports a word that is unknown, with the nearest of those that are allowed, or else all of them.</summary>
    public T? Unknown<T>(JsonNode word, string message, IEnumerable<string> candidates, string listTitle = "")
    {
        string hint = GivesHints ? Spelling.DidYouMean(word.Text, candidates) : "";
        string list = hint.Length == 0 && listTitle.Length > 0 ? $": {listTitle} {string.Join(", ", candidates)}" : "";
        return Fail<T>(word, message + hint + list, DiagnosticRule.UnknownWord);
    }

    private static string Describe(JsonNode node) => node.Kind switch
    {
        JsonKind.Object => "an object",
        JsonKind.Array => "an array",
        JsonKind.String => "a string",
        JsonKind.Number => "a number",
        _ => node.Text,
    };
}
