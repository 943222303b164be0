using RayTracer.Scenes;

namespace RayTracer.Scenes.Tests;

public class JsonParserTests
{
    [Fact]
    public void Every_key_and_value_keeps_its_range()
    {
        const string Text = "// first\n{ \"a\": [1, /* two */ -2.5e1,],\r\n  \"b\" : \"x\\n\\u00e9\", }";
        JsonNode root = Parse(Text, out List<Diagnostic> diagnostics)!;

        Assert.Empty(diagnostics);
        Assert.Equal(["\"a\"", "\"b\""], root.Members.Select(m => Text[m.Start..m.End]));
        Assert.Equal(["1", "-2.5e1"], root.Find("a")!.Items.Select(i => Text[i.Start..i.End]));
        Assert.Equal("[1, /* two */ -2.5e1,]", Text[root.Find("a")!.Start..root.Find("a")!.End]);
        Assert.Equal("x\né", root.Find("b")!.Text);
        Assert.Equal("\"x\\n\\u00e9\"", Text[root.Find("b")!.Start..root.Find("b")!.End]);
    }

    [Theory]
    [InlineData("\n\n  ?", 3, 3)]
    [InlineData("\r\n\r\n?", 3, 1)]
    [InlineData("\r\r\t?", 3, 2)]
    [InlineData("/* 😀 */ ?", 1, 10)]
    [InlineData("\uFEFF ?", 1, 2)]
    public void Lines_and_columns_are_those_of_editors(string text, int line, int column)
    {
        Parse(text, out List<Diagnostic> diagnostics);
        Assert.Equal((line, column), (diagnostics[0].Line, diagnostics[0].Column));
    }

    [Theory]
    [InlineData("0")]
    [InlineData("-0")]
    [InlineData("10.25E+2")]
    [InlineData("1e-400")]
    [InlineData("true")]
    [InlineData("null")]
    [InlineData("[]")]
    [InlineData("{ /**/ }")]
    [InlineData("\"\\\"\\\\\\/\\b\\f\\n\\r\\t\"")]
    public void What_JSON_allows_is_accepted(string text) => Assert.NotNull(Parse(text, out _));

    [Theory]
    [InlineData("+1")]
    [InlineData("01")]
    [InlineData("-")]
    [InlineData("1.")]
    [InlineData("1e")]
    [InlineData("0x1F")]
    [InlineData("NaN")]
    [InlineData("-Infinity")]
    [InlineData("[,]")]
    [InlineData("[1,,2]")]
    [InlineData("{,}")]
    [InlineData("{\"a\":}")]
    [InlineData("{\"a\"")]
    [InlineData("[1")]
    [InlineData("\"\\")]
    [InlineData("\"\\u00")]
    [InlineData("/")]
    [InlineData("1 2")]
    public void What_JSON_does_not_allow_is_one_error(string text)
    {
        Assert.Null(Parse(text, out List<Diagnostic> diagnostics));
        Assert.Single(diagnostics);
    }

    [Theory]
    [InlineData(JsonParser.MaximumDepth, true)]
    [InlineData(JsonParser.MaximumDepth + 1, false)]
    public void Nesting_is_allowed_up_to_its_limit(int depth, bool isAllowed) =>
        Assert.Equal(isAllowed, Parse(new string('[', depth) + new string(']', depth), out _) is not null);

    [Fact]
    public void Quoted_parts_of_the_file_cannot_break_a_message_in_lines()
    {
        Parse("{ \"a\\n" + new string('b', 1000) + "\" }", out List<Diagnostic> diagnostics);
        Assert.DoesNotContain('\n', diagnostics[0].Message);
        Assert.InRange(diagnostics[0].Message.Length, 10, 200);
    }

    private static JsonNode? Parse(string text, out List<Diagnostic> diagnostics)
    {
        diagnostics = [];
        return JsonParser.Parse(new SourceText("test.json", text), diagnostics);
    }
}
