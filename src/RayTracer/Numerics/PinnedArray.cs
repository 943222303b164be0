using System.Runtime.InteropServices;

namespace RayTracer.Numerics;

/// <summary>An array that stays where it is as long as this object lives, without a copy.</summary>
internal sealed unsafe class PinnedArray<T>
    where T : unmanaged
{
    // Kept, so that the array stays where it is; freed by its own finalizer.
    private readonly object _pin;

    /// <summary>Pins an array.</summary>
    public PinnedArray(T[] values)
    {
        Values = values;
        Pin pin = new(values);
        _pin = pin;
        Pointer = (T*)pin.Address;
    }

    /// <summary>The array.</summary>
    public T[] Values { get; }

    /// <summary>Memory of the array.</summary>
    public long Bytes => (long)Values.Length * sizeof(T);

    /// <summary>The first element.</summary>
    public T* Pointer { get; }

    private sealed class Pin : SafeHandle
    {
        public Pin(Array values)
            : base(0, ownsHandle: true) => SetHandle(GCHandle.ToIntPtr(GCHandle.Alloc(values, GCHandleType.Pinned)));

        public nint Address => GCHandle.FromIntPtr(handle).AddrOfPinnedObject();

        public override bool IsInvalid => handle == 0;

        protected override bool ReleaseHandle()
        {
            GCHandle.FromIntPtr(handle).Free();
            return true;
        }
    }
}
