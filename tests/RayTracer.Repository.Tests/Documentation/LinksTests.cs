using System.Text.RegularExpressions;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>The files that the pages at the root and under docs point to are there.</summary>
public partial class LinksTests
{
    public static TheoryData<string> Pages => new(Paths);

    /// <summary>The pages, from the repository's root.</summary>
    public static IEnumerable<string> Paths => Directory.GetFiles(ProjectFolder.PathOf("docs"), "*.md", SearchOption.AllDirectories)
        .Concat(Directory.GetFiles(ProjectFolder.Root, "*.md"))
        .Select(p => Path.GetRelativePath(ProjectFolder.Root, p).Replace('\\', '/'))
        .Order(StringComparer.Ordinal);

    [Theory]
    [MemberData(nameof(Pages))]
    public void Relative_links_point_to_files(string page)
    {
        string path = ProjectFolder.PathOf(page);
        string folder = Path.GetDirectoryName(path)!;
        string prose = Code().Replace(File.ReadAllText(path), "");
        string[] missing = [.. Link().Matches(prose).Select(m => m.Groups["target"].Value).Where(t => !Exists(Path.Combine(folder, t)))];
        Assert.Empty(missing);
    }

    [Theory]
    [MemberData(nameof(Pages))]
    public void Repository_paths_in_code_exist(string page)
    {
        string[] code = [.. Code().Matches(File.ReadAllText(ProjectFolder.PathOf(page))).Select(m => m.Value)];
        IEnumerable<string> paths = code.SelectMany(c => RepositoryPath().Matches(c)).Select(m => m.Value);
        IEnumerable<string> sources = code.Select(c => c.Trim('`')).Where(c => SourceName().IsMatch(c));
        string[] missing =
        [
            .. paths.Where(p => !p.Contains("/bin/", StringComparison.Ordinal) && !Exists(ProjectFolder.PathOf(p))),
            .. sources.Where(s => !s_sources.Value.Contains(s)),
        ];
        Assert.Empty(missing);
    }

    [Fact]
    public void Links_and_paths_are_recognized()
    {
        Assert.Equal(["a.md", "b/c.png"], Link().Matches("[x](a.md#part), ![y](b/c.png) [z](https://example.org) [w](#here)").Select(m => m.Groups["target"].Value));
        Assert.Equal(["src/A/B.cs", "scenes/x.json"], RepositoryPath().Matches("`src/A/B.cs` render scenes/x.json mysrc/y.z scenes/*.json").Select(m => m.Value));
        Assert.Equal(["`a`", "```\nb `c`\n```", "`d`"], Code().Matches("`a`\n```\nb `c`\n```\n`d`").Select(m => m.Value));
    }

    private static readonly Lazy<HashSet<string>> s_sources = new(() =>
        [.. Directory.EnumerateFiles(ProjectFolder.Root, "*.cs", SearchOption.AllDirectories).Select(p => Path.GetFileName(p)!)]);

    private static bool Exists(string path) => File.Exists(path) || Directory.Exists(path);

    [GeneratedRegex(@"\]\((?!\w+:|#)(?<target>[^)#\s]+)(#[^)\s]*)?\)", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Link();

    // Fenced blocks, then spans.
    [GeneratedRegex(@"^```.*?^```|`[^`\n]+`", RegexOptions.Singleline | RegexOptions.Multiline | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Code();

    [GeneratedRegex(@"(?<![\w./-])(src|tests|docs|scenes|\.ci)/[\w./-]*\w(?![\w*])", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex RepositoryPath();

    [GeneratedRegex(@"^\w[\w.]*\.cs$", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex SourceName();
}
