using System.Runtime.InteropServices;

namespace RayTracer.Cli;

/// <summary>Signals to other processes, on Unix.</summary>
internal static partial class Signals
{
    /// <summary>SIGTERM, which POSIX numbers 15 on every system.</summary>
    public const int Terminate = 15;

    /// <summary>Sends a signal; 0 if that is done.</summary>
    [LibraryImport("libc", EntryPoint = "kill")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    public static partial int Send(int process, int signal);
}
