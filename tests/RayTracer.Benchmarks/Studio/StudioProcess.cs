using System.Diagnostics;
using System.Globalization;

namespace RayTracer.Benchmarks.Studio;

/// <summary>A Studio in a process of its own, as a user starts it, but without a window.</summary>
internal sealed class StudioProcess : IDisposable
{
    private readonly Process _process;
    private readonly DirectoryInfo _user = Directory.CreateTempSubdirectory("studio-bench-");

    private StudioProcess(string scene)
    {
        ProcessStartInfo start = new("dotnet", [Program("RayTracer.Studio", "RayTracer.Studio.dll"), scene, "--no-browser"]) { RedirectStandardOutput = true, UseShellExecute = false };
        start.Environment["XDG_STATE_HOME"] = Path.Combine(_user.FullName, "state");
        start.Environment["XDG_CACHE_HOME"] = Path.Combine(_user.FullName, "cache");
        _process = Process.Start(start)!;
        string line = _process.StandardOutput.ReadLine() ?? throw new InvalidOperationException("The Studio did not start.");
        Link = line[line.IndexOf("http", StringComparison.Ordinal)..];
    }

    /// <summary>The page's address with the secret.</summary>
    public string Link { get; }

    /// <summary>Memory in use, in MiB; 0 where the system does not tell.</summary>
    public double MemoryMiB
    {
        get
        {
            string? line = File.Exists($"/proc/{_process.Id}/status") ? File.ReadLines($"/proc/{_process.Id}/status").FirstOrDefault(l => l.StartsWith("VmRSS", StringComparison.Ordinal)) : null;
            return line is null ? 0 : double.Parse(line.Split(' ', StringSplitOptions.RemoveEmptyEntries)[1], CultureInfo.InvariantCulture) / 1024;
        }
    }

    /// <summary>Starts one.</summary>
    public static StudioProcess Start(string scene) => new(scene);

    /// <summary>The built program of a project.</summary>
    public static string Program(string project, string file) => RayTracer.Testing.ProjectFolder.PathOf("src", project, "bin", "Release", "net10.0", file);

    /// <inheritdoc/>
    public void Dispose()
    {
        _process.Kill(entireProcessTree: true);
        _process.WaitForExit();
        _process.Dispose();
        _user.Delete(recursive: true);
    }
}
