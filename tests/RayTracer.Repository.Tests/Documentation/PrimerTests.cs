using System.Text.RegularExpressions;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>Each scene of the primer has its page, the pages name parameters that exist and works that are listed, and one leads to the next.</summary>
public partial class PrimerTests
{
    private static readonly HashSet<string> s_keys =
        [.. SceneTypes.Parts.Concat(SceneTypes.Families.SelectMany(f => f.Types)).SelectMany(t => t.Parameters.Select(p => p.Key).Prepend(t.Name))];

    private static readonly string s_references = File.ReadAllText(ProjectFolder.PathOf("docs", "references.md"));

    private static readonly string[] s_names = NamesIn(ProjectFolder.PathOf("scenes", "primer"), "*.json");

    public static TheoryData<string> Names => new(s_names);

    [Fact]
    public void Each_scene_has_a_page_and_each_page_a_scene() => Assert.Equal(s_names, NamesIn(PathOf(), "??-*.md"));

    [Theory]
    [MemberData(nameof(Names))]
    public void Pages_show_and_link_their_scenes(string name)
    {
        string page = Page(name);
        Assert.Contains($"](../pictures/{name}.", page, StringComparison.Ordinal);
        Assert.Contains($"](../../scenes/primer/{name}.json)", page, StringComparison.Ordinal);
        Assert.Contains($"]({name}.md)", Page("README"), StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Pages_name_only_parameters_that_exist(string name)
    {
        string[] keys = [.. Keys(Page(name))];
        Assert.NotEmpty(keys);
        Assert.All(keys, k => Assert.Contains(k, s_keys));
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Works_that_pages_cite_are_in_the_references(string name) =>
        Assert.All(Citation().Matches(Page(name)), c => Assert.Contains($"- **{c.Value}**", s_references, StringComparison.Ordinal));

    [Fact]
    public void Each_page_leads_to_the_next()
    {
        foreach ((string one, string next) in s_names.Zip(s_names.Skip(1)))
        {
            Assert.Contains($"]({next}.md)", Page(one), StringComparison.Ordinal);
            Assert.Contains($"[Previous]({one}.md)", Page(next), StringComparison.Ordinal);
        }
    }

    [Theory]
    [InlineData("set `radius` to 1", "radius")]
    [InlineData("set `apertureRadiuss` to 1", "apertureRadiuss")]
    [InlineData("run `dotnet run -c Release`, see `textures/sail.png` and u · `scale`", "scale")]
    public void Parameters_are_recognized(string text, string expected) => Assert.Equal([expected], Keys(text));

    [Theory]
    [InlineData("the fraction (Beer 1852)", "Beer 1852")]
    [InlineData("(Shirley, Wang & Zimmerman 1996, section 3.2)", "Shirley, Wang & Zimmerman 1996")]
    public void Citations_are_recognized(string text, string expected) => Assert.Equal([expected], Citation().Matches(text).Select(m => m.Value));

    private static string[] NamesIn(string folder, string pattern) =>
        [.. Directory.GetFiles(folder, pattern).Select(p => Path.GetFileNameWithoutExtension(p)!).Order(StringComparer.Ordinal)];

    private static IEnumerable<string> Keys(string page) => Key().Matches(page).Select(m => m.Groups["key"].Value);

    private static string Page(string name) => File.ReadAllText(PathOf($"{name}.md"));

    private static string PathOf(params string[] parts) => ProjectFolder.PathOf(["docs", "primer", .. parts]);

    [GeneratedRegex(@"`(?<key>[a-z][a-zA-Z0-9]*)`", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Key();

    [GeneratedRegex(@"\p{Lu}\p{Ll}+((, \p{Lu}\p{Ll}+)* & \p{Lu}\p{Ll}+)? (1[6-9]\d\d|20[0-2]\d)\b", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Citation();
}
