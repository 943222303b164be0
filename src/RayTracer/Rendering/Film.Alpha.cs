using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>What a film knows of what is behind everything.</summary>
public sealed partial class Film
{
    /// <summary>
    /// The share of a pixel that something is seen in: 0 where there is nothing but what is behind everything. With a pixel filter that is negative
    /// in parts, it may lie outside of 0 to 1. 0 where there are no samples.
    /// </summary>
    /// <param name="x">Column, from the left.</param>
    /// <param name="y">Row, from the top.</param>
    /// <exception cref="ArgumentException">The film has no <see cref="FilmPlane.Alpha"/>.</exception>
    internal float Alpha(int x, int y)
    {
        long pixel = Index(x, y);
        return _counts[pixel] == 0 ? 0 : (float)(1 - (ToDouble(BackdropSums(pixel)[0]) / (ChannelUnits * _counts[pixel])));
    }

    /// <summary>The part of a pixel's <see cref="Mean"/> that comes from behind everything.</summary>
    /// <inheritdoc cref="Alpha"/>
    internal Rgb Backdrop(int x, int y)
    {
        long pixel = Index(x, y);
        double scale = _counts[pixel] == 0 ? 0 : 1 / (ChannelUnits * _counts[pixel]);
        ReadOnlySpan<Int128> sums = BackdropSums(pixel);
        return new((float)(ToDouble(sums[1]) * scale), (float)(ToDouble(sums[2]) * scale), (float)(ToDouble(sums[3]) * scale));
    }

    /// <summary>Adds to <see cref="FilmPlane.Alpha"/> of pixels in a row, or takes away from it.</summary>
    /// <param name="x">Column of the first pixel.</param>
    /// <param name="y">Row.</param>
    /// <param name="sums">The plane's sums of each pixel.</param>
    /// <param name="sign">1 to add, −1 to take away.</param>
    internal void AddBackdrop(int x, int y, ReadOnlySpan<long> sums, int sign = 1)
    {
        Span<Int128> target = PlaneRow(FilmPlane.Alpha, Index(x, y), sums.Length);
        for (int i = 0; i < sums.Length; i++)
        {
            target[i] += sign * sums[i];
        }
    }

    private ReadOnlySpan<Int128> BackdropSums(long pixel) => PlaneRow(FilmPlane.Alpha, pixel, FilmPlane.Alpha.Sums.Count);
}
