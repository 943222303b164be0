using System.Net;
using System.Text.RegularExpressions;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>
/// Works are cited in comments by surname and year; the page of references has an entry "- **Surname … year**" for each. Standards are cited by number.
/// </summary>
public partial class ReferencesTests
{
    // How far before its year a citation may begin: authors, a title, and where it appeared.
    private const int LongestCitation = 240;
    private static readonly string s_page = File.ReadAllText(ProjectFolder.PathOf("docs", "references.md"));
    private static readonly (string Surname, string Year)[] s_entries = [.. Entry().Matches(s_page).Select(m => (m.Groups["surname"].Value, m.Groups["year"].Value))];

    [Fact]
    public void Every_work_that_a_comment_cites_is_in_the_references()
    {
        var cited = Comments().SelectMany(c => Year().Matches(c.Text).Select(m => (c.File, Year: m.Value, Before: Before(c.Text, m.Index)))).ToArray();
        Assert.True(cited.Length > 20, "citations are not found");
        string[] missing = [.. cited.Where(c => !IsListed(c.Before, c.Year)).Select(c => $"{c.File}: no entry of {c.Year} for: {c.Before}{c.Year}")];
        Assert.True(missing.Length == 0, string.Join('\n', missing));
    }

    [Fact]
    public void Every_standard_that_a_comment_names_is_in_the_references()
    {
        var named = Comments().SelectMany(c => Standard().Matches(c.Text).Select(m => (c.File, m.Value))).ToArray();
        Assert.True(named.Length > 5, "standards are not found");
        string[] missing = [.. named.Where(n => !s_page.Contains(n.Value, StringComparison.Ordinal)).Select(n => $"{n.File}: {n.Value}")];
        Assert.True(missing.Length == 0, string.Join('\n', missing));
    }

    [Theory]
    [InlineData("The map is area-preserving (Shirley & Chiu 1997).", true)]
    [InlineData("Shirley and Chiu, A low distortion map (1997), eq. 1", true)]
    [InlineData("The map is area-preserving (Shirley & Chiu 1998).", false)]
    [InlineData("The map is area-preserving (Nobody 1997).", false)]
    public void A_citation_is_listed_only_with_its_surname_and_its_year(string comment, bool expected)
    {
        Match year = Assert.Single(Year().Matches(comment));
        Assert.Equal(expected, IsListed(Before(comment, year.Index), year.Value));
    }

    private static bool IsListed(string before, string year) =>
        s_entries.Any(e => e.Year == year && Regex.IsMatch(before, $@"\b{Regex.Escape(e.Surname)}\b", RegexOptions.None, TimeSpan.FromSeconds(1)));

    private static string Before(string text, int index) => text[Math.Max(0, index - LongestCitation)..index];

    private static IEnumerable<string> SourceFiles() => new[] { "src", "tests" }
        .SelectMany(folder => Directory.EnumerateFiles(ProjectFolder.PathOf(folder), "*.cs", SearchOption.AllDirectories))
        .Where(p => !BuildOutput().IsMatch(p) && !p.EndsWith($"{nameof(ReferencesTests)}.cs", StringComparison.Ordinal));

    // Runs of comment lines, each as one text without slashes and tags.
    private static IEnumerable<(string File, string Text)> Comments()
    {
        foreach (string path in SourceFiles())
        {
            string file = Path.GetRelativePath(ProjectFolder.Root, path);
            List<string> run = [];
            foreach (string line in File.ReadLines(path).Append(""))
            {
                Match comment = Comment().Match(line);
                if (comment.Success)
                {
                    run.Add(comment.Groups["text"].Value.Trim());
                }
                else if (run.Count > 0)
                {
                    yield return (file, WebUtility.HtmlDecode(Tag().Replace(string.Join(' ', run), "")));
                    run.Clear();
                }
            }
        }
    }

    [GeneratedRegex(@"^- \*\*(van )?(?<surname>[\p{Lu}]\p{L}+)[^*]* (?<year>\d{4})\*\*", RegexOptions.Multiline | RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Entry();

    [GeneratedRegex(@"(?<![\d.,\-]|RFC )\b(1[89]\d\d|20[0-2]\d)\b(?![-.]?\d)", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Year();

    [GeneratedRegex(@"RFC \d+|IEC \d[\d-]*\d|ITU-R BT\.\d+-\d+|ITU-T T\.\d+|IEEE \d+|W3C PNG|CSS Color Module Level \d|ISO C\b|OpenEXR File Layout|draft 20\d\d-\d\d|portable float map", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Standard();

    [GeneratedRegex(@"(?<![:""])//+(?<text>.*)$", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Comment();

    [GeneratedRegex(@"</?\w+[^>]*>", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Tag();

    [GeneratedRegex(@"[/\\](bin|obj)[/\\]", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex BuildOutput();
}
