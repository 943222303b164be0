using System.Runtime.InteropServices;

namespace RayTracer.Acceleration;

/// <summary>
/// Memory outside the managed heap, freed with its owner. Large blocks ask for large pages: a tree of a gigabyte that is read at
/// random would otherwise spend much of its time on address translation.
/// </summary>
internal sealed unsafe partial class NativeMemoryBlock : SafeHandle
{
    private const nuint LargePage = 2 << 20;
    private const int AdviseLargePages = 14;
    private static long s_inUse;

    /// <summary>Takes memory, whose contents are undefined.</summary>
    /// <param name="bytes">The size in bytes; a cache line more may be read behind it.</param>
    /// <exception cref="OutOfMemoryException">There is not so much memory.</exception>
    public NativeMemoryBlock(long bytes)
        : base(0, ownsHandle: true)
    {
        Bytes = bytes;
        nuint size = (nuint)bytes + 128;
        bool large = size >= LargePage;
        size = large ? (size + LargePage - 1) & ~(LargePage - 1) : size;
        SetHandle((nint)NativeMemory.AlignedAlloc(size, large ? LargePage : 64));
        if (large && OperatingSystem.IsLinux())
        {
            // A refusal costs speed only.
            _ = Advise(Pointer, size, AdviseLargePages);
        }

        GC.AddMemoryPressure(Math.Max(1, bytes));
        Interlocked.Add(ref s_inUse, bytes);
    }

    /// <summary>Bytes in all blocks that have not been freed.</summary>
    public static long InUse => Interlocked.Read(ref s_inUse);

    /// <summary>The first byte, at the beginning of a cache line.</summary>
    public byte* Pointer => (byte*)handle;

    /// <summary>Size in bytes.</summary>
    public long Bytes { get; }

    public override bool IsInvalid => handle == 0;

    protected override bool ReleaseHandle()
    {
        NativeMemory.AlignedFree((void*)handle);
        GC.RemoveMemoryPressure(Math.Max(1, Bytes));
        Interlocked.Add(ref s_inUse, -Bytes);
        return true;
    }

    [LibraryImport("libc", EntryPoint = "madvise")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static partial int Advise(void* address, nuint length, int advice);
}
