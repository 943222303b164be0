using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Adds up the samples of one tile in 64-bit fixed point, which holds up to <see cref="MaxSamples"/> samples a pixel, before they
/// go to the film's 128-bit sums. No more than that can be taken back from the film again (<see cref="PassCell"/>).
/// </summary>
internal sealed unsafe class SampleAccumulator(int maxPixels)
{
    /// <summary>Samples a pixel that fit into 64 bits.</summary>
    public const int MaxSamples = 64;

    // 64 · 16² · 2⁴⁸ = 2⁶²; of the squares of brighter samples, the bits from 2⁵⁶ on are added up apart.
    private const float OrdinaryLimit = 16;
    private readonly PinnedBuffer<long> _sums = new((long)maxPixels * Film.SumsPerPixel);
    private readonly PinnedBuffer<long> _rest = new(maxPixels);
    private readonly PinnedBuffer<long>?[] _beside = new PinnedBuffer<long>?[FilmPlane.OfSamples.Count];
    private readonly PinnedBuffer<long> _units = new((long)Film.SumsPerPixel * FloatW.Count);
    private readonly PinnedBuffer<uint> _pixels = new(FloatW.Count);
    private readonly List<BadSample> _bad = [];
    private Film _film = null!;
    private FilmPlane[] _planes = [];
    private Tile _tile;
    private ReadOnlyMemory<int> _targets;
    private int _samples;
    private bool _hasRest;

    /// <summary>Samples that were not finite, and so were left out.</summary>
    public long NonFinite { get; private set; }

    /// <summary>Samples that were clamped.</summary>
    public long Clamped { get; private set; }

    /// <summary>The first samples that were not finite.</summary>
    public IReadOnlyList<BadSample> Bad => _bad;

    /// <summary>Prepares for the samples of a tile.</summary>
    /// <param name="film">The film.</param>
    /// <param name="tile">The tile.</param>
    /// <param name="samples">The number of samples that each pixel will have.</param>
    public void Begin(Film film, in Tile tile, int samples)
    {
        (_tile, _targets, _samples) = (tile, default, samples);
        Clear(film);
    }

    /// <summary>Prepares for the samples of single pixels.</summary>
    /// <param name="film">The film.</param>
    /// <param name="targets">The numbers of its pixels.</param>
    /// <param name="samples">The number of samples that each pixel will have.</param>
    public void BeginPixels(Film film, ReadOnlyMemory<int> targets, int samples)
    {
        (_targets, _samples) = (targets, samples);
        Clear(film);
    }

    /// <summary>Adds a packet of samples.</summary>
    /// <param name="count">Number of lanes in use.</param>
    /// <param name="pixels">The pixels' numbers in the tile.</param>
    /// <param name="samples">The samples' numbers, for the list of bad ones.</param>
    /// <param name="radiance">The samples.</param>
    public void Add(int count, in UIntW pixels, in UIntW samples, in RgbW radiance)
    {
        long* red = _units.Pointer;
        long* green = red + FloatW.Count;
        long* blue = green + FloatW.Count;
        long* square = blue + FloatW.Count;
        uint* pixel = _pixels.Pointer;
        FloatW luminance = radiance.Luminance;
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
        }

