using System.Text.RegularExpressions;

namespace RayTracer.Repository.Tests.Testing;

/// <summary>Tests that do more in a thorough run say so, for a thorough run takes only these: all others would do again what they do every day.</summary>
public sealed partial class ThoroughTests
{
    [Fact]
    public void Tests_that_do_more_in_a_thorough_run_are_of_that_category()
    {
        Dictionary<string, string> files = Directory.EnumerateFiles(ProjectFolder.PathOf("tests"), "*.cs", SearchOption.AllDirectories)
            .Where(p => !Built().IsMatch(p.Replace('\\', '/')) && Path.GetFileName(p) is not ("TestSettings.cs" or "ThoroughTests.cs"))
            .ToDictionary(p => Path.GetRelativePath(ProjectFolder.Root, p), File.ReadAllText);
        HashSet<string> scaled = [.. files.Keys.Where(p => Asks().IsMatch(files[p]))];

        // Helpers pass it on to whatever uses them.
        for (int before = 0; before != scaled.Count;)
        {
            before = scaled.Count;
            string[] helpers = [.. scaled.Where(p => !IsTest(files[p])).Select(p => Path.GetFileNameWithoutExtension(p))];
            scaled.UnionWith(files.Keys.Where(p => helpers.Any(h => files[p].Contains(h + ".", StringComparison.Ordinal))));
        }

        Assert.True(scaled.Count > 50, $"only {scaled.Count} files were found");
        string[] wrong = [.. scaled.Where(p => IsTest(files[p]) && !files[p].Contains("[Trait(\"Category\", \"Thorough\")]", StringComparison.Ordinal)).Order(StringComparer.Ordinal)];
        Assert.True(wrong.Length == 0, $"these tests do more in a thorough run, and lack [Trait(\"Category\", \"Thorough\")]: {string.Join(", ", wrong)}");
    }

    private static bool IsTest(string text) => Test().IsMatch(text);

    [GeneratedRegex(@"TestSettings\.(Scale\(|Thorough)", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Asks();

    [GeneratedRegex(@"\[\w*(Fact|Theory)\b", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Test();

    [GeneratedRegex("/(bin|obj)/", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Built();
}
