using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>What a film knows of what is behind everything, and of what stands for things of a photograph.</summary>
public sealed partial class Film
{
    /// <summary>
    /// The share of a pixel that something is seen in: 0 where there is nothing but what is behind everything. With a pixel filter that is negative
    /// in parts, it may lie outside of 0 to 1. 0 where there are no samples. A shadow on a catcher counts by the part of the light that it takes.
    /// </summary>
    /// <param name="x">Column, from the left.</param>
    /// <param name="y">Row, from the top.</param>
    /// <exception cref="ArgumentException">The film has no <see cref="FilmPlane.Alpha"/>.</exception>
    internal float Alpha(int x, int y)
    {
        long pixel = Index(x, y);
        if (_counts[pixel] == 0)
        {
            return 0;
        }

        double seen = 1 - (ToDouble(PlaneSums(FilmPlane.Alpha, pixel)[0]) / (ChannelUnits * _counts[pixel]));
        return (float)(seen + Caught(pixel).Shadow);
    }

    /// <summary>The part of a pixel's <see cref="Mean"/> that comes from behind everything, or from what stands for things of a photograph.</summary>
    /// <inheritdoc cref="Alpha"/>
    internal Rgb Backdrop(int x, int y)
    {
        long pixel = Index(x, y);
        double scale = _counts[pixel] == 0 ? 0 : 1 / (ChannelUnits * _counts[pixel]);
        ReadOnlySpan<Int128> sums = PlaneSums(FilmPlane.Alpha, pixel);
        return new Rgb((float)(ToDouble(sums[1]) * scale), (float)(ToDouble(sums[2]) * scale), (float)(ToDouble(sums[3]) * scale)) + (Caught(pixel).Gain * -1);
    }

    /// <summary>Adds to a plane of <see cref="FilmPlane.OfSamples"/> of pixels in a row, or takes away from it.</summary>
    /// <param name="plane">The plane.</param>
    /// <param name="x">Column of the first pixel.</param>
    /// <param name="y">Row.</param>
    /// <param name="sums">The plane's sums of each pixel.</param>
    /// <param name="sign">1 to add, −1 to take away.</param>
    internal void AddToPlane(FilmPlane plane, int x, int y, ReadOnlySpan<long> sums, int sign = 1) => Add(PlaneRow(plane, Index(x, y), sums.Length), sums, sign);

    // On a shadow catcher, what is laid under the picture keeps the ratio of the light with all things to that without them; light that they add is added
    // (Debevec, "Rendering Synthetic Objects into Real Scenes", 1998, section 5.2: differential rendering).
    private (double Shadow, Rgb Gain) Caught(long pixel)
    {
        if (!Planes.Contains(FilmPlane.Matte) || PlaneSums(FilmPlane.Matte, pixel) is not [var caught, ..] sums || caught == 0)
        {
            return (0, Rgb.Black);
        }

        double scale = 1 / (ChannelUnits * _counts[pixel]);
        Rgb with = new((float)(ToDouble(sums[1]) * scale), (float)(ToDouble(sums[2]) * scale), (float)(ToDouble(sums[3]) * scale));
        Rgb alone = new((float)(ToDouble(sums[4]) * scale), (float)(ToDouble(sums[5]) * scale), (float)(ToDouble(sums[6]) * scale));
        double lost = (double)alone.Luminance - with.Luminance;
        return lost > 0
            ? (ToDouble(caught) * scale * Math.Min(1, lost / alone.Luminance), Rgb.Black)
            : (0, new(float.Max(0, with.R - alone.R), float.Max(0, with.G - alone.G), float.Max(0, with.B - alone.B)));
    }

    private ReadOnlySpan<Int128> PlaneSums(FilmPlane plane, long pixel) => PlaneRow(plane, pixel, plane.Sums.Count);
}
