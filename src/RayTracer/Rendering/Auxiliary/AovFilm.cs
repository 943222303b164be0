using System.Runtime.InteropServices;

namespace RayTracer.Rendering;

/// <summary>
/// Auxiliary images beside a film, of which they change nothing. Sums are exact, as the film's are: 128-bit fixed point in units of
/// 2⁻⁴⁸, so that threads, tiles and order cannot change a bit. Numbers beyond ±2⁴⁷ are clamped; what is no number counts as zero.
/// </summary>
public sealed class AovFilm
{
    private const double Units = 281474976710656.0;
    private const double Limit = 140737488355328.0;

    // Doubles below it are whole units that fit into 64 bits.
    private const double OrdinaryLimit = 16384;
    private readonly Film _film;
    private readonly Int128[]?[] _sums = new Int128[]?[Enum.GetValues<Aov>().Length];
    private readonly uint[]? _hits;
    private readonly uint[] _counts;
    private readonly uint[]? _primitives;
    private readonly long[]? _costs;

    /// <summary>Makes empty images.</summary>
    /// <param name="film">The film that they stand beside: it has the size and the numbers of samples.</param>
    /// <param name="kinds">Which; memory is taken for no others.</param>
    public AovFilm(Film film, IEnumerable<Aov> kinds)
    {
        _film = film;
        Kinds = [.. kinds.Distinct().Order()];
        long pixels = (long)film.Width * film.Height;
        foreach (Aov kind in Kinds.Where(IsSummed))
        {
            _sums[(int)kind] = new Int128[checked(pixels * Channels(kind))];
        }

        _counts = new uint[NeedsRays ? pixels : 0];
        _hits = Has(Aov.Depth) || Has(Aov.Uv) ? new uint[pixels] : null;
        _primitives = Has(Aov.Primitive) ? new uint[pixels] : null;
        _costs = Has(Aov.BvhCost) ? new long[pixels] : null;
    }

    /// <summary>The images that there are, in the order of their kinds.</summary>
    public IReadOnlyList<Aov> Kinds { get; }

    /// <summary>Width in pixels.</summary>
    public int Width => _film.Width;

    /// <summary>Height in pixels.</summary>
    public int Height => _film.Height;

    /// <summary>Whether rays must be traced for them.</summary>
    internal bool NeedsRays => Kinds.Any(k => k != Aov.Samples);

    /// <summary>Whether the surfaces must be described for them.</summary>
    internal bool NeedsSurfaces => Has(Aov.Normal) || Has(Aov.Albedo) || Has(Aov.Uv);

    /// <summary>Numbers a pixel of an image.</summary>
    public static int Channels(Aov kind) => kind switch
    {
        Aov.Normal or Aov.Albedo => 3,
        Aov.Uv => 2,
        _ => 1,
    };

    /// <summary>Whether an image's numbers are whole ones that say which or how many, rather than means.</summary>
    public static bool IsWhole(Aov kind) => kind is Aov.Primitive or Aov.Samples;

    /// <summary>Memory in bytes of images of a size.</summary>
    public static long Bytes(IReadOnlyCollection<Aov> kinds, int width, int height) =>
        (long)width * height * ((kinds.Count > 0 ? 8 : 0) + kinds.Sum(k => IsSummed(k) ? 16L * Channels(k) : 8));

    /// <summary>Whether there is an image.</summary>
    public bool Has(Aov kind) => Kinds.Contains(kind);

    /// <summary>Forgets all samples, so that the memory serves other images of this size and these kinds.</summary>
    public void Clear()
    {
        foreach (Int128[]? sums in _sums)
        {
            Array.Clear(sums ?? []);
        }

        Array.Clear(_hits ?? []);
        Array.Clear(_counts);
        Array.Clear(_primitives ?? []);
        Array.Clear(_costs ?? []);
    }

    /// <summary>Reads a row of an image.</summary>
    /// <param name="kind">Which image.</param>
    /// <param name="y">The row, from the top.</param>
    /// <param name="values">Takes <see cref="Channels"/> numbers a pixel.</param>
    public void ReadRow(Aov kind, int y, Span<double> values)
    {
        int channels = Channels(kind);
        for (int x = 0; x < Width; x++)
        {
            long pixel = ((long)y * Width) + x;
            Span<double> at = values.Slice(x * channels, channels);
            switch (kind)
            {
                case Aov.Primitive:
                    at[0] = _primitives![pixel];
                    break;
                case Aov.BvhCost:
                    at[0] = _costs![pixel] / Math.Max(1.0, _counts[pixel]);
                    break;
                case Aov.Samples:
                    at[0] = _film.SampleCount(x, y);
                    break;
                default:
                    ReadMean(kind, pixel, at);
                    break;
            }
        }
    }

    /// <summary>Counts a sample of a pixel, and what the first one met.</summary>
    /// <param name="pixel">The pixel's number.</param>
    /// <param name="sample">The sample's number.</param>
    /// <param name="primitive">What it met; null for nothing.</param>
    /// <param name="distance">How far away that is.</param>
    internal void AddRay(long pixel, uint sample, uint? primitive, float distance)
    {
        _counts[pixel]++;
        if (primitive is not { } met)
        {
            return;
        }

        if (_hits is not null)
        {
            _hits[pixel]++;
        }

        if (_primitives is not null && sample == 0)
        {
            _primitives[pixel] = met + 1;
        }

        Add(Aov.Depth, pixel, 0, distance);
    }

    /// <summary>Adds what it cost to trace a ray.</summary>
    internal void AddCost(long pixel, long cost) => _costs![pixel] += cost;

    /// <summary>Adds one number of a hit to a sum, if that image is wanted.</summary>
    internal void Add(Aov kind, long pixel, int channel, float value)
    {
        if (_sums[(int)kind] is not { } sums)
        {
            return;
        }

        ref Int128 sum = ref sums[(pixel * Channels(kind)) + channel];
        double units = double.Round(Math.Clamp(float.IsNaN(value) ? 0 : value, -Limit, Limit) * Units);
        sum += Math.Abs(value) < OrdinaryLimit ? (long)units : (Int128)units;
    }

    /// <summary>All that is stored but the film, for comparison.</summary>
    internal byte[] Content() =>
    [
        .. _sums.SelectMany(s => MemoryMarshal.AsBytes<Int128>(s).ToArray()), .. MemoryMarshal.AsBytes<uint>(_hits).ToArray(), .. MemoryMarshal.AsBytes<uint>(_counts).ToArray(),
        .. MemoryMarshal.AsBytes<uint>(_primitives).ToArray(), .. MemoryMarshal.AsBytes<long>(_costs).ToArray(),
    ];

    private static bool IsSummed(Aov kind) => kind is Aov.Depth or Aov.Normal or Aov.Albedo or Aov.Uv;

    private void ReadMean(Aov kind, long pixel, Span<double> values)
    {
        uint count = kind is Aov.Depth or Aov.Uv ? _hits![pixel] : _counts[pixel];
        for (int channel = 0; channel < values.Length; channel++)
        {
            double sum = (double)_sums[(int)kind]![(pixel * values.Length) + channel] / Units;
            values[channel] = count > 0 ? sum / count : kind == Aov.Depth ? double.PositiveInfinity : 0;
        }
    }
}
