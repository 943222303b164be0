using System.Reflection;
using System.Text;
using System.Text.RegularExpressions;
using Markdig;
using Markdig.Extensions.Tables;
using Markdig.Renderers;
using Markdig.Renderers.Html;
using Markdig.Syntax;
using Markdig.Syntax.Inlines;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// The documentation, which is within the program: it is read and searched without a connection. Its order and groups are those of the tables in README.md.
/// </summary>
public sealed partial class HelpPages : ISessionPart<HelpPages>
{
    private const string Prefix = "help/";
    private const string Folder = "docs/";
    private const string Lessons = "primer/";
    private const string Change = "try:";
    private const int MostFindings = 40;
    private const int ExcerptLength = 180;
    private const int InHeading = 8;
    private const int InTitle = 4;
    private const int MostCounted = 8;

    private static readonly MarkdownPipeline s_markdown = new MarkdownPipelineBuilder().UsePipeTables().UseAutoIdentifiers(Markdig.Extensions.AutoIdentifiers.AutoIdentifierOptions.GitHub).DisableHtml().Build();

    private readonly Dictionary<string, Text> _texts = new(StringComparer.Ordinal);

    /// <summary>Reads the pages.</summary>
    public HelpPages()
    {
        foreach (string name in Files.GetManifestResourceNames())
        {
            if (name.StartsWith(Prefix, StringComparison.Ordinal) && name.EndsWith(".md", StringComparison.Ordinal))
            {
                string id = name[Prefix.Length..^3].Replace('\\', '/');
                using StreamReader reader = new(Files.GetManifestResourceStream(name)!);
                _texts[id] = Text.Read(id, Markdown.Parse(reader.ReadToEnd(), s_markdown), _texts.ContainsKey);
            }
        }

        Pages = [.. Order()];
    }

    /// <summary>All pages, in the order of README.md, the lessons after the page that lists them, in its order.</summary>
    public IReadOnlyList<HelpEntry> Pages { get; }

    private static Assembly Files => typeof(HelpPages).Assembly;

    static HelpPages ISessionPart<HelpPages>.Of(StudioSession session) => new();

    /// <summary>A page as HTML without scripts or foreign markup.</summary>
    /// <param name="id">Which page.</param>
    /// <exception cref="SessionException">There is no such page.</exception>
    public HelpPage Page(string id) => new(id, TextOf(id).Title, TextOf(id).Html.Value);

    /// <summary>A picture of a page.</summary>
    /// <param name="path">Its path below the folder of the documentation.</param>
    /// <exception cref="SessionException">There is no such picture.</exception>
    public static Stream Picture(string path) => Files.GetManifestResourceStream(Prefix + path) is { } found && !path.EndsWith(".md", StringComparison.Ordinal)
        ? found
        : throw new SessionException($"the help has no picture {JsonLayout.Quote(path)}", SessionFault.Missing);

    /// <summary>The sections that have all words, or words that begin with them: those with them in their headings first.</summary>
    /// <param name="words">The words, separated by spaces; case does not matter.</param>
    public IReadOnlyList<HelpFinding> Find(string words)
    {
        string[] wanted = words.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
        return wanted.Length == 0 ? [] : [.. Pages
            .SelectMany(page => _texts[page.Id].Sections.Select(section => (page, section, rank: section.Rank(page.Title, wanted))))
            .Where(found => found.rank > 0)
            .OrderByDescending(found => found.rank)
            .Take(MostFindings)
            .Select(found => new HelpFinding(found.page.Id, found.page.Title, found.section.Heading, found.section.Anchor, found.section.Excerpt(wanted)))];
    }

    private Text TextOf(string id) =>
        _texts.TryGetValue(id, out Text? text) ? text : throw new SessionException($"the help has no page {JsonLayout.Quote(id)}", SessionFault.Missing);

