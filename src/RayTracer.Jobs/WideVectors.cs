using System.Numerics;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Text;

namespace RayTracer.Jobs;

/// <summary>
/// Makes <see cref="Vector{T}"/> 512 bits wide where the processor is. The runtime reads the setting only when it starts, so
/// the process replaces itself by the same program with the setting in its environment.
/// </summary>
public static unsafe partial class WideVectors
{
    /// <summary>The runtime's setting; where the user has set it, it is left alone.</summary>
    public const string Variable = "DOTNET_MaxVectorTBitWidth";

    // Decimal, unlike other settings of the runtime: with 200 it gives 4 lanes, with 400 it gives 8.
    private const string Width = "512";

    /// <summary>
    /// Replaces the process, which must have only just started, if that helps; returns where it does not, or cannot be done.
    /// </summary>
    /// <param name="args">The words after the program's name.</param>
    public static void Enable(string[] args)
    {
        if (Vector512.IsHardwareAccelerated && Vector<float>.Count == 8
            && (OperatingSystem.IsLinux() || OperatingSystem.IsMacOS())
            && Environment.GetEnvironmentVariable(Variable) is null
            && Environment.ProcessPath is { } program)
        {
            RemoveSockets();

            // If this returns, the process could not be replaced, and goes on with narrower vectors.
            Replace(program, args);
        }
    }

    // The runtime's sockets for debugging tools have names made of the process's number and time of start, which stay the
    // same: they would be in the way of the new ones, and be left over at the end.
    private static void RemoveSockets()
    {
        try
        {
            // Of another process of that number, in a container that shares the folder, the socket is older.
            DateTime start = System.Diagnostics.Process.GetCurrentProcess().StartTime.ToUniversalTime().AddSeconds(-1);
            foreach (string socket in Directory.EnumerateFiles(Path.GetTempPath(), $"dotnet-diagnostic-{Environment.ProcessId}-*-socket"))
            {
                if (File.GetLastWriteTimeUtc(socket) >= start)
                {
                    File.Delete(socket);
                }
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // Then they are left over, and debugging tools do not find the process; nothing else depends on them.
        }
    }

    private static void Replace(string program, string[] args)
    {
        bool isHosted = Path.GetFileNameWithoutExtension(program) == "dotnet";
        string[] words = isHosted ? [program, Assembly.GetEntryAssembly()!.Location, .. args] : [program, .. args];
        byte** argv = stackalloc byte*[words.Length + 1];
        for (int i = 0; i < words.Length; i++)
        {
            argv[i] = Native(words[i]);
        }

        argv[words.Length] = null;

        // setenv, because the runtime keeps its own copy of the environment, which a new program does not get.
        if (SetEnvironment(Native(Variable), Native(Width), 1) == 0)
        {
            _ = Execute(Native(program), argv);
        }
    }

    private static byte* Native(string text)
    {
        int length = Encoding.UTF8.GetByteCount(text);
        byte* bytes = (byte*)NativeMemory.Alloc((nuint)length + 1);
        Encoding.UTF8.GetBytes(text, new Span<byte>(bytes, length));
        bytes[length] = 0;
        return bytes;
    }

    [LibraryImport("libc", EntryPoint = "setenv")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static partial int SetEnvironment(byte* name, byte* value, int overwrite);

    [LibraryImport("libc", EntryPoint = "execv")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static partial int Execute(byte* path, byte** argv);
}
