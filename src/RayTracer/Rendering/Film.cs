using System.Buffers.Binary;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Rendering;

/// <summary>
/// Adds up the samples of each pixel exactly: sums of red, green, blue and squared luminance are 128-bit fixed point numbers,
/// so addition is associative, and any split of the samples over threads, tiles, ranges, processes or machines, merged in any
/// order, gives the same bits. Channels are in units of 2⁻³², squares in units of 2⁻⁴⁸.
/// </summary>
public sealed partial class Film : IImageRows
{
    /// <summary>Samples beyond ± this are clamped (a bias, so they are counted): fewer than 2³¹ of them fit into the sums.</summary>
    public const float SampleLimit = 1 << 24;

    /// <summary>Memory of a pixel in bytes: four sums of 16 bytes, and a count of 4.</summary>
    public const int BytesPerPixel = (SumsPerPixel * 16) + 4;

    internal const int SumsPerPixel = 4;
    internal const int SquareSum = 3;
    internal const double ChannelUnits = 4294967296.0;
    internal const double SquareUnits = 281474976710656.0;
    private readonly Int128[] _sums;
    private readonly uint[] _counts;
    private readonly Int128[][] _planes;

    /// <summary>Makes an empty film.</summary>
    /// <param name="width">Width in pixels, at least 1.</param>
    /// <param name="height">Height in pixels, at least 1.</param>
    /// <param name="planes">The planes beside its picture.</param>
    /// <exception cref="OutOfMemoryException">There are more than <see cref="MaxPixels"/> pixels, or not so much memory.</exception>
    public Film(int width, int height, params IReadOnlyList<FilmPlane> planes)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);
        Width = width;
        Height = height;
        _sums = new Int128[checked((long)width * height * SumsPerPixel)];
        _counts = new uint[(long)width * height];
        Planes = planes;
        _planes = [.. planes.Select(p => new Int128[checked((long)width * height * p.Sums.Count)])];
        _light = Own(FilmPlane.Light);
        _lightSquares = Own(FilmPlane.LightSquare);
    }

    /// <summary>What it holds beside its picture.</summary>
    public IReadOnlyList<FilmPlane> Planes { get; }

    /// <summary>The largest number of pixels: the sums are in one array.</summary>
    public static long MaxPixels => Array.MaxLength / SumsPerPixel;

    /// <inheritdoc/>
    public int Width { get; }

    /// <inheritdoc/>
    public int Height { get; }

    /// <summary>Number of samples that a pixel's sums hold.</summary>
    /// <param name="x">Column, from the left.</param>
    /// <param name="y">Row, from the top.</param>
    public uint SampleCount(int x, int y) => _counts[Index(x, y)];

    /// <summary>Total number of samples.</summary>
    public long TotalSamples
    {
        get
        {
            long total = 0;
            foreach (uint count in _counts)
            {
                total += count;
            }

            return total;
        }
    }

    /// <summary>Mean radiance of a pixel, as <see cref="Mean"/>.</summary>
    /// <param name="x">Column, from the left.</param>
    /// <param name="y">Row, from the top.</param>
    public Rgb this[int x, int y] => Mean(x, y);

    /// <summary>Returns the means of all pixels.</summary>
    public Picture ToPicture()
    {
        Picture picture = new(Width, Height);
        for (int y = 0; y < Height; y++)
        {
            ReadRow(y, picture.Pixels.AsSpan(3 * y * Width, 3 * Width));
        }

        return picture;
    }

    /// <summary>
    /// Mean radiance of a pixel; black where there are no samples. What light paths bring (<see cref="FilmPlane.Light"/>) has a mean of its
    /// own, which is added.
    /// </summary>
    /// <param name="x">Column, from the left.</param>
    /// <param name="y">Row, from the top.</param>
    public Rgb Mean(int x, int y)
    {
        long pixel = Index(x, y);
        double scale = _counts[pixel] == 0 ? 0 : 1 / (ChannelUnits * _counts[pixel]);
        ReadOnlySpan<Int128> sums = Sums(pixel);
        (double red, double green, double blue) = (ToDouble(sums[0]) * scale, ToDouble(sums[1]) * scale, ToDouble(sums[2]) * scale);
        if (_light is not null)
        {
            AddLightMean(pixel, ref red, ref green, ref blue);
        }

        return new((float)red, (float)green, (float)blue);
    }

    /// <summary>
    /// Variance of the luminance of a pixel's camera samples (unbiased; of one sample, not of the mean); zero below two samples. For
    /// stratified samplers, the variance of the mean is smaller than this over the number of samples, and far smaller with a pixel filter that is
    /// negative in parts: of even light, each sample is one of two opposite numbers, but their shares are stratified.
    /// </summary>
    /// <param name="x">Column, from the left.</param>
    /// <param name="y">Row, from the top.</param>
    public float SampleVariance(int x, int y)
    {
        long pixel = Index(x, y);
        ReadOnlySpan<Int128> sums = Sums(pixel);
        return Variance(sums, sums[SquareSum], _counts[pixel]);
    }

    private static float Variance(ReadOnlySpan<Int128> sums, Int128 square, double n)
    {
        if (n < 2)
        {
            return 0;
        }

        double luminance = ((0.2126 * ToDouble(sums[0])) + (0.7152 * ToDouble(sums[1])) + (0.0722 * ToDouble(sums[2]))) / ChannelUnits;
        double squares = ToDouble(square) / SquareUnits;
        return (float)Math.Max(0, (squares - (luminance * luminance / n)) / (n - 1));
    }

    /// <inheritdoc/>
    public void ReadRow(int y, Span<float> rgb)
    {
        for (int x = 0; x < Width; x++)
        {
            (rgb[3 * x], rgb[(3 * x) + 1], rgb[(3 * x) + 2]) = Mean(x, y);
        }
    }

    /// <summary>Takes all samples away.</summary>
    public void Clear()
    {
        Array.Clear(_sums);
        Array.Clear(_counts);
        Array.ForEach(_planes, Array.Clear);
    }

    /// <summary>Adds the samples of another film. They must be other samples of the same scene; that is not checked here.</summary>
    /// <param name="other">A film of the same size, which has the planes of this one.</param>
    /// <exception cref="ArgumentException">The sizes differ, or a plane is missing.</exception>
    public void Merge(Film other)
    {
        Int128[][] planes = [.. Planes.Select(p => other._planes[other.PlaneIndex(p)])];
        if (other.Width != Width || other.Height != Height)
        {
            throw new ArgumentException($"A film of {other.Width}×{other.Height} pixels cannot be merged into one of {Width}×{Height}.", nameof(other));
        }

        Add(_sums, other._sums);
        for (long i = 0; i < _counts.LongLength; i++)
        {
            _counts[i] += other._counts[i];
        }

        for (int plane = 0; plane < planes.Length; plane++)
        {
            Add(_planes[plane], planes[plane]);
        }
    }

    /// <summary>Returns the two halves of the samples, each as a film; together they are this one.</summary>
    /// <exception cref="ArgumentException">
    /// It has no <see cref="FilmPlane.Half"/>, or has <see cref="FilmPlane.Light"/>, but no halves of that.
    /// </exception>
    public (Film First, Film Second) Halves()
    {
        FilmPlane[] light = _light is null ? [] : [FilmPlane.Light, FilmPlane.LightSquare];
        (Film first, Film second) = (new(Width, Height, light), new(Width, Height, light));
        ReadOnlySpan<Int128> half = _planes[PlaneIndex(FilmPlane.Half)];
        for (int pixel = 0; pixel < _counts.Length; pixel++)
        {
            for (int i = 0; i < SumsPerPixel; i++)
            {
                int sum = (pixel * SumsPerPixel) + i;
                first._sums[sum] = half[(pixel * FilmPlane.Half.Sums.Count) + i];
                second._sums[sum] = _sums[sum] - first._sums[sum];
            }

            first._counts[pixel] = (uint)half[(pixel * FilmPlane.Half.Sums.Count) + SumsPerPixel];
            second._counts[pixel] = _counts[pixel] - first._counts[pixel];
        }

        if (_light is not null)
        {
            PutLightHalves(first, second);
        }

        return (first, second);
    }

    /// <summary>
    /// Copies the exact content of a row, to be added to a film again by
    /// <see cref="AddSums(int, ReadOnlySpan{Int128}, ReadOnlySpan{uint})"/>.
    /// </summary>
    /// <param name="y">Row, from the top.</param>
    /// <param name="sums">Takes four sums a pixel: red, green and blue in units of 2⁻³², and squared luminance in units of 2⁻⁴⁸.</param>
    /// <param name="counts">Takes the number of samples of each pixel.</param>
    public void ReadSums(int y, Span<Int128> sums, Span<uint> counts)
    {
        int first = (int)Index(0, y);
        _sums.AsSpan(first * SumsPerPixel, Width * SumsPerPixel).CopyTo(sums);
        _counts.AsSpan(first, Width).CopyTo(counts);
    }

    /// <summary>Adds the exact content of a row of another film.</summary>
    /// <param name="y">Row, from the top.</param>
    /// <param name="sums">Four sums a pixel, as <see cref="ReadSums"/> gives them.</param>
    /// <param name="counts">The number of samples of each pixel.</param>
    public void AddSums(int y, ReadOnlySpan<Int128> sums, ReadOnlySpan<uint> counts)
    {
        Add(_sums.AsSpan((int)Index(0, y) * SumsPerPixel, Width * SumsPerPixel), sums);
        AddCounts(y, counts);
    }

    /// <summary>
    /// As <see cref="AddSums(int, ReadOnlySpan{Int128}, ReadOnlySpan{uint})"/>, of a row whose sums all fit into 64 bits.
    /// </summary>
    /// <inheritdoc cref="AddSums(int, ReadOnlySpan{Int128}, ReadOnlySpan{uint})"/>
    public void AddSums(int y, ReadOnlySpan<long> sums, ReadOnlySpan<uint> counts)
    {
        Add(_sums.AsSpan((int)Index(0, y) * SumsPerPixel, Width * SumsPerPixel), sums);
        AddCounts(y, counts);
    }

    /// <summary>Copies a row of a plane.</summary>
    /// <param name="plane">The plane.</param>
    /// <param name="y">Row, from the top.</param>
    /// <param name="sums">Takes the plane's sums of each pixel.</param>
    /// <exception cref="ArgumentException">The film does not have the plane.</exception>
    public void ReadPlane(FilmPlane plane, int y, Span<Int128> sums) => PlaneRow(plane, Index(0, y), Width * plane.Sums.Count).CopyTo(sums);

    /// <summary>Adds a row of another film's plane.</summary>
    /// <param name="plane">The plane.</param>
    /// <param name="y">Row, from the top.</param>
    /// <param name="sums">The plane's sums of each pixel, as <see cref="ReadPlane"/> gives them.</param>
    /// <exception cref="ArgumentException">The film does not have the plane.</exception>
    public void AddPlane(FilmPlane plane, int y, ReadOnlySpan<Int128> sums) => Add(PlaneRow(plane, Index(0, y), sums.Length), sums);

    /// <summary>As <see cref="AddPlane(FilmPlane, int, ReadOnlySpan{Int128})"/>, of a row whose sums all fit into 64 bits.</summary>
    /// <inheritdoc cref="AddPlane(FilmPlane, int, ReadOnlySpan{Int128})"/>
    public void AddPlane(FilmPlane plane, int y, ReadOnlySpan<long> sums) => AddToPlane(plane, 0, y, sums);

    private static void Add(Span<Int128> target, ReadOnlySpan<Int128> sums)
    {
        for (int i = 0; i < target.Length; i++)
        {
            target[i] += sums[i];
        }
    }

    private static void Add(Span<Int128> target, ReadOnlySpan<long> sums, int sign = 1)
    {
        for (int i = 0; i < target.Length; i++)
        {
            target[i] += sign * sums[i];
        }
    }

    private Span<Int128> PlaneRow(FilmPlane plane, long firstPixel, int length) =>
        _planes[PlaneIndex(plane)].AsSpan(checked((int)firstPixel * plane.Sums.Count), length);

    private Int128[]? Own(FilmPlane plane) => Planes.Contains(plane) ? _planes[PlaneIndex(plane)] : null;

    private int PlaneIndex(FilmPlane plane)
    {
        for (int i = 0; i < Planes.Count; i++)
        {
            if (Planes[i] == plane)
            {
                return i;
            }
        }

        throw new ArgumentException($"The film has no plane '{plane}'.", nameof(plane));
    }

    private void AddCounts(int y, ReadOnlySpan<uint> counts)
    {
        Span<uint> target = _counts.AsSpan((int)Index(0, y), Width);
        for (int i = 0; i < target.Length; i++)
        {
            target[i] += counts[i];
        }
    }

    /// <summary>
    /// SHA-256, as hexadecimal digits, of the exact content: of the size and of the SHA-256 of each row, which covers the
    /// sums (16 bytes each, lowest first), then the counts (4 bytes each) of its pixels, and then of each plane its name and the sums of
    /// its pixels.
    /// </summary>
    /// <param name="planes">The planes that it covers; null for all that files keep.</param>
    /// <exception cref="ArgumentException">The film does not have a plane.</exception>
    public string ComputeHash(IReadOnlyList<FilmPlane>? planes = null)
    {
        const int digest = SHA256.HashSizeInBytes;
        byte[] digests = new byte[8 + ((long)digest * Height)];
        BinaryPrimitives.WriteInt32LittleEndian(digests, Width);
        BinaryPrimitives.WriteInt32LittleEndian(digests.AsSpan(4), Height);
        Parallel.For(0, Height, y =>
        {
            using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
            hash.AppendData(Bytes(_sums.AsSpan(checked(y * Width * SumsPerPixel), Width * SumsPerPixel)));
            hash.AppendData(Bytes(_counts.AsSpan(y * Width, Width)));
            foreach (FilmPlane plane in planes ?? KeptPlanes)
            {
                hash.AppendData(Encoding.UTF8.GetBytes(plane.Name));
                hash.AppendData(Bytes(PlaneRow(plane, y * Width, Width * plane.Sums.Count)));
            }
            hash.GetHashAndReset(digests.AsSpan(8 + (digest * y)));
        });
        return Convert.ToHexStringLower(SHA256.HashData(digests));
    }

    /// <summary>A sum of a channel of a pixel, in its units.</summary>
    internal Int128 Sum(int x, int y, int channel) => _sums[(Index(x, y) * SumsPerPixel) + channel];

    /// <summary>Adds samples of pixels in a row, or takes them away.</summary>
    /// <param name="x">Column of the first pixel.</param>
    /// <param name="y">Row.</param>
    /// <param name="sums">The sums of each pixel, in their units.</param>
    /// <param name="rest">The part of each pixel that those do not hold (<see cref="SumRest"/>); nothing where they hold all.</param>
    /// <param name="samples">The number of samples of each pixel, those that were left out included.</param>
    /// <param name="isOfHalf">True if they are of <see cref="FilmPlane.Half"/>, and the film has that.</param>
    /// <param name="sign">1 to add, −1 to take away.</param>
    internal void AddRow(int x, int y, ReadOnlySpan<long> sums, ReadOnlySpan<long> rest, int samples, bool isOfHalf, int sign = 1)
    {
        int first = (y * Width) + x;
        Span<Int128> targetSums = _sums.AsSpan(first * SumsPerPixel, sums.Length);
        Add(targetSums, sums, sign);
        Span<uint> targetCounts = _counts.AsSpan(first, sums.Length / SumsPerPixel);
        for (int i = 0; i < targetCounts.Length; i++)
        {
            targetCounts[i] += (uint)(sign * samples);
        }

        for (int i = 0; i < rest.Length; i++)
        {
            targetSums[(i * SumsPerPixel) + SquareSum] += (Int128)(sign * SumRest.HighSquare(rest[i])) << SumRest.SquareShift;
            targetCounts[i] -= (uint)(sign * SumRest.Missing(rest[i]));
        }

        if (isOfHalf)
        {
            AddToHalf(first, sums, rest, samples, sign);
        }
    }

    private void AddToHalf(int first, ReadOnlySpan<long> sums, ReadOnlySpan<long> rest, int samples, int sign)
    {
        int perPixel = FilmPlane.Half.Sums.Count;
        int pixels = sums.Length / SumsPerPixel;
        Span<Int128> target = PlaneRow(FilmPlane.Half, first, pixels * perPixel);
        for (int pixel = 0; pixel < pixels; pixel++)
        {
            Span<Int128> own = target.Slice(pixel * perPixel, perPixel);
            for (int i = 0; i < SumsPerPixel; i++)
            {
                own[i] += sign * sums[(pixel * SumsPerPixel) + i];
            }

            long more = rest.IsEmpty ? 0 : rest[pixel];
            own[SquareSum] += (Int128)(sign * SumRest.HighSquare(more)) << SumRest.SquareShift;
            own[SumsPerPixel] += sign * (samples - SumRest.Missing(more));
        }
    }

    private static ReadOnlySpan<byte> Bytes<T>(Span<T> values)
        where T : unmanaged
    {
        // The hash is defined on little-endian bytes; every machine that the renderer runs on has them so.
        if (!BitConverter.IsLittleEndian)
        {
            throw new PlatformNotSupportedException("Film hashes are defined for little-endian machines.");
        }

        return MemoryMarshal.AsBytes(values);
    }

    /// <summary>A sum as a number; most fit into 64 bits, which is quicker.</summary>
    internal static double ToDouble(Int128 value) =>
        value >= long.MinValue && value <= long.MaxValue ? (long)value : (double)value;

    private ReadOnlySpan<Int128> Sums(long pixel) => _sums.AsSpan((int)(pixel * SumsPerPixel), SumsPerPixel);

    private long Index(int x, int y)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)x, (uint)Width, nameof(x));
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)y, (uint)Height, nameof(y));
        return ((long)y * Width) + x;
    }
}
