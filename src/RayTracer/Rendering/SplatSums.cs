using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// The light that the paths of one light sample bring to the pixels of a picture. All threads share it, and the sums, which are integers,
/// are the same in any order. There are 64 bits for each; where a sum nears the end of them, it is moved into a spill of 128 bits, so it
/// cannot overflow: 2⁴⁶ splats of the brightest kind fit into one pixel in each of 2²⁴ samples, a hundred thousand for each path of the
/// largest picture. That holds for up to <see cref="MaxThreads"/> threads.
/// </summary>
/// <param name="width">Width of the picture in pixels.</param>
/// <param name="height">Height of the picture in pixels.</param>
internal sealed unsafe class SplatSums(int width, int height)
{
    /// <summary>Memory of a pixel in bytes.</summary>
    public const int BytesPerPixel = Channels * sizeof(long);

    /// <summary>
    /// The most threads that may add at once: a sum is moved when it is beyond 2⁶², and until then each of them may add 2⁵⁰ once.
    /// </summary>
    public const int MaxThreads = 1 << 12;

    private const int Channels = 3;
    private const long Fullest = 1L << 62;

    // 2⁵⁰ units: brighter splats, which are rare, go into the spill at once.
    private const float OrdinaryLimit = 1 << 18;
    private readonly long[] _sums = new long[(long)width * height * Channels];
    private readonly Dictionary<long, Int128> _spill = [];
    private readonly Lock _spilling = new();
    private long _nonFinite;
    private long _clamped;

    /// <summary>The most threads that <see cref="Commit"/> uses.</summary>
    public int Threads { get; init; } = Environment.ProcessorCount;

    /// <summary>Splats that were not finite, and so were left out.</summary>
    public long NonFinite => Interlocked.Read(ref _nonFinite);

    /// <summary>Splats that were clamped to <see cref="Film.SampleLimit"/>.</summary>
    public long Clamped => Interlocked.Read(ref _clamped);

    /// <summary>Adds splats. Any thread may at any time, but during <see cref="Commit"/> and <see cref="Drop"/>.</summary>
    /// <param name="count">The number of lanes in use, from the first.</param>
    /// <param name="pixel">The pixels' numbers, row by row.</param>
    /// <param name="value">Their new value.</param>
    public void Add(int count, in UIntW pixel, in RgbW value)
    {
        long* red = stackalloc long[Channels * FloatW.Count];
        long* green = red + FloatW.Count;
        long* blue = green + FloatW.Count;
        uint* pixels = stackalloc uint[FloatW.Count];
        SampleAccumulator.ToChannelUnits(value.R, red);
        SampleAccumulator.ToChannelUnits(value.G, green);
        SampleAccumulator.ToChannelUnits(value.B, blue);
        pixel.Store(pixels);
        uint inUse = MaskW.First(count).Bits;
        uint ordinary = (IsOrdinary(value.R) & IsOrdinary(value.G) & IsOrdinary(value.B)).Bits & inUse;
        for (uint rest = ordinary; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            long first = (long)pixels[lane] * Channels;
            Add(first, red[lane]);
            Add(first + 1, green[lane]);
            Add(first + 2, blue[lane]);
        }

        for (uint rest = inUse & ~ordinary; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            AddUnusual((long)pixels[lane] * Channels, new(value.R[lane], value.G[lane], value.B[lane]));
        }
    }

    /// <summary>Adds a splat, as <see cref="Add(int, in UIntW, in RgbW)"/> does.</summary>
    /// <param name="pixel">The pixel's number, row by row.</param>
    /// <param name="value">Its new value.</param>
    public void Add(uint pixel, Rgb value)
    {
        long first = (long)pixel * Channels;
        if (Math.Abs(value.R) < OrdinaryLimit && Math.Abs(value.G) < OrdinaryLimit && Math.Abs(value.B) < OrdinaryLimit)
        {
            Add(first, (long)double.Round(value.R * Film.ChannelUnits));
            Add(first + 1, (long)double.Round(value.G * Film.ChannelUnits));
            Add(first + 2, (long)double.Round(value.B * Film.ChannelUnits));
        }
        else
        {
            AddUnusual(first, value);
        }
    }

    /// <summary>A sum, in the film's units, while nothing is added.</summary>
    /// <param name="index">Three times the pixel's number, and the channel's.</param>
    public Int128 Sum(long index) => _sums[index] + (_spill.Count == 0 ? 0 : _spill.GetValueOrDefault(index));

    /// <summary>Adds all splats to a film, as one light sample of each pixel, and is empty again.</summary>
    /// <param name="film">A film of the picture, with <see cref="FilmPlane.Light"/>.</param>
    /// <param name="sample">The sample's number.</param>
    /// <param name="area">The pixels that count; null for all.</param>
    /// <exception cref="ArgumentException">The film has another size, or lacks the plane.</exception>
    public void Commit(Film film, int sample, Tile? area = null)
    {
        if ((film.Width, film.Height) != (width, height) || !film.Planes.Contains(FilmPlane.Light))
        {
            throw new ArgumentException($"A film of {width}×{height} pixels with a plane of light is needed.", nameof(film));
        }

        Tile kept = area ?? new(0, 0, width, height);
        ParallelOptions parallel = new() { MaxDegreeOfParallelism = Threads };
        Parallel.For(kept.Y, kept.Y + kept.Height, parallel, () => new Int128[kept.Width * Channels], (y, _, row) =>
        {
            long first = (((long)y * width) + kept.X) * Channels;
            for (int i = 0; i < row.Length; i++)
            {
                row[i] = Sum(first + i);
            }

            film.AddLight(kept.X, y, row, sample);
            return row;
        }, _ => { });
        Drop();
    }

    /// <summary>Leaves out all splats that wait to be added to a film.</summary>
    public void Drop()
    {
        Array.Clear(_sums);
        _spill.Clear();
    }

    // False for NaN.
    private static MaskW IsOrdinary(FloatW channel) => FloatW.Abs(channel) < OrdinaryLimit;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Add(long index, long units)
    {
        ref long sum = ref _sums[index];
        long after = Interlocked.Add(ref sum, units);
        if (after is >= Fullest or <= -Fullest)
        {
            // Whatever is there by now is taken once, even if several threads find the sum full.
            Spill(index, Interlocked.Exchange(ref sum, 0));
        }
    }

    private void AddUnusual(long first, Rgb value)
    {
        if (!float.IsFinite(value.R) || !float.IsFinite(value.G) || !float.IsFinite(value.B))
        {
            Interlocked.Increment(ref _nonFinite);
            return;
        }

        Rgb clamped = SampleAccumulator.Clamp(value);
        if (clamped != value)
        {
            Interlocked.Increment(ref _clamped);
        }

        Spill(first, (long)double.Round(clamped.R * Film.ChannelUnits));
        Spill(first + 1, (long)double.Round(clamped.G * Film.ChannelUnits));
        Spill(first + 2, (long)double.Round(clamped.B * Film.ChannelUnits));
    }

    private void Spill(long index, long units)
    {
        lock (_spilling)
        {
            _spill[index] = _spill.GetValueOrDefault(index) + units;
        }
    }
}