    // README.md lists the pages in tables, each under the heading of its group: a link, and what is behind it.
    private IEnumerable<HelpEntry> Order()
    {
        using StreamReader reader = new(Files.GetManifestResourceStream(Prefix + "README.txt")!);
        string group = "";
        foreach (Block block in Markdown.Parse(reader.ReadToEnd(), s_markdown))
        {
            group = block is HeadingBlock heading ? Plain(heading) : group;
            foreach (TableRow row in (block as Table ?? []).OfType<TableRow>().Where(row => row.Count == 2))
            {
                if (row.Descendants<LinkInline>().FirstOrDefault()?.Url is not { } url || !url.StartsWith(Folder, StringComparison.Ordinal) || !_texts.ContainsKey(url[Folder.Length..^3]))
                {
                    continue;
                }

                string id = url[Folder.Length..^3];
                yield return new(id, _texts[id].Title, group, Plain(row[1]));
                foreach (string lesson in id == Lessons + "README" ? _texts[id].Rows.Select(row => Lessons + row) : [])
                {
                    yield return new(lesson, _texts[lesson].Title, _texts[id].Title, "");
                }
            }
        }
    }

    private static string Plain(MarkdownObject block)
    {
        StringBuilder plain = new();
        foreach (MarkdownObject part in block is LeafBlock { Inline: { } inlines } ? inlines.Descendants() : block.Descendants())
        {
            plain.Append(part switch
            {
                LiteralInline literal => literal.Content.ToString(),
                CodeInline code => code.Content,
                LineBreakInline => " ",
                CodeBlock code => code.Lines.ToString() + " ",
                LeafBlock when plain.Length > 0 => " ",
                _ => "",
            });
        }

        return block is CodeBlock own ? own.Lines.ToString() : Spaces.Replace(plain.ToString(), " ").Trim();
    }

    [GeneratedRegex(@"\s+")]
    private static partial Regex Spaces { get; }

    // Rows: the pages that rows of its tables lead to first, without extension.
    private sealed record Text(string Title, IReadOnlyList<Section> Sections, IReadOnlyList<string> Rows, Lazy<string> Html)
    {
        public static Text Read(string id, MarkdownDocument document, Func<string, bool> isPage)
        {
            List<Section> sections = [];
            StringBuilder body = new();
            (string heading, string anchor) = ("", "");
            foreach (Block block in document)
            {
                if (block is HeadingBlock next)
                {
                    Close();
                    (heading, anchor) = (Plain(next), next.GetAttributes().Id ?? "");
                }
                else
                {
                    body.Append(Plain(block)).Append(' ');
                }
            }

            Close();
            IEnumerable<string?> rows = document.OfType<Table>().SelectMany(table => table.OfType<TableRow>()).Select(row => row.Descendants<LinkInline>().FirstOrDefault()?.Url);
            return new(
                sections.Count > 0 ? sections[0].Heading : id, sections, [.. rows.OfType<string>().Where(url => url.EndsWith(".md", StringComparison.Ordinal)).Select(url => url[..^3])],
                new(() => Write(id, document, isPage)));

            void Close()
            {
                if (heading.Length > 0)
                {
                    sections.Add(new(heading, anchor, body.ToString()));
                }

                body.Clear();
            }
        }

        // The pages' links are those of the repository's folders; here they become addresses that the window understands.
        private static string Write(string id, MarkdownDocument document, Func<string, bool> isPage)
        {
            foreach (LinkInline link in document.Descendants<LinkInline>().ToArray())
            {
                string url = link.Url ?? "";
                if (url.Contains("://", StringComparison.Ordinal) || url.StartsWith(Change, StringComparison.Ordinal))
                {
                    continue;
                }

                // Anchors are those of GitHub, in small letters.
                int mark = url.IndexOf('#', StringComparison.Ordinal);
                string anchor = mark < 0 ? "" : url[(mark + 1)..].ToLowerInvariant();
                string path = new Uri(new Uri($"file:///docs/{id}.md"), mark < 0 ? url : url[..mark]).AbsolutePath.TrimStart('/');
                string page = path.StartsWith(Folder, StringComparison.Ordinal) ? path[Folder.Length..] : "";
                if (link.IsImage && Files.GetManifestResourceInfo(Prefix + page) is null)
                {
                    link.Remove();
                }
                else if (link.IsImage)
                {
                    link.Url = null;
                    link.GetAttributes().AddProperty("data-picture", page);
                }
                else if (mark == 0)
                {
                    link.Url = "#" + anchor;
                }
                else
                {
                    link.Url = page.EndsWith(".md", StringComparison.Ordinal) && isPage(page[..^3])
                        ? $"#help={page[..^3]}{(anchor.Length > 0 ? "&section=" + anchor : "")}"
                        : $"#file={path}";
                }
            }

            using StringWriter html = new();
            HtmlRenderer renderer = new(html);
            s_markdown.Setup(renderer);
            renderer.Render(document);
            return html.ToString();
        }
    }

