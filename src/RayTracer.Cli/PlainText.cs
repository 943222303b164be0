namespace RayTracer.Cli;

/// <summary>Texts of files that may be anybody's, for a terminal.</summary>
internal static class PlainText
{
    /// <summary>A text on one line, without signs that a terminal would obey.</summary>
    public static string Of(string text) =>
        string.Concat(text.Select(c => c == '\n' ? "\\n" : char.IsControl(c) ? $"\\u{(int)c:X4}" : c.ToString()));
}
