using System.CommandLine;

namespace RayTracer.Cli;

/// <summary><c>raytracer completion SHELL</c></summary>
internal static class CompletionVerb
{
    public static void Build(Command command, Streams streams)
    {
        Argument<string> shell = new(string.Join('|', ShellCompletion.Shells)) { Description = "The shell." };
        command.Arguments.Add(shell);
        command.SetAction(result =>
        {
            string name = result.GetValue(shell)!;
            streams.Output.Write(ShellCompletion.Script(name, CommandLine.Help(streams)) ?? throw new CommandException(
                ExitStatus.Usage, $"unknown shell {Description.Quotation.Of(name)}{Description.Spelling.DidYouMean(name, ShellCompletion.Shells)}, expected one of {string.Join(", ", ShellCompletion.Shells)}"));
        });
    }
}
