using System.Diagnostics;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;

namespace RayTracer.Labs;

/// <summary>
/// The compiler of the .NET SDK. It is called itself, without a project, so that a hand-in can bring nothing but C#: the project files of others can run
/// any command.
/// </summary>
internal static partial class Compiler
{
    // What ImplicitUsings adds to a project, and the usings of a lab's project.
    private static readonly string[] s_usings =
    [
        "System", "System.IO", "System.Linq", "System.Collections.Generic", "System.Net.Http", "System.Threading", "System.Threading.Tasks",
        .. LabFolder.Usings,
    ];

    /// <summary>The folder of .NET that this program runs on.</summary>
    public static string DotNet { get; } = Path.GetFullPath(Path.Combine(RuntimeEnvironment.GetRuntimeDirectory(), "..", "..", ".."));

    /// <summary>The libraries that labs are compiled against: they lie beside this program.</summary>
    /// <exception cref="LabException">They do not: the program is a single file.</exception>
    public static IReadOnlyList<string> Libraries { get; } = [.. new[] { "RayTracer.Core", "RayTracer.Textbook", "RayTracer.Labs" }.Select(n => Path.Combine(AppContext.BaseDirectory, $"{n}.dll"))];

    /// <summary>Returns the command that compiles files to an assembly. It writes files into the folder of the assembly.</summary>
    /// <param name="sources">The files.</param>
    /// <param name="assembly">The assembly to write.</param>
    /// <exception cref="LabException">There is no SDK.</exception>
    public static IReadOnlyList<string> Command(IEnumerable<string> sources, string assembly)
    {
        string references = Newest("packs/Microsoft.NETCore.App.Ref", "ref/net10.0", "System.Runtime.dll");
        string usings = Path.ChangeExtension(assembly, ".Usings.cs");
        File.WriteAllLines(usings, s_usings.Select(u => $"global using {u};"));
        string arguments = Path.ChangeExtension(assembly, ".rsp");
        File.WriteAllLines(arguments,
        [
            "-target:library", "-nologo", "-noconfig", "-optimize+", "-debug:embedded", "-nullable:enable", "-langversion:latest", "-preferreduilang:en",

            // A type of the same name as one of the libraries would take its place in the checks, too.
            "-warn:1", "-warnaserror+:CS0436", "-utf8output", $"-out:\"{assembly}\"",
            .. Directory.GetFiles(references, "*.dll").Concat(Libraries).Select(r => $"-reference:\"{r}\""),
            .. sources.Append(usings).Select(s => $"\"{s}\""),
        ]);
        return [Path.Combine(DotNet, "dotnet"), "exec", Path.Combine(Newest("sdk", "Roslyn/bincore", "csc.dll"), "csc.dll"), $"@{arguments}"];
    }

    /// <summary>Compiles.</summary>
    /// <param name="command">What <see cref="Command"/> returned, or what runs that in a sandbox.</param>
    /// <param name="limit">How long it may take.</param>
    /// <returns>The errors, each with file, line and column; none where it is done.</returns>
    public static IReadOnlyList<string> Run(IReadOnlyList<string> command, TimeSpan limit)
    {
        using BoundedProcess compiler = new(command);
        DateTime end = DateTime.UtcNow + limit;
        List<string> lines = [];
        while (compiler.ReadLine(end) is { } line)
        {
            lines.Add(line);
        }

        int? status = compiler.Finish(end);
        string[] errors = [.. lines.Select(l => Error().Match(l)).Where(m => m.Success).Select(m => $"{Path.GetFileName(m.Groups["file"].Value)}:{m.Groups["line"].Value}:{m.Groups["column"].Value}: {m.Groups["message"].Value}").Distinct()];
        return status == 0 ? [] : errors.Length > 0 ? errors
            : [status is null ? $"the compiler took longer than {limit.TotalSeconds:0} seconds" : $"the compiler failed: {string.Join(' ', lines.Append(compiler.FirstError)).Trim()}"];
    }

    // The folder below the newest version that has a file.
    private static string Newest(string folder, string below, string file)
    {
        string parent = Path.Combine(DotNet, folder);
        return (Directory.Exists(parent) ? Directory.GetDirectories(parent) : [])
            .Select(d => (Folder: Path.Combine(d, below), Version: Version.TryParse(Path.GetFileName(d).Split('-')[0], out Version? v) ? v : new()))
            .Where(d => File.Exists(Path.Combine(d.Folder, file)))
            .MaxBy(d => d.Version).Folder
            ?? throw new LabException($"labs need the .NET 10 SDK: there is no {folder} with {below} in {DotNet}");
    }

    [GeneratedRegex(@"^(?<file>.*)\((?<line>\d+),(?<column>\d+)\): error (?<message>.*)$", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Error();
}
