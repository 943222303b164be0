using System.Text.RegularExpressions;

namespace RayTracer.Repository.Tests.Documentation;

/// <summary>A command line that a page shows.</summary>
/// <param name="Program">The words before the program's own: <c>raytracer</c>, or <c>dotnet run … --</c>.</param>
/// <param name="Words">The words that the program gets.</param>
internal sealed partial record PageCommand(string Program, string[] Words)
{
    /// <summary>The project that <c>dotnet run</c> runs; null for the installed command.</summary>
    public string? Project => ProjectName().Match(Program) is { Success: true } m ? m.Groups[1].Value : null;

    /// <summary>Whether the renderer's command gets the words.</summary>
    public bool IsRaytracer => Project is null or "src/RayTracer.Cli";

    /// <inheritdoc/>
    public override string ToString() => $"{Program} {string.Join(' ', Words)}";

    /// <summary>The command lines in a page's code: the blocks, fenced or indented, and the spans that are more than a verb's name.</summary>
    public static IEnumerable<PageCommand> Of(string page)
    {
        IEnumerable<string> blocks = Block().Matches(page).Select(m => m.Value);
        IEnumerable<string> spans = Span().Matches(Block().Replace(page, "")).Select(m => m.Value.Trim('`')).Where(s => s.Count(c => c == ' ') > 1);
        return blocks.SelectMany(b => b.Split('\n')).Concat(spans).SelectMany(line => Command().Matches(line)).Select(
            m => new PageCommand(m.Groups["program"].Value, [.. Word().Matches(m.Groups["words"].Value).Select(w => Unquoted(w.Value)).Where(w => w.Length > 0)]))
            .Where(c => c.Project is not null || c.Words.Length > 0);
    }

    // Words that stand for what the reader, xargs or the shell puts there.
    private static string Unquoted(string word) => word.Trim('"', '\'').Replace("{}", "1", StringComparison.Ordinal).Replace("$0", "1", StringComparison.Ordinal)
        .Replace("VERB", "render", StringComparison.Ordinal);

    // A block in fences, or a line that is indented like code after an empty one.
    [GeneratedRegex(@"^(?<indent> *)```.*?^\k<indent>```|(?<=\n\n)(( {4,}.*(\n|\z))+)", RegexOptions.Singleline | RegexOptions.Multiline | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Block();

    // A span of code, or the command that a block of figures comes from.
    [GeneratedRegex("`([^`\n]+)`|(?<=^<!-- measured: )(.*?)(?= -->$)", RegexOptions.Multiline | RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Span();

    // To the end of the command within the shell's line.
    [GeneratedRegex(@"(?<![\w/.-])(?<program>raytracer|dotnet run( -c Release)? --project [\w./]+( --)?)(?<words>( +(?!#\s)[^\s|>;&)\[`]+)*)", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Command();

    [GeneratedRegex(@"'[^']*'|""[^""]*""|\S+", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Word();

    [GeneratedRegex(@"--project (\S+)", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex ProjectName();
}
