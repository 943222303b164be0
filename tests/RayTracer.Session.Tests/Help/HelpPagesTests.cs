using System.Text.RegularExpressions;

namespace RayTracer.Session.Tests;

public sealed partial class HelpPagesTests
{
    private static readonly HelpPages s_help = new();

    public static TheoryData<string> Pages => new(s_help.Pages.Select(p => p.Id));

    [Fact]
    public void Every_page_that_is_shipped_is_listed_once()
    {
        string[] listed = [.. s_help.Pages.Select(p => p.Id)];
        IEnumerable<string> shipped = typeof(HelpPages).Assembly.GetManifestResourceNames()
            .Where(n => n.StartsWith("help/", StringComparison.Ordinal) && n.EndsWith(".md", StringComparison.Ordinal))
            .Select(n => n["help/".Length..^3]);
        Assert.Equal(shipped.Order(StringComparer.Ordinal), listed.Order(StringComparer.Ordinal));
        Assert.Contains("I want to render", s_help.Pages.Select(p => p.Group));
        Assert.Equal(["primer/01-sphere", "primer/02-light"], listed.SkipWhile(id => id != "primer/README").Skip(1).Take(2));
        Assert.Equal("primer/21-rays", listed[Array.IndexOf(listed, "primer/04-colour-bleeding") + 1]);
    }

    [Theory]
    [MemberData(nameof(Pages))]
    public void Links_of_a_page_lead_somewhere(string id)
    {
        string html = s_help.Page(id).Html;
        Assert.DoesNotContain("<script", html, StringComparison.OrdinalIgnoreCase);
        foreach (Match link in Link.Matches(html))
        {
            string href = System.Net.WebUtility.HtmlDecode(link.Groups[1].Value);
            if (href.StartsWith("#help=", StringComparison.Ordinal) && href["#help=".Length..].Split("&section=") is var parts)
            {
                string page = s_help.Page(parts[0]).Html;
                Assert.True(parts.Length == 1 || page.Contains($"id=\"{parts[1]}\"", StringComparison.Ordinal), href);
            }
            else if (href.StartsWith("#file=", StringComparison.Ordinal))
            {
                string path = ProjectFolder.PathOf(href["#file=".Length..].Split('/'));
                Assert.True(File.Exists(path) || Directory.Exists(path), href);
            }
            else
            {
                Assert.True(href.StartsWith("https://", StringComparison.Ordinal) || href.StartsWith("try:", StringComparison.Ordinal) || html.Contains($"id=\"{href[1..]}\"", StringComparison.Ordinal), href);
            }
        }

        foreach (Match picture in PictureName.Matches(html))
        {
            Assert.True(File.Exists(ProjectFolder.PathOf(["docs", .. picture.Groups[1].Value.Split('/')])), picture.Value);
        }
    }

    [Fact]
    public void A_page_has_its_title_tables_and_pictures()
    {
        HelpPage page = s_help.Page("primer/07-refraction");
        Assert.Equal("7. Why does glass turn pictures upside down?", page.Title);
        Assert.Contains("data-picture=\"pictures/07-refraction.denoised.jpg\"", page.Html, StringComparison.Ordinal);
        Assert.Contains("href=\"#file=scenes/primer/07-refraction.json\"", page.Html, StringComparison.Ordinal);
        Assert.Contains("<table>", s_help.Page("scene-format").Html, StringComparison.Ordinal);
        Assert.Contains("href=\"try:materials/glass/refractiveIndex=1.05\"", page.Html, StringComparison.Ordinal);
        using Stream picture = HelpPages.Picture("pictures/07-refraction.denoised.jpg");
        Assert.Equal(0xff, picture.ReadByte());
    }

    [Theory]
    [InlineData("lens", "primer/15-depth-of-field")]
    [InlineData("CAUSTIC", "light-from-the-lamps")]
    [InlineData("checkpo", "long-renders")]
    [InlineData("snell", "primer/07-refraction")]
    public void Words_find_the_page_that_is_about_them(string words, string page) =>
        Assert.Contains(page, s_help.Find(words).Take(3).Select(f => f.Page));

    [Fact]
    public void A_finding_has_all_words_and_shows_one()
    {
        IReadOnlyList<HelpFinding> found = s_help.Find("refractiveIndex glass");
        Assert.All(found.Where(f => !f.Section.Contains("glass", StringComparison.OrdinalIgnoreCase)), f =>
            Assert.True(f.Excerpt.Contains("refractive", StringComparison.OrdinalIgnoreCase) || f.Excerpt.Contains("glass", StringComparison.OrdinalIgnoreCase), f.Excerpt));
        Assert.NotEmpty(found);
        Assert.Empty(s_help.Find("refractiveIndex qwertz"));
        Assert.Empty(s_help.Find("  "));
    }

    [Theory]
    [InlineData("../README")]
    [InlineData("README")]
    [InlineData("decisions/README")]
    [InlineData("")]
    public void What_is_no_page_is_refused(string id)
    {
        Assert.Equal(SessionFault.Missing, Assert.Throws<SessionException>(() => s_help.Page(id)).Fault);
        Assert.Equal(SessionFault.Missing, Assert.Throws<SessionException>(() => HelpPages.Picture(id)).Fault);
    }

    [GeneratedRegex("<a href=\"([^\"]*)\"")]
    private static partial Regex Link { get; }

    [GeneratedRegex("data-picture=\"([^\"]*)\"")]
    private static partial Regex PictureName { get; }
}
