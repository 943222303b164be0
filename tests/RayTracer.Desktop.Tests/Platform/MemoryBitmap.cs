using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Platform;

namespace RayTracer.Desktop.Tests;

/// <summary>Pixels in memory, as bitmaps of the stand-in have them.</summary>
internal sealed class MemoryBitmap(PixelSize size, PixelFormat format) : IWriteableBitmapImpl
{
    /// <summary>The pixels, four bytes each.</summary>
    public byte[] Bytes { get; } = new byte[4 * size.Width * size.Height];

    public Vector Dpi => new(96, 96);

    public PixelSize PixelSize => size;

    public int Version => 1;

    public PixelFormat? Format => format;

    public AlphaFormat? AlphaFormat => Avalonia.Platform.AlphaFormat.Unpremul;

    public ILockedFramebuffer Lock()
    {
        GCHandle pin = GCHandle.Alloc(Bytes, GCHandleType.Pinned);
        return new LockedFramebuffer(pin.AddrOfPinnedObject(), size, 4 * size.Width, Dpi, format, pin.Free);
    }

    public void Save(string fileName, int? quality = null) => throw new NotSupportedException();

    public void Save(Stream stream, int? quality = null) => throw new NotSupportedException();

    public void Dispose()
    {
    }
}
