using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using System.Reflection;

namespace RayTracer.Cli;

/// <summary><c>raytracer studio [SCENE]</c>: starts the Studio, a separate program, and ends with it.</summary>
internal static class StudioVerb
{
    private const string Program = "RayTracer.Studio";

    public static void Build(Command command, Streams streams)
    {
        Argument<string?> scene = new("SCENE") { Description = "The scene (native, Mitsuba or pbrt) or model file to open. Default: a new scene.", Arity = ArgumentArity.ZeroOrOne };
        ParsedOption<long?> port = OptionValues.Integer("--port", "The port to listen on. Default: a free one.", 0, 65535);
        Option<bool> noBrowser = new("--no-browser") { Description = "Opens no window; only prints the address." };
        command.Arguments.Add(scene);
        command.AddOptions(port, noBrowser);
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
        string program = Find();
        bool isHosted = program.EndsWith(".dll", StringComparison.Ordinal);
        using StopSignals signals = new(streams);
        using Process studio = Process.Start(new ProcessStartInfo(isHosted ? Host() : program, isHosted ? [program, .. words] : words) { UseShellExecute = false })!;
        using CancellationTokenRegistration registration = signals.Token.Register(() => Stop(studio));
        studio.WaitForExit();
        return signals.Status != 0 ? signals.Status : studio.ExitCode;
    }

    // Beside the command, as in the tool's package and among single files, or where its project is built to.
    private static string Find()
    {
        string beside = Path.Combine(AppContext.BaseDirectory, Program);
        Dictionary<string, string?> built = typeof(StudioVerb).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>()
            .ToDictionary(a => a.Key, a => a.Value, StringComparer.Ordinal);
        string? project = built.TryGetValue("StudioProject", out string? relative) ? Path.GetFullPath(relative!, AppContext.BaseDirectory)
            : null;
        string configuration = built.GetValueOrDefault("Configuration") ?? "Release";
        string?[] places =
        [
            $"{beside}.dll",
            OperatingSystem.IsWindows() ? $"{beside}.exe" : beside,
            project is null ? null : Path.Combine(project, "bin", configuration, Path.GetFileName(Path.TrimEndingDirectorySeparator(AppContext.BaseDirectory)), $"{Program}.dll"),
        ];
        return places.FirstOrDefault(File.Exists) ?? throw new CommandException(ExitStatus.InputOutput, Directory.Exists(project)
            ? $"the Studio is not built: \"dotnet build -c {configuration} {Path.TrimEndingDirectorySeparator(project)}\" builds it"
            : $"the Studio is not installed beside the command: there is no '{beside}'");
    }

    // The program that runs the command where that is "dotnet", or else that of the runtime that the command runs on.
    private static string Host()
    {
        string runtime = System.Runtime.InteropServices.RuntimeEnvironment.GetRuntimeDirectory();
        string name = OperatingSystem.IsWindows() ? "dotnet.exe" : "dotnet";
        string host = Path.GetFullPath(Path.Combine(runtime, "..", "..", "..", name));
        return Environment.ProcessPath is { } path && Path.GetFileNameWithoutExtension(path) == "dotnet" ? path
            : File.Exists(host) ? host : name;
    }

    private static void Stop(Process studio)
    {
        if (!OperatingSystem.IsWindows() && !studio.HasExited)
        {
            _ = Signals.Send(studio.Id, Signals.Terminate);
        }
    }
}