        for (uint rest = inUse & ~ordinary; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            AddUnusual((int)pixel[lane], (int)samples[lane], new(radiance.R[lane], radiance.G[lane], radiance.B[lane]));
        }
    }

    /// <summary>Rounds numbers to the nearest units of the film's channels, ties to even.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void ToChannelUnits(FloatW value, long* units)
    {
        value.Widen(out Vector<double> low, out Vector<double> high);
        ToNearest(low * Film.ChannelUnits).Store(units);
        ToNearest(high * Film.ChannelUnits).Store(units + Vector<double>.Count);
    }

    /// <summary>Adds what a packet of samples saw of what is behind everything, for films with <see cref="FilmPlane.Alpha"/>.</summary>
    /// <param name="lanes">The lanes in use.</param>
    /// <param name="pixels">The pixels' numbers in the tile.</param>
    /// <param name="radiance">The samples: those that are not finite are left out.</param>
    /// <param name="through">The share that they saw of it.</param>
    /// <param name="light">Its light.</param>
    public void AddBackdrop(MaskW lanes, in UIntW pixels, in RgbW radiance, in FloatW through, in RgbW light) =>
        AddBeside(FilmPlane.Alpha, 0, lanes & IsFinite(radiance), pixels, [through, light.R, light.G, light.B]);

    /// <summary>Adds the light of shadow catchers to <see cref="FilmPlane.Matte"/>.</summary>
    /// <param name="lanes">The samples that see one.</param>
    /// <param name="pixels">The pixels' numbers in the tile.</param>
    /// <param name="caught">The share that they see of it.</param>
    /// <param name="light">Its light.</param>
    public void AddCaught(MaskW lanes, in UIntW pixels, in FloatW caught, in RgbW light) =>
        AddBeside(FilmPlane.Matte, 0, lanes & IsFinite(light), pixels, [caught, light.R, light.G, light.B]);

    /// <summary>Adds the light that shadow catchers have without the things that throw shadows to <see cref="FilmPlane.Matte"/>.</summary>
    /// <inheritdoc cref="AddCaught"/>
    public void AddAlone(MaskW lanes, in UIntW pixels, in RgbW light) =>
        AddBeside(FilmPlane.Matte, FilmPlane.Matte.Sums.Count - 3, lanes & IsFinite(light), pixels, [light.R, light.G, light.B]);

    // Nothing where the film has no such plane.
    private void AddBeside(FilmPlane plane, int first, MaskW lanes, in UIntW pixels, ReadOnlySpan<FloatW> values)
    {
        if (!_planes.Contains(plane))
        {
            return;
        }

        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            long* sums = _beside[plane.IndexOfSamples]!.Pointer + ((nint)pixels[lane] * plane.Sums.Count) + first;
            for (int i = 0; i < values.Length; i++)
            {
                sums[i] += (long)double.Round(Clamp(values[i][lane]) * Film.ChannelUnits);
            }
        }
    }

    private static MaskW IsFinite(in RgbW light) =>
        (FloatW.Abs(light.R) < float.PositiveInfinity) & (FloatW.Abs(light.G) < float.PositiveInfinity) & (FloatW.Abs(light.B) < float.PositiveInfinity);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void ToSquareUnits(FloatW value, long* units)
    {
        value.Widen(out Vector<double> low, out Vector<double> high);
        ToNearest(low * low * Film.SquareUnits).Store(units);
        ToNearest(high * high * Film.SquareUnits).Store(units + Vector<double>.Count);
    }

    // Ordinary numbers are far within 63 bits; what other lanes come to is not used.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector<long> ToNearest(Vector<double> units) => Vector.ConvertToInt64Native(Vector.Round(units));

    // Squares of such samples fit 64 times into 64 bits. False for NaN.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static MaskW IsOrdinary(FloatW channel) => FloatW.Abs(channel) < OrdinaryLimit;

    private void AddUnusual(int pixel, int sample, Rgb value)
    {
        if (!float.IsFinite(value.R) || !float.IsFinite(value.G) || !float.IsFinite(value.B))
        {
            NoteBad(pixel, sample, value);
            return;
        }

        Rgb clamped = Clamp(value);
        Clamped += clamped == value ? 0 : 1;
        long* sums = _sums.Pointer + ((nint)pixel * Film.SumsPerPixel);
        sums[0] += (long)double.Round(clamped.R * Film.ChannelUnits);
        sums[1] += (long)double.Round(clamped.G * Film.ChannelUnits);
        sums[2] += (long)double.Round(clamped.B * Film.ChannelUnits);
        double y = clamped.Luminance;
        Int128 square = (Int128)double.Round(y * y * Film.SquareUnits);
        sums[Film.SquareSum] += (long)(square & ((1L << SumRest.SquareShift) - 1));
        AddRest(pixel, (long)(square >> SumRest.SquareShift), 0);
    }

    private void AddRest(int pixel, long highSquare, int missing)
    {
        if (!_hasRest)
        {
            NativeMemory.Clear(_rest.Pointer, (nuint)Pixels * sizeof(long));
            _hasRest = true;
        }

        _rest.Pointer[pixel] += SumRest.Of(highSquare, missing);
    }

    /// <summary>What the film takes of a sample.</summary>
    internal static Rgb Clamp(Rgb value) => new(Clamp(value.R), Clamp(value.G), Clamp(value.B));

    /// <summary>What the film takes of a channel of samples.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static FloatW Clamp(FloatW channel) => FloatW.Max(-Film.SampleLimit, FloatW.Min(channel, Film.SampleLimit));

    private static float Clamp(float channel) => float.Clamp(channel, -Film.SampleLimit, Film.SampleLimit);

    /// <summary>Hands everything to the film.</summary>
    /// <param name="isOfHalf">True if the samples are of <see cref="FilmPlane.Half"/>, and the film has that.</param>
    /// <param name="cell">Keeps what was handed over, so that it can be taken back; null where nobody will.</param>
    public void End(bool isOfHalf = false, PassCell? cell = null)
    {
        int length;
        for (int pixel = 0; pixel < Pixels; pixel += length)
        {
            (int x, int y, length) = PixelRuns.At(pixel, _tile, _targets.Span, _film.Width);
            ReadOnlySpan<long> sums = new(_sums.Pointer + ((nint)pixel * Film.SumsPerPixel), length * Film.SumsPerPixel);
            ReadOnlySpan<long> rest = _hasRest ? new(_rest.Pointer + pixel, length) : default;
            _film.AddRow(x, y, sums, rest, _samples, isOfHalf);
            cell?.Keep(x, y, sums, rest);
            foreach (FilmPlane plane in _planes)
            {
                ReadOnlySpan<long> beside = new(_beside[plane.IndexOfSamples]!.Pointer + ((nint)pixel * plane.Sums.Count), length * plane.Sums.Count);
                _film.AddToPlane(plane, x, y, beside);
                cell?.Keep(plane, x, y, beside);
            }
        }
    }

    private int Pixels => _targets.IsEmpty ? _tile.Pixels : _targets.Length;

    private void Clear(Film film)
    {
        if (_film != film)
        {
            (_film, _planes) = (film, [.. FilmPlane.OfSamples.Where(film.Planes.Contains)]);
        }

        NativeMemory.Clear(_sums.Pointer, (nuint)Pixels * Film.SumsPerPixel * sizeof(long));
        _hasRest = false;
        foreach (FilmPlane plane in _planes)
        {
            PinnedBuffer<long> beside = _beside[plane.IndexOfSamples] ??= new((long)maxPixels * plane.Sums.Count);
            NativeMemory.Clear(beside.Pointer, (nuint)(Pixels * plane.Sums.Count) * sizeof(long));
        }
    }

    private void NoteBad(int pixel, int sample, Rgb value)
    {
        NonFinite++;
        AddRest(pixel, 0, missing: 1);
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
