using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Adds up the samples of one tile in 64-bit fixed point, which holds up to <see cref="MaxSamples"/> samples a pixel, before they
/// go to the film's 128-bit sums.
/// </summary>
internal sealed unsafe class SampleAccumulator(int maxPixels)
{
    /// <summary>Samples a pixel that fit into 64 bits.</summary>
    public const int MaxSamples = 64;

    // 64 · 16² · 2⁴⁸ = 2⁶²; brighter samples go to the film at once.
    private const float OrdinaryLimit = 16;
    private const int HalfSums = Film.SumsPerPixel + 1;
    private readonly PinnedBuffer<long> _sums = new((long)maxPixels * Film.SumsPerPixel);
    private readonly PinnedBuffer<uint> _counts = new(maxPixels);
    private readonly PinnedBuffer<long> _units = new((long)Film.SumsPerPixel * FloatW.Count);
    private readonly PinnedBuffer<uint> _pixels = new(FloatW.Count);
    private readonly List<BadSample> _bad = [];
    private Film _film = null!;
    private Tile _tile;
    private ReadOnlyMemory<int> _targets;

    // Where the film keeps a half of the samples: bit i is whether the first sample and i more is one of it.
    private PinnedBuffer<long>? _halfSums;
    private ulong _half;
    private int _firstSample;

    /// <summary>Samples that were not finite, and so were left out.</summary>
    public long NonFinite { get; private set; }

    /// <summary>Samples that were clamped.</summary>
    public long Clamped { get; private set; }

    /// <summary>The first samples that were not finite.</summary>
    public IReadOnlyList<BadSample> Bad => _bad;

    /// <summary>Prepares for some samples of a tile, at most <see cref="MaxSamples"/> of a pixel.</summary>
    public void Begin(Film film, in Tile tile, SampleRange samples)
    {
        _film = film;
        _tile = tile;
        _targets = default;
        Clear(tile.Pixels, samples);
    }

    /// <summary>Prepares for the samples of single pixels.</summary>
    /// <param name="film">The film.</param>
    /// <param name="targets">The numbers of its pixels.</param>
    /// <param name="samples">The samples, at most <see cref="MaxSamples"/>.</param>
    public void BeginPixels(Film film, ReadOnlyMemory<int> targets, SampleRange samples)
    {
        _film = film;
        _targets = targets;
        Clear(targets.Length, samples);
    }

    /// <summary>Adds a packet of samples.</summary>
    /// <param name="count">Number of lanes in use.</param>
    /// <param name="pixels">The pixels' numbers in the tile.</param>
    /// <param name="samples">The samples' numbers, for the list of bad ones.</param>
    /// <param name="radiance">The samples.</param>
    public void Add(int count, UIntW pixels, UIntW samples, in RgbW radiance)
    {
        long* red = _units.Pointer;
        long* green = red + FloatW.Count;
        long* blue = green + FloatW.Count;
        long* square = blue + FloatW.Count;
        uint* pixel = _pixels.Pointer;
        FloatW luminance = FloatW.MultiplyAdd(0.0722f, radiance.B, FloatW.MultiplyAdd(0.7152f, radiance.G, radiance.R * 0.2126f));
        ToChannelUnits(radiance.R, red);
        ToChannelUnits(radiance.G, green);
        ToChannelUnits(radiance.B, blue);
        ToSquareUnits(luminance, square);
        pixels.Store(pixel);
        uint inUse = MaskW.First(count).Bits;
        uint ordinary = (IsOrdinary(radiance.R) & IsOrdinary(radiance.G) & IsOrdinary(radiance.B)).Bits & inUse;
        for (uint rest = ordinary; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            long* sums = _sums.Pointer + ((nint)pixel[lane] * Film.SumsPerPixel);
            sums[0] += red[lane];
            sums[1] += green[lane];
            sums[2] += blue[lane];
            sums[Film.SquareSum] += square[lane];
            _counts.Pointer[pixel[lane]]++;
        }

        if (_half != 0)
        {
            AddToHalf(ordinary, samples);
        }

        for (uint rest = inUse & ~ordinary; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            AddUnusual((int)pixel[lane], (int)samples[lane], new(radiance.R[lane], radiance.G[lane], radiance.B[lane]));
        }
    }

    // Of the packet whose pixels and units were stored.
    private void AddToHalf(uint ordinary, UIntW samples)
    {
        for (uint rest = ordinary; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            if (IsOfHalf((int)samples[lane]))
            {
                long* sums = _halfSums!.Pointer + ((nint)_pixels.Pointer[lane] * HalfSums);
                for (int sum = 0; sum < Film.SumsPerPixel; sum++)
                {
                    sums[sum] += _units.Pointer[(sum * FloatW.Count) + lane];
                }

                sums[Film.SumsPerPixel]++;
            }
        }
    }

