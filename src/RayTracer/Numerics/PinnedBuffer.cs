using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

/// <summary>
/// Memory for lanes to load from and store to by pointer: it begins at a cache line, does not move, is zero at first, and lives
/// as long as this object.
/// </summary>
/// <typeparam name="T">A number, or a struct of registers.</typeparam>
internal sealed unsafe class PinnedBuffer<T>
    where T : unmanaged
{
    private const int Alignment = 64;
    private readonly T[] _memory;

    /// <summary>Takes the memory.</summary>
    /// <param name="length">The number of elements; a register's worth of further ones may be written behind them.</param>
    /// <exception cref="ArgumentOutOfRangeException">There cannot be that many elements (about 2³¹).</exception>
    public PinnedBuffer(long length)
    {
        long padded = length + ((3 * Alignment) + sizeof(T) - 1) / sizeof(T);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(padded, Array.MaxLength, nameof(length));
        _memory = GC.AllocateArray<T>((int)padded, pinned: true);
        byte* start = (byte*)Unsafe.AsPointer(ref _memory[0]);
        Pointer = (T*)(((nuint)start + (Alignment - 1)) / Alignment * Alignment);
    }

    /// <summary>The first element.</summary>
    public T* Pointer { get; }
}
