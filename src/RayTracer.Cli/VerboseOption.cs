using System.CommandLine;

namespace RayTracer.Cli;

/// <summary>The option <c>--verbose</c> of verbs whose work has stages.</summary>
internal sealed class VerboseOption
{
    private readonly Option<bool> _option = new("--verbose") { Description = "Reports how long each stage takes (load, build, render, write), and the peak memory use." };

    /// <summary>Gives a command the option; after its other options, as help shows them in that order.</summary>
    public VerboseOption(Command command)
    {
        command.Options.Add(_option);
        command.Validators.Add(result =>
        {
            if (result.GetValue(_option) && command.Options.OfType<Option<bool>>().FirstOrDefault(o => o.Name == "--quiet") is { } quiet
                && result.GetValue(quiet))
            {
                result.AddError("--quiet and --verbose cannot go together");
            }
        });
    }

    /// <summary>Returns whether it was given.</summary>
    public bool Value(ParseResult result) => result.GetValue(_option);

    /// <summary>The times to report, if it was given, from now on.</summary>
    public StageTimes Times(ParseResult result, Streams streams) => new(Value(result) ? streams : null);
}
