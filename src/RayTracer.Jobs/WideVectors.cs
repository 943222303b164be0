using System.Numerics;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using System.Text;

namespace RayTracer.Jobs;

/// <summary>
/// Makes <see cref="Vector{T}"/> 512 bits wide where the processor is, and has long renders compile their code once, in full (decision 007). The runtime
/// reads both settings only when it starts, so the process replaces itself by the same program with them in its environment.
/// </summary>
public static unsafe partial class WideVectors
{
    /// <summary>The runtime's setting, in decimal; where the user has set it, it is left alone.</summary>
    public const string Variable = "DOTNET_MaxVectorTBitWidth";

    /// <summary>
    /// The runtime's setting of how wide registers it prefers, in decimal: 256 on older Xeons, as a core that uses 512 may lower its clock.
    /// Renders gain all the same.
    /// </summary>
    public const string Preference = "DOTNET_PreferredVectorBitWidth";

    /// <summary>The runtime's setting of whether code is compiled in tiers, in digits; where the user has set it, it is left alone.</summary>
    public const string Tiers = "DOTNET_TieredCompilation";

    // Fewer paths do not gain by wider registers, and code that is compiled once, what the restart takes (decision 006).
    private const long FewestPaths = 4_000_000;

    // Of a program that may still be replaced.
    private static string[]? s_args;

    /// <summary>The number of lanes that the processor's registers have; 0 where it is not known how to make them that wide.</summary>
    public static int Widest => !CanReplace ? 0
        : Vector512.IsHardwareAccelerated || (Avx512F.IsSupported && Avx512BW.VL.IsSupported && Avx512DQ.VL.IsSupported) ? 16
        : Vector256.IsHardwareAccelerated ? 8 : 0;

    // In programs that are compiled ahead, what runs often is optimised by the second tier alone.
    private static bool MayLeaveTiers => AppContext.TryGetSwitch("System.Runtime.TieredCompilation", out bool isTiered) && isTiered
        && !(AppContext.TryGetSwitch("RayTracer.IsCompiledAhead", out bool isAhead) && isAhead) && Environment.GetEnvironmentVariable(Tiers) is null;

    private static bool CanReplace => (OperatingSystem.IsLinux() || OperatingSystem.IsMacOS()) && Environment.ProcessPath is not null;

    /// <summary>
    /// Replaces the process, which must have only just started, if that helps a long render; returns where it does not, or cannot be done.
    /// </summary>
    /// <param name="args">The words after the program's name.</param>
    public static void Enable(string[] args) =>
        Enable(args, Environment.GetEnvironmentVariable(Variable) is null && Environment.GetEnvironmentVariable(Preference) is null ? Widest : 0, isLong: true);

    /// <summary>Replaces the process, which must have only just started, if it has another number of lanes.</summary>
    /// <param name="args">The words after the program's name.</param>
    /// <param name="lanes">The number of lanes: 8, 16 where <see cref="Widest"/> is that, or 0 for those that it has.</param>
    /// <param name="isLong">True if code is to be compiled once, in full.</param>
    public static void Enable(string[] args, int lanes, bool isLong)
    {
        lanes = lanes == 0 ? Vector<float>.Count : lanes;
        bool leavesTiers = isLong && MayLeaveTiers;
        if (CanReplace && (leavesTiers || (Vector<float>.Count != lanes && Environment.GetEnvironmentVariable(Variable) != $"{32 * lanes}")))
        {
            RemoveSockets();

            // If this returns, the process could not be replaced, and goes on with what it has.
            Replace(Environment.ProcessPath!, args, $"{32 * lanes}", leavesTiers);
        }
    }

    /// <summary>Leaves the replacement to <see cref="EnableFor"/>, which knows how much there is to do.</summary>
    /// <param name="args">The words after the program's name.</param>
    public static void Postpone(string[] args) => s_args = args;

    /// <summary>
    /// Replaces the process if that was postponed and is worth it; nothing may have been written yet. A short render is over before the
    /// program has started again.
    /// </summary>
    /// <param name="paths">The number of paths to render.</param>
    public static void EnableFor(long paths)
    {
        if (s_args is { } args && paths >= FewestPaths)
        {
            s_args = null;
            Enable(args);
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

    private static void Replace(string program, string[] args, string width, bool leavesTiers)
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
        if (SetEnvironment(Native(Variable), Native(width), 1) == 0 && SetEnvironment(Native(Preference), Native(width), 1) == 0
            && (!leavesTiers || SetEnvironment(Native(Tiers), Native("0"), 1) == 0))
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
