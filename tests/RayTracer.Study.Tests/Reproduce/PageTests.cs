namespace RayTracer.Study.Tests;

public sealed class PageTests
{
    [Fact]
    public void Html_escapes_text()
    {
        HtmlPage page = new("<t>");
        page.Paragraph("a < b & \"c\"");
        page.Table(["<h>"], [["<td>"]]);
        page.Picture("a.png", "\"><script>");
        string html = page.Finish();
        Assert.Contains("<title>&lt;t&gt;</title>", html, StringComparison.Ordinal);
        Assert.Contains("<p>a &lt; b &amp; &quot;c&quot;</p>", html, StringComparison.Ordinal);
        Assert.Contains("<tr><td>&lt;td&gt;</td></tr>", html, StringComparison.Ordinal);
        Assert.DoesNotContain("<script>", html, StringComparison.Ordinal);
    }

    [Fact]
    public void Markdown_escapes_text()
    {
        MarkdownPage page = new("a_b");
        page.Table(["x", "y"], [["a|b", "<i>\n*"]]);
        page.Picture("a.png", "[1]");
        Assert.Equal("# a\\_b\n\n| x | y |\n| --- | ---: |\n| a\\|b | \\<i\\> \\* |\n\n![\\[1\\]](a.png)\n\n\\[1\\]\n", page.Finish());
    }
}
