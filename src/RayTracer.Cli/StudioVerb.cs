using System.CommandLine;
using System.Diagnostics;
using System.Globalization;

namespace RayTracer.Cli;

/// <summary><c>raytracer studio [SCENE]</c>: starts the Studio, a program of its own, and ends with it.</summary>
internal static class StudioVerb
{
    private const string Program = "RayTracer.Studio.dll";

    public static void Build(Command command, Streams streams)
    {
        Argument<string?> scene = new("SCENE") { Description = "The scene (native, or of Mitsuba) or model file to open; without it, a new scene.", Arity = ArgumentArity.ZeroOrOne };
        ParsedOption<long?> port = OptionValues.Integer("--port", "The port to listen on; without it, a free one.", 0, 65535);
        Option<bool> noBrowser = new("--no-browser") { Description = "Opens no window, and prints the address only." };
        command.Arguments.Add(scene);
        command.Options.Add(port.Symbol);
        command.Options.Add(noBrowser);
        command.SetAction(result =>
        {
            List<string> words = [];
            if (result.GetValue(scene) is { } path)
            {
                words.Add(path);
            }

            if (port.Value(result) is { } number)
            {
                words.AddRange(["--port", number.ToString(CultureInfo.InvariantCulture)]);
            }

            if (result.GetValue(noBrowser))
            {
                words.Add("--no-browser");
            }

            return Run([.. words, .. PluginOption.Words(result)], streams);
        });
    }

    // A signal ends both. What a terminal sends with Ctrl-C reaches the Studio by itself too; twice is no more than once.
    private static int Run(IEnumerable<string> words, Streams streams)
    {
        string program = Path.Combine(AppContext.BaseDirectory, Program);
        string single = Path.Combine(AppContext.BaseDirectory, OperatingSystem.IsWindows() ? "RayTracer.Studio.exe" : "RayTracer.Studio");
        bool isHosted = File.Exists(program);
        if (!isHosted && !File.Exists(single))
        {
            throw new CommandException(ExitStatus.InputOutput, $"the Studio is not beside the command: there is no '{program}'");
        }

        using StopSignals signals = new(streams);
        using Process studio = Process.Start(new ProcessStartInfo(isHosted ? Host() : single, isHosted ? [program, .. words] : words) { UseShellExecute = false })!;
        using CancellationTokenRegistration registration = signals.Token.Register(() => Stop(studio));
        studio.WaitForExit();
        return signals.Status != 0 ? signals.Status : studio.ExitCode;
    }

    // The program that runs the command where that is "dotnet", or else that of the runtime that the command runs on.
    private static string Host()
    {
        string runtime = System.Runtime.InteropServices.RuntimeEnvironment.GetRuntimeDirectory();
        string name = OperatingSystem.IsWindows() ? "dotnet.exe" : "dotnet";
        string host = Path.GetFullPath(Path.Combine(runtime, "..", "..", "..", name));
        return Environment.ProcessPath is { } path && Path.GetFileNameWithoutExtension(path) == "dotnet" ? path : File.Exists(host) ? host : name;
    }

    private static void Stop(Process studio)
    {
        if (!OperatingSystem.IsWindows() && !studio.HasExited)
        {
            _ = Signals.Send(studio.Id, Signals.Terminate);
        }
    }
}
