using System.CommandLine;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>
/// The option <c>--plugin</c> of all verbs. Its files are loaded before the verb is made, whose options list what is known.
/// </summary>
internal static class PluginOption
{
    /// <summary>Gives a command, and those under it, the option; after its other options, as help shows them in that order.</summary>
    public static Command AddTo(Command command)
    {
        command.Options.Add(new Option<string[]>(PluginFile.Option)
        {
            Description = "Adds what a .NET assembly defines: shapes, materials, textures, and other things that scenes and options name. May be given several times.",
            HelpName = "FILE",
            Recursive = true,
        });
        return command;
    }

    /// <summary>The option's words as another program is given them.</summary>
    public static IEnumerable<string> Words(ParseResult result) =>
        (result.GetValue<string[]>(PluginFile.Option) ?? []).SelectMany(file => new[] { PluginFile.Option, Path.GetFullPath(file) });
}
