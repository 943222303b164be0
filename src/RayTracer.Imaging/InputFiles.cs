using System.Buffers.Binary;
using System.Collections.Concurrent;
using System.Runtime.InteropServices;
using System.Text;

namespace RayTracer.Imaging;

/// <summary>
/// The files that a command reads, none of which it may replace: <see cref="AtomicFile"/> refuses them, by whatever name or link they are
/// called. Readers add theirs to the innermost scope that is open where they run; where none is, nothing is kept.
/// </summary>
internal sealed partial class InputFiles : IDisposable
{
    private static readonly AsyncLocal<InputFiles?> s_open = new();
    private readonly InputFiles? _outer = s_open.Value;
    private readonly ConcurrentDictionary<string, bool> _paths = [];

    private InputFiles()
    {
    }

    /// <summary>Opens a scope within the one that is open; what is added ends with it.</summary>
    public static InputFiles Begin() => s_open.Value = new();

    /// <summary>Adds a file that is read.</summary>
    public static void Add(string path)
    {
        if (s_open.Value is { } open)
        {
            open._paths[Path.GetFullPath(path)] = true;
        }
    }

    /// <summary>Returns whether a file is one of those that are read.</summary>
    public static bool Contain(string path)
    {
        IEnumerable<string> paths = [];
        for (InputFiles? scope = s_open.Value; scope is not null; scope = scope._outer)
        {
            paths = paths.Concat(scope._paths.Keys);
        }

        return Identity(path) is { } identity && paths.Any(p => Identity(p) == identity);
    }

    /// <inheritdoc/>
    public void Dispose() => s_open.Value = _outer;

    // Device and inode, which all names and links of a file share; elsewhere than on Linux, the name itself. Null where there is no file.
    private static string? Identity(string path)
    {
        if (!File.Exists(path))
        {
            return null;
        }

        if (!OperatingSystem.IsLinux())
        {
            return (new FileInfo(path).ResolveLinkTarget(returnFinalTarget: true)?.FullName ?? Path.GetFullPath(path)).ToUpperInvariant();
        }

        const int here = -100, inode = 0x100, inodeAt = 32, deviceAt = 136;
        byte[] about = new byte[256];
        return Status(here, Encoding.UTF8.GetBytes(path + '\0'), 0, inode, about) != 0 ? null
            : $"{BinaryPrimitives.ReadUInt64LittleEndian(about.AsSpan(deviceAt))}:{BinaryPrimitives.ReadUInt64LittleEndian(about.AsSpan(inodeAt))}";
    }

    // statx(2), whose answer has the same layout on all processors, unlike that of stat(2).
    [LibraryImport("libc", EntryPoint = "statx")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static partial int Status(int folder, byte[] path, int flags, uint wanted, byte[] about);
}
