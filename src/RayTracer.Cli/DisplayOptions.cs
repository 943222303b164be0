using System.CommandLine;

namespace RayTracer.Cli;

/// <summary>The reports of a command, meanwhile and at the end.</summary>
/// <param name="Preview">True if the picture is shown in the terminal meanwhile.</param>
/// <param name="Quiet">True if nothing but errors and warnings is printed.</param>
/// <param name="Verbose">True if the stages are reported.</param>
/// <param name="Json">True if a JSON object is printed.</param>
internal sealed record Display(bool Preview = false, bool Quiet = false, bool Verbose = false, bool Json = false)
{
    /// <summary>The options that it is of, as far as they bear on the job.</summary>
    public string[] Options => [.. Preview ? new[] { "--preview" } : [], .. Json ? new[] { "--json" } : []];
}

/// <summary>The options of verbs that make pictures, about what they report meanwhile and at the end.</summary>
internal sealed class DisplayOptions
{
    private readonly Option<bool> _preview = new("--preview") { Description = "Shows the picture in the terminal while it renders, as view does." };
    private readonly Option<bool> _quiet = new("--quiet") { Description = "Prints errors and warnings only." };
    private readonly VerboseOption _verbose;
    private readonly Option<bool> _json = new("--json") { Description = "Prints one JSON object of numbers." };

    /// <summary>Gives a command the options.</summary>
    /// <param name="command">The command.</param>
    /// <param name="hasPreview">True if it shows its picture while it renders.</param>
    public DisplayOptions(Command command, bool hasPreview = true)
    {
        command.AddOptions(hasPreview ? [_preview, _quiet, _json] : [_quiet, _json]);
        _verbose = new(command);
    }

    /// <summary>The reports that were asked for.</summary>
    public Display Of(ParseResult result) =>
        new(result.GetValue(_preview), result.GetValue(_quiet), _verbose.Value(result), result.GetValue(_json));

    /// <summary>The times to report, if they were asked for, from now on.</summary>
    public StageTimes Times(ParseResult result, Streams streams) => _verbose.Times(result, streams);
}
