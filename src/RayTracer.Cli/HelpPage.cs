using System.CommandLine;
using System.CommandLine.Invocation;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>The option <c>--help</c>: a page that fits a terminal, with the options in groups.</summary>
/// <param name="streams">The streams to write to.</param>
/// <param name="describe">Describes a command.</param>
internal sealed class HelpPage(Streams streams, Func<Command, VerbHelp> describe) : SynchronousCommandLineAction
{
    private const int FirstColumn = 28;
    private const int Indent = FirstColumn + 2;
    private const int Narrowest = 60;
    private const int Widest = 110;

    // Options of none of them come first.
    private static readonly (string Title, string[] Names)[] s_groups =
    [
        ("Scene", [.. JobOptions.OfScenes.Select(o => o.Name)]),
        ("Parts and noise", ["--noise", "--adaptive", "--crop", "--pixel", "--sample", "--samples", "--part", "--partial"]),
        ("Guiding", [.. JobOptions.OfGuiding.Select(o => o.Name)]),
        ("Long renders", [.. JobOptions.OfLongRenders.Select(o => o.Name), "--resume", "--overwrite"]),
        ("Animations", ["--frames", "--fps"]),
        ("Looks of images", [.. JobOptions.OfLooks.Select(o => o.Name), JobOptions.Transparent.Name, JobOptions.ExrFilm.Name]),
        ("Further images", ["--aov", "--denoise", JobOptions.Halves.Name, "--map", "--side-by-side"]),
        ("Reports", ["--preview", "--quiet", "--json", "--format", "--hash", "--verbose"]),
        ("Machine and limits", [JobOptions.Threads.Name, "--memory", "--work", "--root", "--plugin", "--version"]),
    ];

    /// <inheritdoc/>
    public override bool ClearsParseErrors => true;

    /// <inheritdoc/>
    public override int Invoke(ParseResult parseResult)
    {
        Command command = parseResult.CommandResult.Command;
        VerbHelp verb = describe(command);
        bool isRoot = command.Parents.FirstOrDefault() is null;
        (string text, string exit) = isRoot ? (verb.Summary.Split('\n')[0], $"\n{ExitStatus.Help}") : (verb.Summary, "");
        string name = string.Join(' ', Above(command));
        streams.Output.WriteLine($"{text}\n\nUsage:   {name} {(isRoot ? "VERB …" : verb.Synopsis)}\nExample: {verb.Example}".ReplaceLineEndings());
        Write("Words", verb.Arguments);
        Write("Verbs", command.Subcommands.Select(c => (c.Name, c.Description ?? "")));
        HashSet<string> grouped = [.. s_groups.SelectMany(g => g.Names)];
        Write("Options", verb.Options.Where(o => !o.Names.Any(grouped.Contains)).Select(Row));
        foreach ((string title, string[] names) in s_groups)
        {
            Write(title, verb.Options.Where(o => o.Names.Any(names.Contains)).OrderBy(o => Array.FindIndex(names, o.Names.Contains)).Select(Row));
        }

        Write("Help", [("-h, --help", "Shows this page.")]);
        streams.Output.Write(exit.Length > 0 ? exit.ReplaceLineEndings() + Environment.NewLine : "");
        return ExitStatus.Fine;
    }

    private static IEnumerable<string> Above(Symbol command) =>
        command.Parents.FirstOrDefault() is { } above ? Above(above).Append(command.Name) : [command.Name];

    // A form that takes too much room is given in the text.
    private static (string Name, string Summary) Row(OptionHelp option)
    {
        string names = string.Join(", ", option.Names.OrderBy(n => n.Length));
        string row = $"{names} {option.Form}".TrimEnd();
        bool isList = option.Form?.Contains(',', StringComparison.Ordinal) == true;
        return row.Length <= FirstColumn - 2 ? (row, option.Summary)
            : ($"{names} {(isList ? "WORDS" : "WORD")}", $"{option.Summary} {(isList ? "Some" : "One")} of {string.Join(", ", option.Form!.Split('|', ','))}.");
    }

    private void Write(string title, IEnumerable<(string Name, string Summary)> rows)
    {
        (string Name, string Summary)[] all = [.. rows];
        if (all.Length == 0)
        {
            return;
        }

        int width = Math.Clamp(TerminalSize.Current.Columns, Narrowest, Widest) - Indent - 1;
        streams.Output.WriteLine($"{Environment.NewLine}{title}");
        foreach ((string name, string summary) in all)
        {
            string first = $"  {name}".PadRight(Indent);
            foreach (string line in Lines(summary, width))
            {
                streams.Output.WriteLine($"{first}{line}");
                first = new(' ', Indent);
            }
        }
    }

    private static IEnumerable<string> Lines(string text, int width)
    {
        string line = "";
        foreach (string word in text.Split(' '))
        {
            if (line.Length > 0 && line.Length + 1 + word.Length > width)
            {
                yield return line;
                line = "";
            }

            line = line.Length == 0 ? word : $"{line} {word}";
        }

        yield return line;
    }
}
