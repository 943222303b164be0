using System.CommandLine;
using System.CommandLine.Help;

namespace RayTracer.Cli;

/// <summary>A verb, as help pages and shells see it.</summary>
/// <param name="Name">Its name: a word, or two for a verb below another one.</param>
/// <param name="Summary">A sentence that says what it does.</param>
/// <param name="Synopsis">The words that follow it.</param>
/// <param name="Arguments">The words that are no options, and what they mean.</param>
/// <param name="Choices">The possible words that are no options; empty where they are files or anything else.</param>
/// <param name="Options">Its options.</param>
/// <param name="Example">A command, without the program's name.</param>
internal sealed record VerbHelp(string Name, string Summary, string Synopsis, IReadOnlyList<(string Name, string Summary)> Arguments, IReadOnlyList<string> Choices, IReadOnlyList<OptionHelp> Options, string Example)
{
    /// <summary>True if verbs are below it.</summary>
    public bool HasVerbs { get; private init; }

    /// <summary>Describes a verb, and after it those below it.</summary>
    /// <param name="command">The verb, with its options made.</param>
    /// <param name="synopsis">Returns what stands after a verb.</param>
    /// <param name="example">A command.</param>
    public static IEnumerable<VerbHelp> Of(Command command, Func<Command, string> synopsis, string example) =>
        [One(command, command.Name, synopsis, example), .. command.Subcommands.Where(c => !c.Hidden).Select(c => One(c, $"{command.Name} {c.Name}", synopsis, ExampleBelow(command, c, example)))];

    /// <summary>The example of a verb below another: what takes no words is its own.</summary>
    /// <param name="above">The other verb.</param>
    /// <param name="command">The verb below it.</param>
    /// <param name="example">The example of the other.</param>
    public static string ExampleBelow(Symbol above, Symbol command, string example) =>
        command is Command { Arguments.Count: 0, Subcommands.Count: 0 } ? $"{above.Name} {command.Name}" : example;

    private static VerbHelp One(Command command, string name, Func<Command, string> synopsis, string example) => new(
        name,
        command.Description ?? "",
        synopsis(command),
        [.. command.Arguments.Select(a => (a.Name, a.Description ?? ""))],
        [.. command.Subcommands.Where(c => !c.Hidden).Select(c => c.Name), .. command.Arguments.SelectMany(a => OptionHelp.WordsOf(a.Name))],
        [.. command.Options.Where(o => o is not HelpOption).Select(o => new OptionHelp(
            [o.Name, .. o.Aliases], o.ValueType == typeof(bool) ? null : o.HelpName ?? "VALUE", o.Description ?? "", o.ValueType.IsArray))],
        $"raytracer {example}")
    {
        HasVerbs = command.Subcommands.Count > 0,
    };
}
