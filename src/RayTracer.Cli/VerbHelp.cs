using System.CommandLine;
using System.CommandLine.Help;

namespace RayTracer.Cli;

/// <summary>A verb, as help pages and shells see it.</summary>
/// <param name="Name">How it is written.</param>
/// <param name="Summary">What it does.</param>
/// <param name="Synopsis">What stands after it.</param>
/// <param name="Arguments">The words that are no options, and what they mean.</param>
/// <param name="Choices">What the words that are no options may be; empty where they are files or anything else.</param>
/// <param name="Options">Its options.</param>
internal sealed record VerbHelp(string Name, string Summary, string Synopsis, IReadOnlyList<(string Name, string Summary)> Arguments, IReadOnlyList<string> Choices, IReadOnlyList<OptionHelp> Options)
{
    /// <summary>Describes a verb.</summary>
    /// <param name="command">The verb, with its options made.</param>
    /// <param name="synopsis">What stands after it.</param>
    public static VerbHelp Of(Command command, string synopsis) => new(
        command.Name,
        command.Description ?? "",
        synopsis,
        [.. command.Arguments.Select(a => (a.Name, a.Description ?? ""))],
        [.. command.Arguments.Where(a => a.Name.Contains('|', StringComparison.Ordinal)).SelectMany(a => a.Name.Split('|'))],
        [.. command.Options.Where(o => o is not HelpOption).Select(o => new OptionHelp([o.Name, .. o.Aliases], o.ValueType == typeof(bool) ? null : o.HelpName ?? "VALUE", o.Description ?? "", o.ValueType.IsArray))]);
}
