using System.Text.Json;
using RayTracer.Cli;

namespace RayTracer.Cli.Tests;

/// <summary>What a command came to.</summary>
internal sealed record CliRun(int Status, string Output, string Error)
{
    /// <summary>A scene with a lamp, of 24×16 pixels.</summary>
    public const string Scene = """
        {
          "camera": { "position": [0, 1, 5], "lookAt": [0, 0.5, 0] },
          "render": { "integrator": "report", "width": 24, "height": 16, "samplesPerPixel": 4 },
          "background": "skyblue",
          "shapes": [
            { "type": "sphere", "center": [0, 0.5, 0], "radius": 0.5 },
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": { "type": "checker" } } },
            { "type": "sphere", "center": [2, 4, 1], "radius": 0.3, "material": { "type": "luminaire", "multiplier": 30 } }
          ]
        }
        """;

    /// <summary>Runs the command within this process.</summary>
    public static CliRun Of(params string[] args) => Of(args, hasTerminal: false);

    /// <summary>Runs the command within this process, as if standard error were a terminal.</summary>
    public static CliRun OnTerminal(params string[] args) => Of(args, hasTerminal: true);

    /// <summary>Runs a command that must succeed.</summary>
    public static CliRun Fine(params string[] args)
    {
        CliRun run = Of(args);
        Assert.True(run.Status == 0, run.Error);
        return run;
    }

    /// <summary>Runs a command that must fail with a status, and a message that holds a text.</summary>
    public static void Refused(int status, string message, params string[] args)
    {
        CliRun run = Of(args);
        Assert.Equal(status, run.Status);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
    }

    /// <summary>The hash of the film that a command with <c>--json</c> comes to.</summary>
    public static string FilmHash(params string[] args) => JsonDocument.Parse(Fine(args).Output).RootElement.GetProperty("filmHash").GetString()!;

    private static CliRun Of(string[] args, bool hasTerminal)
    {
        using StringWriter output = new();
        using StringWriter error = new();
        int status = CommandLine.Run(args, new(output, error, hasTerminal));
        return new(status, output.ToString(), error.ToString());
    }
}
