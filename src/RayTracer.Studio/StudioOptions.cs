using System.Globalization;

namespace RayTracer.Studio;

/// <summary>The options of the Studio's command line.</summary>
internal sealed record StudioOptions
{
    /// <summary>The usage of the command line.</summary>
    public const string Usage = "usage: RayTracer.Studio [SCENE] [--plugin FILE] [--port N] [--no-browser] [--open app|browser]";

    /// <summary>The answer to --help.</summary>
    public const string Help = Usage + """


        Opens a window in which scenes are rendered, edited and inspected.

          SCENE                 a scene (.json, Mitsuba's .xml, pbrt's .pbrt), a model, a film (.rtfilm) or image of this program, or a share bundle (.zip);
                                without one, the gallery of shipped scenes is shown
          --plugin FILE         an assembly with more shapes, materials, textures, lights or formats; may be repeated
          --port N              the port of 127.0.0.1 to listen on; without it the one of the last time, or another one if that is taken
          --no-browser          print the address instead of opening a window
          --open app|browser    a window of its own (the default), or a tab of the default browser
          --help                this text

        The Studio ends when its last window is closed and no job runs, or with Ctrl-C. What was not saved is offered again the next time.
        """;

    /// <summary>Returns whether only the help is wanted.</summary>
    public bool IsHelp { get; init; }

    /// <summary>The scene or model to open; null for the empty state.</summary>
    public string? Scene { get; init; }

    /// <summary>The port to listen on, 0 for a free one; null for that of the last time, if it is free.</summary>
    public int? Port { get; init; }

    /// <summary>The browser to open the page in; null for none.</summary>
    public BrowserKind? Browser { get; init; } = BrowserKind.App;

    /// <summary>Reads a command line.</summary>
    /// <param name="args">The words after the program's name.</param>
    /// <param name="complaint">The fault of the arguments; null where there is none.</param>
    public static StudioOptions Parse(IReadOnlyList<string> args, out string? complaint)
    {
        StudioOptions options = new();
        complaint = null;
        for (int i = 0; i < args.Count && complaint is null; i++)
        {
            string? value = i + 1 < args.Count ? args[i + 1] : null;
            switch (args[i])
            {
                case "--port":
                    i++;
                    bool isPort = int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out int port) && port <= 65535;
                    complaint = isPort ? null : "--port: a number from 0 (for a free port) to 65535 is expected";
                    options = options with { Port = port };
                    break;
                case "--open":
                    i++;
                    complaint = value is "app" or "browser" ? null : "--open: app or browser is expected";
                    options = options with { Browser = value == "browser" ? BrowserKind.Default : BrowserKind.App };
                    break;
                case "--help" or "-h" or "-?":
                    return new() { IsHelp = true };
                case "--no-browser":
                    options = options with { Browser = null };
                    break;
                case ['-', _, ..] unknown:
                    complaint = $"unknown option \"{unknown}\"";
                    break;
                default:
                    complaint = options.Scene is null ? null : "only one scene can be opened";
                    options = options with { Scene = args[i] };
                    break;
            }
        }

        return options;
    }
}
