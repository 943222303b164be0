using System.Runtime.InteropServices;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Adds up the samples of one tile in 64-bit fixed point, which holds up to <see cref="MaxSamples"/> samples a pixel, before they
/// go to the film's 128-bit sums.
/// </summary>
internal sealed unsafe class SampleAccumulator(int maxPixels)
{
    /// <summary>Samples a pixel that fit: 64 · 2²⁴ · 2³² = 2⁶².</summary>
    public const int MaxSamples = 64;

    // A squared luminance below this fits 64 times into 64 bits; brighter samples go to the film at once.
    private const float SmallLuminance = 16;
    private readonly PinnedBuffer<long> _sums = new((long)maxPixels * Film.SumsPerPixel);
    private readonly PinnedBuffer<uint> _counts = new(maxPixels);
    private readonly List<BadSample> _bad = [];
    private Film _film = null!;
    private Tile _tile;

    /// <summary>Samples that were not finite, and so were left out.</summary>
    public long NonFinite { get; private set; }

    /// <summary>Samples that were clamped.</summary>
    public long Clamped { get; private set; }

    /// <summary>The first samples that were not finite.</summary>
    public IReadOnlyList<BadSample> Bad => _bad;

    /// <summary>Prepares for the samples of a tile.</summary>
    public void Begin(Film film, in Tile tile)
    {
        _film = film;
        _tile = tile;
        NativeMemory.Clear(_sums.Pointer, (nuint)tile.Pixels * Film.SumsPerPixel * sizeof(long));
        NativeMemory.Clear(_counts.Pointer, (nuint)tile.Pixels * sizeof(uint));
    }

    /// <summary>Adds one sample.</summary>
    /// <param name="pixel">The pixel's number in the tile.</param>
    /// <param name="sample">The sample's number, for the list of bad ones.</param>
    /// <param name="r">Red radiance.</param>
    /// <param name="g">Green radiance.</param>
    /// <param name="b">Blue radiance.</param>
    public void Add(int pixel, int sample, float r, float g, float b)
    {
        if (!(float.Abs(r) <= Film.SampleLimit && float.Abs(g) <= Film.SampleLimit && float.Abs(b) <= Film.SampleLimit))
        {
            if (!float.IsFinite(r) || !float.IsFinite(g) || !float.IsFinite(b))
            {
                NoteBad(pixel, sample, new(r, g, b));
                return;
            }

            Clamped++;
            r = float.Clamp(r, -Film.SampleLimit, Film.SampleLimit);
            g = float.Clamp(g, -Film.SampleLimit, Film.SampleLimit);
            b = float.Clamp(b, -Film.SampleLimit, Film.SampleLimit);
        }

        long* sums = _sums.Pointer + ((long)pixel * Film.SumsPerPixel);
        sums[0] += ToFixed(r * Film.ChannelUnits);
        sums[1] += ToFixed(g * Film.ChannelUnits);
        sums[2] += ToFixed(b * Film.ChannelUnits);
        float luminance = new Rgb(r, g, b).Luminance;
        double square = (double)luminance * luminance * Film.SquareUnits;
        if (luminance < SmallLuminance)
        {
            sums[Film.SquareSum] += ToFixed(square);
        }
        else
        {
            _film.AddSum(FilmPixel(pixel), Film.SquareSum, (Int128)double.Round(square));
        }

        _counts.Pointer[pixel]++;
    }

    /// <summary>Hands everything to the film.</summary>
    public void End()
    {
        for (int pixel = 0; pixel < _tile.Pixels; pixel++)
        {
            long target = FilmPixel(pixel);
            for (int i = 0; i < Film.SumsPerPixel; i++)
            {
                _film.AddSum(target, i, _sums.Pointer[(pixel * Film.SumsPerPixel) + i]);
            }

            _film.AddCount(target, _counts.Pointer[pixel]);
        }
    }

    // To the nearest unit; the conversion itself is exact because the caller's limits keep it within 63 bits.
    private static long ToFixed(double units) => double.ConvertToIntegerNative<long>(double.Round(units));

    private void NoteBad(int pixel, int sample, Rgb value)
    {
        NonFinite++;
        if (_bad.Count < RenderStatistics.MaxBadSamples)
        {
            (int x, int y) = _tile.Pixel(pixel);
            _bad.Add(new(x, y, sample, value));
        }
    }

    private long FilmPixel(int pixel)
    {
        (int x, int y) = _tile.Pixel(pixel);
        return ((long)y * _film.Width) + x;
    }
}
