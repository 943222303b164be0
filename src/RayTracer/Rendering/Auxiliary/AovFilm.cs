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
    private readonly (FirstHitImage Image, Int128[] Sums)[] _traced;
    private readonly (CryptomatteImage Image, MatteCounts Counts)[] _mattes;
    private readonly uint[] _counts;
    private readonly uint[] _hits;
    private readonly int _mostLetters;

    /// <summary>Makes empty images.</summary>
    /// <param name="film">The film that they stand beside: it has the size and the numbers of samples.</param>
    /// <param name="images">Which; memory is taken for no others.</param>
    public AovFilm(Film film, IEnumerable<AuxiliaryImage> images)
    {
        _film = film;
        Images = [.. images.Distinct()];
        long pixels = (long)film.Width * film.Height;
        _traced = [.. Images.OfType<FirstHitImage>().Select(image => (image, new Int128[checked(pixels * image.Letters.Length)]))];
        _mattes = [.. Images.OfType<CryptomatteImage>().Select(image => (image, new MatteCounts(pixels)))];
        _counts = new uint[NeedsRays ? pixels : 0];
        _hits = new uint[_traced.Any(t => t.Image.Mean == MeanOver.Hits) ? pixels : 0];
        _mostLetters = _traced.Max(t => (int?)t.Image.Letters.Length) ?? 0;
        Needs = _traced.Aggregate(FirstHitParts.None, (parts, t) => parts | t.Image.Needs);
    }

    /// <summary>The images that there are.</summary>
    public IReadOnlyList<AuxiliaryImage> Images { get; }

    /// <summary>Width in pixels.</summary>
    public int Width => _film.Width;

    /// <summary>Height in pixels.</summary>
    public int Height => _film.Height;

    /// <summary>True where rays must be traced for them.</summary>
    internal bool NeedsRays => _traced.Length > 0 || HasMattes;

    /// <summary>True where there are Cryptomattes.</summary>
    internal bool HasMattes => _mattes.Length > 0;

    /// <summary>The names of what Cryptomattes show, once rays are traced.</summary>
    internal MatteNames? Names { get; set; }

    /// <summary>The parts of hits that they need.</summary>
    internal FirstHitParts Needs { get; }

    /// <summary>Memory in bytes of images of a size.</summary>
    public static long Bytes(IReadOnlyCollection<AuxiliaryImage> images, int width, int height) =>
        ((long)width * height * images.OfType<FirstHitImage>().Aggregate(0L, (sum, image) => long.Max(sum, 8) + (16 * image.Letters.Length)))
        + (images.OfType<CryptomatteImage>().Count() * MatteCounts.Bytes((long)width * height));

    /// <summary>Returns whether there is an image.</summary>
    public bool Has(AuxiliaryImage image) => Images.Contains(image);

    /// <summary>Forgets all samples, so that the memory serves other images of this size and these kinds.</summary>
    public void Clear()
    {
        Array.ForEach(_traced, t => Array.Clear(t.Sums));
        Array.ForEach(_mattes, m => m.Counts.Clear());
        Array.Clear(_hits);
        Array.Clear(_counts);
    }

    /// <summary>Reads a row of an image.</summary>
    /// <param name="image">The image, one of <see cref="Images"/>.</param>
    /// <param name="y">The row, from the top.</param>
    /// <param name="values">Takes a number for each of <see cref="AuxiliaryImage.Letters"/>, for each pixel.</param>
    public void ReadRow(AuxiliaryImage image, int y, Span<double> values)
    {
        int letters = image.Letters.Length;
        Int128[]? sums = Array.Find(_traced, t => t.Image == image).Sums;
        for (int x = 0; x < Width; x++)
        {
            Span<double> at = values.Slice(x * letters, letters);
            if (image is FilmImage ofFilm)
            {
                ofFilm.Read(_film, x, y, at);
            }
            else if (image is CryptomatteImage matte)
            {
                Counts(matte).Show(((long)y * Width) + x, _counts[((long)y * Width) + x], at);
            }
            else
            {
                ReadMean((FirstHitImage)image, sums!, ((long)y * Width) + x, at);
            }
        }
    }

    /// <summary>What covers most of a pixel, by the number of its name, with the part that it covers.</summary>
    internal IEnumerable<(uint Id, double Part)> Covering(CryptomatteImage image, int x, int y)
    {
        long pixel = ((long)y * Width) + x;
        return Counts(image).Of(pixel).Select(s => (s.Id, (double)s.Count / _counts[pixel]));
    }

    /// <summary>The names of all that a Cryptomatte shows, by their numbers.</summary>
    internal IEnumerable<(string Name, uint Id)> Shown(CryptomatteImage image) => Counts(image).Ids().Select(id => (Names!.NameOf(id), id));

    /// <summary>Counts a sample of a pixel.</summary>
    internal void Count(long pixel, bool isHit)
    {
        _counts[pixel]++;
        if (isHit && _hits.Length > 0)
        {
            _hits[pixel]++;
        }
    }

    /// <summary>Adds a sample to the images that need the surface described, or to the others; one that meets nothing, to all.</summary>
    internal void Add(long pixel, in FirstHit hit, bool isDescribed)
    {
        if (HasMattes && hit.Primitive > 0 && !isDescribed)
        {
            foreach ((CryptomatteImage image, MatteCounts counts) in _mattes)
            {
                counts.Add(pixel, Names!.Of(image.Kind, (int)hit.Primitive - 1, (int)hit.Instance));
            }
        }

        Span<double> values = stackalloc double[_mostLetters];
        foreach ((FirstHitImage image, Int128[] sums) in _traced)
        {
            bool isMissing = hit.Primitive == 0;
            bool isLater = !isMissing && image.Needs.HasFlag(FirstHitParts.Surface) != isDescribed;
            if (isLater || (isMissing && image.Mean == MeanOver.Hits) || (hit.Sample > 0 && image.Mean == MeanOver.First))
            {
                continue;
            }

            Span<double> own = values[..image.Letters.Length];
            own.Clear();
            image.Read(hit, own);
            for (int i = 0; i < own.Length; i++)
            {
                double units = double.Round(Math.Clamp(double.IsNaN(own[i]) ? 0 : own[i], -Limit, Limit) * Units);
                sums[(pixel * own.Length) + i] += Math.Abs(own[i]) < OrdinaryLimit ? (long)units : (Int128)units;
            }
        }
    }

    /// <summary>All that is stored but the film, for comparison.</summary>
    internal byte[] Content() =>
    [
        .. _traced.SelectMany(t => MemoryMarshal.AsBytes<Int128>(t.Sums).ToArray()),
        .. _mattes.SelectMany(m => Enumerable.Range(0, Width * Height).SelectMany(p => m.Counts.Of(p)).SelectMany(s => BitConverter.GetBytes(((ulong)s.Id << 32) | s.Count))),
        .. MemoryMarshal.AsBytes<uint>(_hits),
        .. MemoryMarshal.AsBytes<uint>(_counts),
    ];

    private MatteCounts Counts(CryptomatteImage image) => Array.Find(_mattes, m => m.Image == image).Counts;

    private void ReadMean(FirstHitImage image, Int128[] sums, long pixel, Span<double> values)
    {
        uint count = image.Mean switch { MeanOver.Hits => _hits[pixel], MeanOver.First => 1, _ => _counts[pixel] };
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = count > 0 ? Film.ToDouble(sums[(pixel * values.Length) + i]) / Units / count : image.Nothing;
        }
    }
}
