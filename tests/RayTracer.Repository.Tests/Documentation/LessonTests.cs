using System.Text.RegularExpressions;
using RayTracer.Scenes;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>What lessons quote is in the sources, and the changes that they propose can be made to their scenes.</summary>
public sealed partial class LessonTests
{
    public static TheoryData<string> Names => PrimerTests.Names;

    [Theory]
    [MemberData(nameof(Names))]
    public void Code_of_a_lesson_is_that_of_the_sources(string name) =>
        Assert.All(Block().Matches(PrimerTests.Page(name).ReplaceLineEndings("\n")), block =>
        {
            string[] quoted = block.Groups["code"].Value.Split('\n');
            string member = block.Groups["member"].Value;
            Assert.True(Regex.IsMatch(quoted[0], $@"\b{member}\b"), $"{name}: {quoted[0]} does not declare {member}");
            string[] source = File.ReadAllText(ProjectFolder.PathOf(block.Groups["path"].Value.Split('/'))).ReplaceLineEndings("\n").Split('\n');
            Assert.True(IsIn(source, quoted), $"{name}: {member} is not in {block.Groups["path"].Value} as it is quoted. Quote it again.");
        });

    // Every block says where it is from: one that did not would not be compared.
    [Theory]
    [MemberData(nameof(Names))]
    public void Blocks_of_code_say_where_they_are_from(string name)
    {
        string page = PrimerTests.Page(name).ReplaceLineEndings("\n");
        Assert.Equal(Regex.Count(page, "^```csharp", RegexOptions.Multiline), Block().Count(page));
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Changes_of_a_lesson_can_be_made_to_its_scene(string name)
    {
        string scene = ProjectFolder.PathOf("scenes", PrimerTests.SceneOf(name));
        MatchCollection changes = Change().Matches(PrimerTests.Page(name));
        Assert.NotEmpty(changes);
        Assert.All(changes, change =>
        {
            SceneSetting[] settings = [.. Settings(change.Groups["changes"].Value)];
            SceneLoadResult result = SceneLoader.Load(scene, s => s with { Render = s.Render with { Width = 8, Height = 8 } }, settings: settings);
            Assert.True(result.Scene is not null, $"{name}: {change.Value}: {string.Join("; ", result.Diagnostics)}");
        });
    }

    [Fact]
    public void Code_and_changes_are_recognized()
    {
        Assert.True(IsIn(["    int A()", "    {", "", "    }"], ["int A()", "{", "", "}"]));
        Assert.False(IsIn(["    int A()", "    {", "    }"], ["int A()", "{", "", "}"]));
        Assert.False(IsIn(["    int A()", "  {", "    }"], ["int A()", "{", "}"]));
        Assert.Equal(["shapes[2].radius=0.25", "materials[\"green glass\"].color=[1,0,0]", "background=[1,1,1]"],
            Settings("shapes/2/radius=0.25;materials/green%20glass/color=[1,0,0];background=[1,1,1]").Select(s => s.Text));
        Assert.Equal("a/b=1;c=[1,2]", Assert.Single(Change().Matches("[x](try:a/b=1;c=[1,2]) [y](a.md)")).Groups["changes"].Value);
    }

    // True for lines that follow each other in the source, all indented by as much more.
    private static bool IsIn(string[] source, string[] quoted) => Enumerable.Range(0, Math.Max(0, source.Length - quoted.Length + 1)).Any(at =>
    {
        string indent = source[at][..(source[at].Length - source[at].TrimStart().Length)];
        return quoted.Select((line, i) => source[at + i] == (line.Length > 0 ? indent + line : "")).All(equal => equal);
    });

    // A JSON pointer without its first slash (RFC 6901), "=", and the value as JSON: several are joined by ";".
    private static IEnumerable<SceneSetting> Settings(string changes) => changes.Split(';').Select(change =>
    {
        string[] parts = change.Split('=', 2);
        string path = string.Concat(parts[0].Split('/').Select(Uri.UnescapeDataString).Select((key, i) =>
            key.All(char.IsAsciiDigit) ? $"[{key}]" : !key.All(char.IsAsciiLetterOrDigit) ? $"[\"{key}\"]" : i > 0 ? $".{key}" : key));
        return SceneSetting.Parse($"{path}={Uri.UnescapeDataString(parts[1])}");
    });

    [GeneratedRegex(@"^```csharp\n// (?<path>src/[\w./-]+\.cs): (?<member>\w+)\n(?<code>.*?)\n```$", RegexOptions.Singleline | RegexOptions.Multiline | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Block();

    [GeneratedRegex(@"\]\(try:(?<changes>[^\s()]+)\)", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Change();
}