    private bool IsOfHalf(int sample) => (_half >> (sample - _firstSample) & 1) != 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void ToChannelUnits(FloatW value, long* units)
    {
        Vector.Widen(value.V, out Vector<double> low, out Vector<double> high);
        ToNearest(low * Film.ChannelUnits).Store(units);
        ToNearest(high * Film.ChannelUnits).Store(units + Vector<double>.Count);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void ToSquareUnits(FloatW value, long* units)
    {
        Vector.Widen(value.V, out Vector<double> low, out Vector<double> high);
        ToNearest(low * low * Film.SquareUnits).Store(units);
        ToNearest(high * high * Film.SquareUnits).Store(units + Vector<double>.Count);
    }

    // Ordinary numbers are far within 63 bits; what other lanes come to is not used.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<long> ToNearest(Vector<double> units) => Vector.ConvertToInt64Native(Vector.Round(units));

    // Squares of such samples fit 64 times into 64 bits. False for NaN.
    private static MaskW IsOrdinary(FloatW channel) => FloatW.Abs(channel) < OrdinaryLimit;

    private void AddUnusual(int pixel, int sample, Rgb value)
    {
        if (!float.IsFinite(value.R) || !float.IsFinite(value.G) || !float.IsFinite(value.B))
        {
            NoteBad(pixel, sample, value);
            return;
        }

        Rgb clamped = new(Clamp(value.R), Clamp(value.G), Clamp(value.B));
        Clamped += clamped == value ? 0 : 1;
        double y = clamped.Luminance;
        Span<Int128> sums = stackalloc Int128[HalfSums];
        sums[0] = (Int128)double.Round(clamped.R * Film.ChannelUnits);
        sums[1] = (Int128)double.Round(clamped.G * Film.ChannelUnits);
        sums[2] = (Int128)double.Round(clamped.B * Film.ChannelUnits);
        sums[Film.SquareSum] = (Int128)double.Round(y * y * Film.SquareUnits);
        sums[Film.SumsPerPixel] = 1;
        _film.AddSums(FilmPixel(pixel), sums[..Film.SumsPerPixel]);
        _counts.Pointer[pixel]++;
        if (_half != 0 && IsOfHalf(sample))
        {
            _film.AddPlaneSums(FilmPlane.Half, FilmPixel(pixel), sums);
        }
    }

    private static float Clamp(float channel) => float.Clamp(channel, -Film.SampleLimit, Film.SampleLimit);

    /// <summary>Hands everything to the film.</summary>
    public void End()
    {
        int first = 0;
        foreach (int target in _targets.Span)
        {
            Hand(target, first++, 1);
        }

        for (int row = 0; _targets.IsEmpty && row < _tile.Height; row++)
        {
            Hand(((_tile.Y + row) * _film.Width) + _tile.X, first, _tile.Width);
            first += _tile.Width;
        }
    }

    private void Hand(int target, int first, int pixels)
    {
        _film.AddRow(target, new(_sums.Pointer + ((nint)first * Film.SumsPerPixel), pixels * Film.SumsPerPixel), new(_counts.Pointer + first, pixels));
        if (_half != 0)
        {
            _film.AddPlaneSums(FilmPlane.Half, target, new ReadOnlySpan<long>(_halfSums!.Pointer + ((nint)first * HalfSums), pixels * HalfSums));
        }
    }

    private void Clear(int pixels, SampleRange samples)
    {
        NativeMemory.Clear(_sums.Pointer, (nuint)pixels * Film.SumsPerPixel * sizeof(long));
        NativeMemory.Clear(_counts.Pointer, (nuint)pixels * sizeof(uint));
        (_half, _firstSample) = (0, samples.First);
        int kept = _film.Planes.Contains(FilmPlane.Half) ? samples.Count : 0;
        for (int i = 0; i < kept; i++)
        {
            _half |= FilmPlane.IsOfHalf(samples.First + i) ? 1UL << i : 0;
        }

        if (_half != 0)
        {
            _halfSums ??= new((long)maxPixels * HalfSums);
            NativeMemory.Clear(_halfSums.Pointer, (nuint)pixels * HalfSums * sizeof(long));
        }
    }

    private void NoteBad(int pixel, int sample, Rgb value)
    {
        NonFinite++;
        (int y, int x) = int.DivRem((int)FilmPixel(pixel), _film.Width);
        _bad.Add(new(x, y, sample, value));

        // Those that are kept are the first of the picture, whichever thread met them, and when.
        if (_bad.Count >= 4 * RenderStatistics.MaxBadSamples)
        {
            BadSample[] first = [.. _bad.Order().Take(RenderStatistics.MaxBadSamples)];
            _bad.Clear();
            _bad.AddRange(first);
        }
    }

    private long FilmPixel(int pixel)
    {
        if (!_targets.IsEmpty)
        {
            return _targets.Span[pixel];
        }

        (int x, int y) = _tile.Pixel(pixel);
        return ((long)y * _film.Width) + x;
    }
}
