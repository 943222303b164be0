using System.Globalization;
using System.Text.RegularExpressions;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>
/// Each scene of the primer has its page and each page its scene, the pages name parameters that exist and works that are listed, and one leads to the
/// next, in the order in which the primer lists them. <see cref="LessonTests"/> looks at their code and changes.
/// </summary>
public partial class PrimerTests
{
    private static readonly HashSet<string> s_keys =
        [.. SceneTypes.Parts.Concat(SceneTypes.Families.SelectMany(f => f.Types)).SelectMany(t => t.Parameters.Select(p => p.Key).Prepend(t.Name))];

    private static readonly string s_references = File.ReadAllText(ProjectFolder.PathOf("docs", "references.md"));

    private static readonly string[] s_names = NamesIn(PathOf(), "??-*.md");

    public static TheoryData<string> Names => new(s_names);

    [Fact]
    public void Each_scene_has_a_page_and_pages_are_numbered_without_gaps()
    {
        string[] scenes = NamesIn(ProjectFolder.PathOf("scenes", "primer"), "*.json");
        Assert.NotEmpty(scenes);
        Assert.Subset(s_names.ToHashSet(), scenes.ToHashSet());
        Assert.Equal(Enumerable.Range(1, s_names.Length), s_names.Select(n => int.Parse(n[..2], CultureInfo.InvariantCulture)));
        Assert.All(scenes, n => Assert.Contains($"](../../scenes/primer/{n}.json)", Page(n), StringComparison.Ordinal));
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Pages_show_a_picture_and_name_one_scene(string name)
    {
        string scene = SceneOf(name);
        Assert.True(File.Exists(ProjectFolder.PathOf("scenes", scene)), scene);
        Assert.Contains(scene == $"primer/{name}.json" ? $"](../pictures/{name}." : "](../pictures/", Page(name), StringComparison.Ordinal);
        Assert.StartsWith($"# {int.Parse(name[..2], CultureInfo.InvariantCulture)}. ", Page(name), StringComparison.Ordinal);
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
        Assert.All(Citation().Matches(string.Join(' ', Page(name).Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries))), c => Assert.Contains($"- **{c.Value}**", s_references, StringComparison.Ordinal));

    [Fact]
    public void The_primer_lists_each_page_once_and_each_leads_to_the_next()
    {
        string[] course = [.. Listed().Matches(Page("README")).Select(m => m.Groups["name"].Value)];
        Assert.Equal(s_names, course.Order(StringComparer.Ordinal));
        foreach ((string one, string next) in course.Zip(course.Skip(1)))
        {
            Assert.Contains($"· next: [{Title(next)}]({next}.md)", Page(one), StringComparison.Ordinal);
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
    [InlineData("as MacDonald & Booth 1990 have it", "MacDonald & Booth 1990")]
    public void Citations_are_recognized(string text, string expected) => Assert.Equal([expected], Citation().Matches(text).Select(m => m.Value));

    /// <summary>The scene that a lesson is beside: the Studio opens it from this link.</summary>
    internal static string SceneOf(string name) => Assert.Single(SceneLink().Matches(Page(name))).Groups["scene"].Value;

    private static string Title(string name) => Heading().Match(Page(name)).Groups["title"].Value;

    private static string[] NamesIn(string folder, string pattern) =>
        [.. Directory.GetFiles(folder, pattern).Select(p => Path.GetFileNameWithoutExtension(p)!).Order(StringComparer.Ordinal)];

    private static IEnumerable<string> Keys(string page) => Key().Matches(page).Select(m => m.Groups["key"].Value);

    internal static string Page(string name) => File.ReadAllText(PathOf($"{name}.md"));

    private static string PathOf(params string[] parts) => ProjectFolder.PathOf(["docs", "primer", .. parts]);

    [GeneratedRegex(@"\(\[the scene file\]\(\.\./\.\./scenes/(?<scene>[^)]+\.json)\)\)", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex SceneLink();

    [GeneratedRegex(@"\A# \d+\. (?<title>[^\r\n]+)", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Heading();

    [GeneratedRegex(@"^\|.*\]\((?<name>\d\d-[\w-]+)\.md\)", RegexOptions.Multiline | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Listed();

    [GeneratedRegex(@"`(?<key>[a-z][a-zA-Z0-9]*)`", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Key();

    [GeneratedRegex(@"\b\p{Lu}\p{L}+((, \p{Lu}\p{L}+)* & \p{Lu}\p{L}+)? (1[6-9]\d\d|20[0-2]\d)\b", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Citation();
}
