using System.Diagnostics;

namespace RayTracer.Mutations;

/// <summary>A copy of the repository in which mutants are built and tested.</summary>
internal sealed class Workshop : IDisposable
{
    private static readonly string[] s_testProjects =
    [
        "RayTracer.Tests", "RayTracer.RenderTests", "RayTracer.Scenes.Tests", "RayTracer.Import.Tests", "RayTracer.Textbook.Tests", "RayTracer.Imaging.Tests", "RayTracer.Cli.Tests",
        "RayTracer.Adapters.Tests", "RayTracer.Session.Tests", "RayTracer.Labs.Tests", "RayTracer.Repository.Tests",
    ];

    private readonly string _root;
    private readonly string _project;

    /// <summary>Clones the last commit of a repository, and builds it.</summary>
    /// <exception cref="InvalidOperationException">It cannot be built.</exception>
    public Workshop(string repository)
    {
        _root = Directory.CreateTempSubdirectory("raytracer-mutants-").FullName;
        _project = Path.Combine(_root, "project");
        Demand(Run("git", ["clone", "-q", repository, _project], _root), "the repository cannot be cloned");

        // References of other renderers lie beside the project.
        string shared = Path.Combine(repository, "..", "shared");
        if (Directory.Exists(shared))
        {
            Directory.CreateSymbolicLink(Path.Combine(_root, "shared"), Path.GetFullPath(shared));
        }

        // All projects: on a machine that does other things, that takes long.
        Demand(Run("dotnet", ["build", "-c", "Release", "-v", "q"], _project, TimeSpan.FromMinutes(40)), "the repository cannot be built");
    }

    public void Dispose() => Directory.Delete(_root, recursive: true);

    /// <summary>Path of a file of the copy.</summary>
    public string PathOf(string file) => Path.Combine(_project, file);

    /// <summary>Builds the assembly of a source file and puts it where the tests look for it; false if it does not compile.</summary>
    public bool Build(string file)
    {
        string folder = PathOf(Path.Combine([.. file.Split('/')[..2]]));
        if (Run("dotnet", ["build", folder, "-c", "Release", "-v", "q", "--no-restore", "-p:RunAnalyzers=false", "-p:TreatWarningsAsErrors=false"], _project).ExitCode != 0)
        {
            return false;
        }

        foreach (string built in Directory.GetFiles(Output(folder), "*.dll"))
        {
            foreach (string target in s_testProjects.Select(p => Path.Combine(Output(PathOf($"tests/{p}")), Path.GetFileName(built))))
            {
                if (File.Exists(target))
                {
                    File.Copy(built, target, overwrite: true);
                }
            }
        }

        return true;
    }

    /// <summary>
    /// Runs tests, project by project until some fail; returns the names of those, or says that they did not come to an end.
    /// </summary>
    /// <param name="filter">Which tests, as <c>dotnet test --filter</c> takes it.</param>
    /// <param name="limit">How long they may take.</param>
    public IReadOnlyList<string> FailingTests(string filter, TimeSpan limit) =>
        s_testProjects.Select(project => FailingTests(project, filter, limit)).FirstOrDefault(failed => failed.Count > 0, []);

    private List<string> FailingTests(string project, string filter, TimeSpan limit)
    {
        string assembly = Path.Combine(Output(PathOf($"tests/{project}")), project + ".dll");
        (int exitCode, string output) = Run("dotnet", ["test", assembly, "--filter", filter], _project, limit);
        if (exitCode == 0)
        {
            return [];
        }

        // A line like "  Failed Namespace.Class.Test(arguments) [12 ms]".
        List<string> failed = [.. output.Split('\n')
            .Where(l => l.StartsWith("  Failed ", StringComparison.Ordinal))
            .Select(l => l[9..l.LastIndexOf('[')].Trim())];
        return failed.Count > 0 ? failed : [exitCode == -1 ? $"{project} did not come to an end" : $"{project} crashed"];
    }

    private static string Output(string folder) => Path.Combine(folder, "bin", "Release", "net10.0");

    private static void Demand((int ExitCode, string Output) result, string complaint)
    {
        if (result.ExitCode != 0)
        {
            throw new InvalidOperationException($"{complaint}:\n{result.Output}");
        }
    }

    private static (int ExitCode, string Output) Run(string program, string[] arguments, string folder, TimeSpan? limit = null)
    {
        ProcessStartInfo start = new(program, arguments)
        {
            WorkingDirectory = folder,
            UseShellExecute = false,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        using Process process = Process.Start(start)!;
        Task<string> output = process.StandardOutput.ReadToEndAsync();
        Task<string> errors = process.StandardError.ReadToEndAsync();
        if (!process.WaitForExit(limit ?? TimeSpan.FromMinutes(10)))
        {
            process.Kill(entireProcessTree: true);
            return (-1, "");
        }

        return (process.ExitCode, output.Result + errors.Result);
    }
}
