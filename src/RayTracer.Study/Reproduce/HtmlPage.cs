using System.Net;

namespace RayTracer.Study;

/// <summary>Writes HTML that needs nothing but the pictures beside it.</summary>
internal sealed class HtmlPage : PageWriter
{
    private const string Style = """
        body { max-width: 66rem; margin: 2rem auto; padding: 0 1rem; font: 1rem/1.5 system-ui, sans-serif; color: #222; background: #fff; }
        table { border-collapse: collapse; font-size: .9rem; }
        th, td { padding: .25rem .7rem; border-bottom: 1px solid #ddd; text-align: right; }
        th:first-child, td:first-child { text-align: left; }
        figure { display: inline-block; margin: 0 1rem 1rem 0; vertical-align: top; max-width: 100%; }
        figcaption { max-width: 20rem; font-size: .9rem; }
        img { max-width: 100%; }
        img[src$=".png"] { width: 20rem; }
        """;

    /// <summary>Begins a page.</summary>
    public HtmlPage(string title)
    {
        string escaped = Escape(title);
        Content.Append($"<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{escaped}</title>\n<style>\n{Style}\n</style>\n</head>\n<body>\n<h1>{escaped}</h1>\n");
    }

    /// <inheritdoc/>
    public override void Heading(string text) => Content.Append($"<h2>{Escape(text)}</h2>\n");

    /// <inheritdoc/>
    public override void Paragraph(string text) => Content.Append($"<p>{Escape(text)}</p>\n");

    /// <inheritdoc/>
    public override void Table(IReadOnlyList<string> header, IEnumerable<IReadOnlyList<string>> rows)
    {
        Content.Append("<table>\n");
        Row(header, "th");
        foreach (IReadOnlyList<string> row in rows)
        {
            Row(row, "td");
        }

        Content.Append("</table>\n");
    }

    /// <inheritdoc/>
    public override void Picture(string file, string caption)
    {
        string escaped = Escape(caption);
        Content.Append($"<figure><img src=\"{Escape(file)}\" alt=\"{escaped}\"><figcaption>{escaped}</figcaption></figure>\n");
    }

    /// <inheritdoc/>
    public override string Finish() => $"{Content}</body>\n</html>\n";

    private static string Escape(string text) => WebUtility.HtmlEncode(text);

    private void Row(IEnumerable<string> cells, string tag) =>
        Content.Append($"<tr>{string.Concat(cells.Select(c => $"<{tag}>{Escape(c)}</{tag}>"))}</tr>\n");
}
