using System.Text.RegularExpressions;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>Types, members, files and options that the pages name between back quotes exist. <see cref="LinksTests"/> sees to whole paths.</summary>
public sealed partial class IdentifiersTests
{
    // Names of other programs and formats, and stand-ins for the reader's own files.
    private static readonly HashSet<string> s_others =
    [
        "ColorTrace", "GetPoint", "cel", "ExplicitBRDF", // members of the report's program
        "Matrix4x4", "isa", // of .NET, of Embree
        "TEXCOORD_n", "JOINTS_n", "WEIGHTS_n", "KHR_animation_pointer", "NEAREST", "doubleSided", // glTF
        "MaxArraySize", "sbcast", "scp", "nohup", "rdjpgcom", "attenuate", "crossgen2", "netcore", // programs, and their settings
        "comp_bad_", "comp_dwaa_v1", "comp_dwab_v2", "make_scenes", // files of others
        "photo", "photo420", "group1", "NAMES", "PROGRAM", // stand-ins
    ];

    private static readonly HashSet<string> s_otherOptions = ["--project", "--filter", "--global", "--add-source", "--prerelease"];
    private static readonly Lazy<HashSet<string>> s_words = new(() => [.. SourceTexts().SelectMany(Words)]);
    private static readonly Lazy<HashSet<string>> s_options = new(() => [.. SourceTexts().SelectMany(Options)]);

    public static TheoryData<string> Pages => LinksTests.Pages;

    [Theory]
    [MemberData(nameof(Pages))]
    public void What_a_page_names_between_back_quotes_exists(string page)
    {
        string[] spans = [.. Spans(File.ReadAllText(ProjectFolder.PathOf(page)))];
        IEnumerable<string> missing = spans.SelectMany(Words).Where(w => !s_words.Value.Contains(w) && !s_others.Contains(w))
            .Concat(spans.SelectMany(Options).Where(o => !s_options.Value.Contains(o) && !s_otherOptions.Contains(o)));
        Assert.True(!missing.Any(), $"{page} names between back quotes what is nowhere in the sources: {string.Join(", ", missing.Distinct())}. Mend the page, or "
            + $"add the names of other programs to the list in {nameof(IdentifiersTests)}.");
    }

    [Fact]
    public void Names_and_options_are_recognized_and_comments_are_no_sources()
    {
        Assert.Equal(["FloatW.Min", "render --spp 4"], Spans("`FloatW.Min` of\n```\n`not` this\n```\n `render --spp 4`"));
        Assert.Equal(["FloatW", "Min"], Words("FloatW.Min"));
        Assert.Equal(["--no-build", "--spp"], Options("dotnet test --no-build --spp=3 a--b"));
        Assert.Equal(["class", "A"], Words(WithoutComments("/// <see cref=\"B\"/>\nclass A // C\n")));
        Assert.DoesNotContain("GoneLongAgo" + "Shader", s_words.Value);
    }

    private static IEnumerable<string> Spans(string page) => Span().Matches(Fence().Replace(page, "")).Select(m => m.Groups[1].Value);

    private static IEnumerable<string> Words(string text) => Word().Matches(text).Select(m => m.Value);

    private static IEnumerable<string> Options(string text) => Option().Matches(text).Select(m => m.Value);

    // The texts of all sources, and their paths: names of files and folders count as well.
    private static IEnumerable<string> SourceTexts() =>
        from root in new[] { "src", "tests", "samples", ".ci", "scenes" }
        from path in Directory.EnumerateFiles(ProjectFolder.PathOf(root), "*", SearchOption.AllDirectories).Append(ProjectFolder.PathOf("Directory.Build.props"))
        where !Built().IsMatch(path.Replace('\\', '/'))
        from text in new[] { Path.GetRelativePath(ProjectFolder.Root, path), Text(path) }
        select text;

    private static string Text(string path) => Path.GetExtension(path) switch
    {
        ".cs" => WithoutComments(File.ReadAllText(path)),
        ".csproj" or ".props" or ".json" or ".ts" or ".sh" or ".py" or ".c" or ".xml" or "" => File.ReadAllText(path),
        _ => "",
    };

    private static string WithoutComments(string code) => Comment().Replace(code, "");

    [GeneratedRegex(@"^```.*?^```", RegexOptions.Singleline | RegexOptions.Multiline | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Fence();

    [GeneratedRegex("`([^`\n]+)`", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Span();

    [GeneratedRegex(@"(?<!\w)[A-Za-z_]\w*", RegexOptions.CultureInvariant, 10000)]
    private static partial Regex Word();

    [GeneratedRegex(@"(?<![\w-])--[a-z][a-z-]*", RegexOptions.CultureInvariant, 10000)]
    private static partial Regex Option();

    [GeneratedRegex(@"(?<=^|\s)//.*$", RegexOptions.Multiline | RegexOptions.CultureInvariant, 10000)]
    private static partial Regex Comment();

    [GeneratedRegex("/(bin|obj|node_modules|wwwroot)/", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Built();
}
