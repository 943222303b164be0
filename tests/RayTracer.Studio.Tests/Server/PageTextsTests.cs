using System.Text.Json.Nodes;
using System.Text.RegularExpressions;

namespace RayTracer.Studio.Tests;

/// <summary>The committed pages hold the texts as they are now; this needs no Node to find out.</summary>
public sealed partial class PageTextsTests
{
    private static readonly string[] s_texts = [.. Leaves(JsonNode.Parse(File.ReadAllText(ProjectFolder.PathOf("src", "RayTracer.Session", "Texts", "english.json"))))];

    [Fact]
    public void The_pages_are_as_new_as_their_texts()
    {
        string[] scripts = [.. Directory.EnumerateFiles(ProjectFolder.PathOf("src", "RayTracer.Studio", "wwwroot", "assets"), "*.js").Select(File.ReadAllText)];
        string[] built = Bundled(Assert.Single(scripts, s => s.Contains(Begin, StringComparison.Ordinal)));
        int other = s_texts.Zip(built).TakeWhile(p => p.First == p.Second).Count();
        Assert.True(
            other == s_texts.Length,
            $"The text \"{s_texts.ElementAtOrDefault(other)}\" is \"{built.ElementAtOrDefault(other)}\" in src/RayTracer.Studio/wwwroot: npm run build in the folder frontend makes the pages again.");
    }

    [Fact]
    public void Literals_are_read_however_they_are_quoted()
    {
        string[] texts = Bundled(Begin + """`English`,a:`two \`words\` of \${x}`,"b-c":["it's","\u00e9\n"],d:'say "so"'""");
        Assert.Equal(["English", "two `words` of ${x}", "it's", "é\n", "say \"so\""], texts);
    }

    private const string Begin = "{language:";

    // The texts are bundled as one object, in the file's order; keys that are no identifiers are quoted, too.
    private static string[] Bundled(string script) =>
        [.. Literal().Matches(script, script.IndexOf(Begin, StringComparison.Ordinal)).Where(m => !m.Groups["key"].Success).Take(s_texts.Length).Select(m => Regex.Unescape(m.Groups["text"].Value))];

    private static IEnumerable<string> Leaves(JsonNode? node) => node switch
    {
        JsonObject group => group.SelectMany(g => Leaves(g.Value)),
        JsonArray list => list.SelectMany(Leaves),
        _ => [node!.GetValue<string>()],
    };

    [GeneratedRegex("""(?<quote>[`"'])(?<text>(?:\\.|(?!\k<quote>).)*)\k<quote>(?<key>:)?""", RegexOptions.Singleline | RegexOptions.CultureInvariant, 10000)]
    private static partial Regex Literal();
}