    private sealed record Section(string Heading, string Anchor, string Body)
    {
        // Headings count most, then how often a word comes; the page's title alone finds no section. A section that lacks one of the words is no finding.
        public int Rank(string title, string[] words)
        {
            int rank = 0;
            foreach (string word in words)
            {
                int found = (Count(Heading, word) > 0 ? InHeading : 0) + Math.Min(Count(Body, word), MostCounted);
                if (found == 0)
                {
                    return 0;
                }

                rank += found + (Count(title, word) > 0 ? InTitle : 0);
            }

            return rank;
        }

        public string Excerpt(string[] words)
        {
            int at = Math.Max(0, words.Select(word => Where(Body, word, 0)).Where(i => i >= 0).DefaultIfEmpty(0).Min() - 40);
            at = at == 0 ? 0 : Body.IndexOf(' ', at) + 1;
            return (at > 0 ? "… " : "") + (Body.Length - at > ExcerptLength ? Body.AsSpan(at, ExcerptLength).TrimEnd().ToString() + " …" : Body[at..].TrimEnd());
        }

        private static int Count(string text, string word)
        {
            int count = 0;
            for (int at = Where(text, word, 0); at >= 0; at = Where(text, word, at + word.Length))
            {
                count++;
            }

            return count;
        }

        // Where a word begins that begins so.
        private static int Where(string text, string word, int from)
        {
            for (int at = text.IndexOf(word, from, StringComparison.OrdinalIgnoreCase); at >= 0; at = text.IndexOf(word, at + 1, StringComparison.OrdinalIgnoreCase))
            {
                if (at == 0 || !char.IsLetterOrDigit(text[at - 1]) || !char.IsLetterOrDigit(word[0]))
                {
                    return at;
                }
            }

            return -1;
        }
    }
}

/// <summary>A page in the list of the documentation.</summary>
/// <param name="Id">The identifier: its path without extension.</param>
/// <param name="Title">Its heading.</param>
/// <param name="Group">For whom it is, or the page that it belongs to.</param>
/// <param name="Summary">What is on it; empty for lessons.</param>
public sealed record HelpEntry(string Id, string Title, string Group, string Summary);

/// <summary>A page.</summary>
/// <param name="Id">The identifier.</param>
/// <param name="Title">Its heading.</param>
/// <param name="Html">
/// The page as HTML. Links to pages are <c>#help=ID&amp;section=ANCHOR</c>, those to files of the repository <c>#file=PATH</c>; pictures name themselves in <c>data-picture</c>.
/// Changes that a lesson proposes are <c>try:POINTER=VALUE</c>: JSON pointers without their first slash and JSON, percent-encoded, several of them joined by semicolons.
/// </param>
public sealed record HelpPage(string Id, string Title, string Html);

/// <summary>A section that was found.</summary>
/// <param name="Page">The page's identifier.</param>
/// <param name="Title">The page's heading.</param>
/// <param name="Section">The section's heading.</param>
/// <param name="Anchor">The section's anchor.</param>
/// <param name="Excerpt">The text around the first word.</param>
public sealed record HelpFinding(string Page, string Title, string Section, string Anchor, string Excerpt);
