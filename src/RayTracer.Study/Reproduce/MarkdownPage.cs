namespace RayTracer.Study;

/// <summary>Writes Markdown, with tables as on GitHub.</summary>
internal sealed class MarkdownPage : PageWriter
{
    private const string Special = "\\`*_[]<>|#&~$";

    /// <summary>Begins a page.</summary>
    public MarkdownPage(string title) => Content.Append($"# {Escape(title)}\n");

    /// <inheritdoc/>
    public override void Heading(string text) => Content.Append($"\n## {Escape(text)}\n");

    /// <inheritdoc/>
    public override void Paragraph(string text) => Content.Append($"\n{Escape(text)}\n");

    /// <inheritdoc/>
    public override void Table(IReadOnlyList<string> header, IEnumerable<IReadOnlyList<string>> rows)
    {
        Content.Append('\n');
        Row(header.Select(Escape));
        Row(header.Select((_, column) => column == 0 ? "---" : "---:"));
        foreach (IReadOnlyList<string> row in rows)
        {
            Row(row.Select(Escape));
        }
    }

    /// <inheritdoc/>
    public override void Picture(string file, string caption) => Content.Append($"\n![{Escape(caption)}]({file})\n\n{Escape(caption)}\n");

    /// <inheritdoc/>
    public override string Finish() => Content.ToString();

    private static string Escape(string text) =>
        string.Concat(text.ReplaceLineEndings(" ").Select(c => Special.Contains(c, StringComparison.Ordinal) ? $"\\{c}" : c.ToString()));

    private void Row(IEnumerable<string> cells) => Content.Append($"| {string.Join(" | ", cells)} |\n");
}
