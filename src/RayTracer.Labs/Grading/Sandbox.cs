using System.ComponentModel;

namespace RayTracer.Labs;

/// <summary>
/// Runs commands by bubblewrap (bwrap): without network, without other processes, with the system's libraries and one folder to be seen, and nothing to be
/// written but that folder or a small one in memory; prlimit bounds memory, processor time and the length of files.
/// </summary>
/// <param name="programs">Folders of the programs that are to run, besides those of the system.</param>
internal sealed class Sandbox(params IReadOnlyList<string> programs)
{
    // The runtime commits what it takes from a heap of one gibibyte (CheckProcess), and its code and threads besides.
    private const string MostData = "--data=2147483648";
    private const string MostSeconds = "--cpu=300";
    private const string MostOfFile = "--fsize=33554432";
    private const string TemporaryBytes = "67108864";
    private static readonly string[] s_system = ["/usr", "/lib", "/lib64", "/bin", "/etc/ld.so.cache", "/etc/alternatives", "/etc/ssl/openssl.cnf"];

    /// <summary>Returns why nothing can be run in it here; null where it can.</summary>
    public static string? Obstacle()
    {
        if (!OperatingSystem.IsLinux())
        {
            return "bubblewrap exists for Linux only";
        }

        try
        {
            using BoundedProcess trial = new(new Sandbox().Wrap([], ["true"]));
            DateTime end = DateTime.UtcNow.AddSeconds(20);
            return trial.Finish(end) == 0 ? null : $"bwrap may not run here ({trial.FirstError})";
        }
        catch (Win32Exception)
        {
            return "bwrap is not installed (Debian and Ubuntu: apt-get install bubblewrap)";
        }
    }

    /// <summary>A command that writes into a folder and reads from another one.</summary>
    /// <param name="writable">The folder that is written.</param>
    /// <param name="readable">The folder that is read.</param>
    /// <param name="command">The command.</param>
    public IReadOnlyList<string> Writing(string writable, string readable, IReadOnlyList<string> command) =>
        Wrap(["--ro-bind", readable, readable, "--bind", writable, writable], command);

    /// <summary>A command that reads a folder, and writes nothing that stays.</summary>
    /// <param name="readable">The folder.</param>
    /// <param name="command">The command.</param>
    public IReadOnlyList<string> Reading(string readable, IReadOnlyList<string> command) => Wrap(["--ro-bind", readable, readable], command);

    private IReadOnlyList<string> Wrap(IEnumerable<string> folders, IReadOnlyList<string> command) =>
    [
        "bwrap", "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL", "--clearenv", "--setenv", "PATH", "/usr/bin:/bin",
        .. CheckProcess.Environment.SelectMany(v => new[] { "--setenv", v.Name, v.Value }),

        // The runtime wants a home, a folder for temporary files, and no diagnostics' pipes in it.
        "--setenv", "HOME", "/tmp", "--setenv", "DOTNET_CLI_HOME", "/tmp", "--setenv", "DOTNET_ROOT", Compiler.DotNet,
        "--proc", "/proc", "--dev", "/dev", "--size", TemporaryBytes, "--tmpfs", "/tmp",
        .. s_system.Concat(programs).SelectMany(p => new[] { "--ro-bind-try", p, p }),
        .. folders, "--chdir", "/tmp", "--", "prlimit", MostData, MostSeconds, MostOfFile, "--core=0", .. command,
    ];
}
