using System.CommandLine;

namespace RayTracer.Cli;

/// <summary>The options of verbs that render, about what they tell meanwhile and at the end.</summary>
internal sealed class DisplayOptions
{
    private readonly Option<bool> _preview = new("--preview") { Description = "Shows the picture in the terminal while it renders, as view does." };
    private readonly Option<bool> _quiet = new("--quiet") { Description = "Prints errors and warnings only." };
    private readonly VerboseOption _verbose;
    private readonly Option<bool> _json = new("--json") { Description = "Prints one JSON object of numbers." };

    /// <summary>Gives a command the options.</summary>
    public DisplayOptions(Command command)
    {
        foreach (Option option in new Option[] { _preview, _quiet, _json })
        {
            command.Options.Add(option);
        }

        _verbose = new(command);
    }

    /// <summary>A request with what was asked for.</summary>
    public RenderRequest Put(ParseResult result, RenderRequest request) => request with
    {
        Preview = result.GetValue(_preview),
        Quiet = result.GetValue(_quiet),
        Verbose = _verbose.Value(result),
        Json = result.GetValue(_json),
    };

    /// <summary>A request without a preview where there is no terminal for it.</summary>
    public static RenderRequest ForTerminal(RenderRequest request, Streams streams)
    {
        if (!request.Preview || streams.HasTerminal)
        {
            return request;
        }

        streams.Warn("--preview: standard error is not a terminal that can show pictures, so nothing is shown");
        return request with { Preview = false };
    }
}
