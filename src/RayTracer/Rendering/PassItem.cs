namespace RayTracer.Rendering;

/// <summary>A piece of a pass, which one thread renders.</summary>
/// <param name="Cell">The cell that its pixels are in.</param>
/// <param name="Tile">The pixels, unless there are single ones.</param>
/// <param name="Pixels">The numbers of single pixels; nothing for those of the tile.</param>
/// <param name="Samples">The samples of each pixel.</param>
internal readonly record struct PassItem(PassCell Cell, Tile Tile, ReadOnlyMemory<int> Pixels, SampleRange Samples)
{
    /// <summary>The number of pixels.</summary>
    public int Count => Pixels.IsEmpty ? Tile.Pixels : Pixels.Length;

    /// <summary>The number of paths.</summary>
    public long Paths => (long)Count * Samples.Count;
}
