namespace RayTracer.Mutations;

/// <summary>One small fault that the tests should find.</summary>
/// <param name="Area">What part of the program it is in: sampling, pdf, material …</param>
/// <param name="Name">What is wrong, in a few words joined by hyphens.</param>
/// <param name="File">The source file, from the repository's root.</param>
/// <param name="Suspects">Classes of tests that should find it; they run first.</param>
/// <param name="Before">Text that occurs once in the file.</param>
/// <param name="After">What takes its place.</param>
internal sealed record Mutant(string Area, string Name, string File, IReadOnlyList<string> Suspects, string Before, string After)
{
    /// <summary>What a student is told who makes this mistake; null for mutants of the program.</summary>
    public string? Says { get; private init; }

    /// <summary>
    /// Reads a list of mutants. Each begins with "## area: name", then "file" and "tests" lines (or "says" lines, in the labs), then the lines to be replaced, each
    /// after a "-", and their replacements, each after a "+". Other lines are comments.
    /// </summary>
    /// <exception cref="FormatException">An entry is incomplete; the message names it.</exception>
    public static IReadOnlyList<Mutant> ReadAll(IEnumerable<string> lines)
    {
        List<List<string>> entries = [];
        foreach (string line in lines)
        {
            if (line.StartsWith("## ", StringComparison.Ordinal))
            {
                entries.Add([]);
            }

            entries.LastOrDefault()?.Add(line);
        }

        return [.. entries.Select(Read)];
    }

    /// <summary>The file's text with the fault in it.</summary>
    /// <exception cref="FormatException">The text to be replaced does not occur exactly once.</exception>
    public string Apply(string text)
    {
        int first = text.IndexOf(Before, StringComparison.Ordinal);
        return first >= 0 && text.IndexOf(Before, first + 1, StringComparison.Ordinal) < 0
            ? string.Concat(text.AsSpan(0, first), After, text.AsSpan(first + Before.Length))
            : throw new FormatException($"{Area}: {Name}: \"{Before}\" does not occur exactly once in {File}");
    }

    private static Mutant Read(List<string> entry)
    {
        string Join(char mark) => string.Join('\n', entry.Skip(1).Where(l => l.StartsWith(mark)).Select(l => l[1..]));
        string? Optional(string name) => entry.Find(l => l.StartsWith(name + " ", StringComparison.Ordinal))?[(name.Length + 1)..].Trim();
        string Field(string name) => Optional(name) ?? throw new FormatException($"{entry[0]}: no \"{name}\"");
        string? says = Optional("says");
        string[] title = entry[0][3..].Split(':', 2, StringSplitOptions.TrimEntries);
        return title.Length == 2 && Join('-').Length > 0
            ? new(title[0], title[1], Field("file"), (says is null ? Field("tests") : "").Split(' ', StringSplitOptions.RemoveEmptyEntries), Join('-'), Join('+')) { Says = says }
            : throw new FormatException($"{entry[0]}: the title needs an area and a name, and the entry a line to be replaced");
    }
}
