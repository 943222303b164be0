using System.Text.RegularExpressions;

namespace RayTracer.Repository.Tests.Testing;

/// <summary>Classes of tests lead to what they test: each is named after a type of the sources, or its summary names some.</summary>
public sealed partial class ThemeTests
{
    // Where nearly all classes are named after types; in the other projects a class tests a verb, a format or a window.
    private static readonly string[] s_projects = ["RayTracer.Tests", "RayTracer.RenderTests"];

    [Fact]
    public void Classes_of_tests_that_are_not_named_after_a_type_name_some_in_their_summaries()
    {
        HashSet<string> types = [.. Sources("src").Concat(Sources("tests", "RayTracer.Testing"))
            .SelectMany(p => TypeOf().Matches(File.ReadAllText(p)).Select(m => m.Groups[1].Value))];
        (string File, string Name, string Summary)[] tests =
        [
            .. from file in s_projects.SelectMany(p => Sources("tests", p))
               let text = File.ReadAllText(file)
               where Test().IsMatch(text)
               from Match match in TestClass().Matches(text)
               where match.Groups[2].Value.EndsWith("Tests", StringComparison.Ordinal)
               select (Path.GetRelativePath(ProjectFolder.Root, file), match.Groups[2].Value, match.Groups[1].Value),
        ];
        Assert.True(tests.Length > 50, $"only {tests.Length} classes of tests were found");
        string[] wrong = [.. tests.Where(t => !types.Contains(t.Name[..^"Tests".Length]) && !Named(t.Summary).Any(types.Contains))
            .Select(t => t.File).Order(StringComparer.Ordinal)];
        Assert.True(
            wrong.Length == 0,
            $"these test no type of their name, and their summaries name no type in back quotes or <see cref>: {string.Join(", ", wrong)}");
    }

    private static IEnumerable<string> Sources(params string[] folder) =>
        Directory.EnumerateFiles(ProjectFolder.PathOf(folder), "*.cs", SearchOption.AllDirectories).Where(p => !Built().IsMatch(p.Replace('\\', '/')));

    private static IEnumerable<string> Named(string summary) => Reference().Matches(summary).Select(m => m.Groups[1].Value);

    [GeneratedRegex(@"\b(?:class|record struct|record|struct|interface|enum)\s+([A-Z]\w*)", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex TypeOf();

    [GeneratedRegex(@"((?:^[ \t]*///[^\n]*\n)*)(?:^\[[^\n]*\n)*^public (?:sealed |static |partial |abstract )*class (\w+)", RegexOptions.Multiline, 1000)]
    private static partial Regex TestClass();

    [GeneratedRegex(@"(?:cref=""|`)(\w+)", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Reference();

    [GeneratedRegex(@"\[\w*(Fact|Theory)\b", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Test();

    [GeneratedRegex("/(bin|obj)/", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Built();
}
