using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>The things that a Cryptomatte tells apart.</summary>
public enum CryptomatteKind
{
    /// <summary>Shapes, meshes and instances.</summary>
    Object,

    /// <summary>Materials.</summary>
    Material,
}

/// <summary>
/// How much of each pixel each thing covers, by the hash of its name (J. Friedman and A. C. Jones, Fully automatic ID mattes with support for motion blur and transparency, 2015;
/// Psyop's Cryptomatte specification 1.2): compositing programs make masks of it. All things of a pixel are counted, so that threads and order cannot change a bit; files
/// hold those that cover most.
/// </summary>
/// <param name="Kind">The things that are distinguished.</param>
public sealed record CryptomatteImage(CryptomatteKind Kind) : AuxiliaryImage
{
    /// <summary>The things of a pixel that files hold.</summary>
    public const int Ranks = 6;

    /// <inheritdoc/>
    public override string Name => $"crypto{Kind}";

    /// <summary>The name of its layers in files: CryptoObject00 and so on.</summary>
    public string Layer => $"Crypto{Kind}";

    /// <inheritdoc/>
    public override string Title => $"Cryptomatte ({Things})";

    /// <inheritdoc/>
    public override string Description => $"Each {Kind.ToString().ToLowerInvariant()} in a different colour; .exr files hold a Cryptomatte, by which compositing programs make masks of {Things} by their names.";

    /// <inheritdoc/>
    public override string Letters => "RGB";

    /// <inheritdoc/>
    public override IReadOnlyList<Rgb> Scale => PrimitiveImage.Colors;

    private string Things => Kind == CryptomatteKind.Object ? "objects" : "materials";

    /// <inheritdoc/>
    public override string Legend(NumberRange range) => $"a colour for each of the {Things}, mixed where several share a pixel; black where nothing is hit";

    /// <inheritdoc/>
    public override (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range) => (values[0], values[1], values[2]);
}

/// <summary>How often samples of each pixel have met what.</summary>
/// <param name="pixels">The number of pixels.</param>
internal sealed class MatteCounts(long pixels)
{
    private readonly (uint Id, uint Count)[]?[] _seen = new (uint, uint)[pixels][];

    /// <summary>Memory in bytes of so many pixels, of which most show one or two things.</summary>
    public static long Bytes(long pixels) => 48 * pixels;

    /// <summary>Counts a sample.</summary>
    public void Add(long pixel, uint id)
    {
        ref (uint Id, uint Count)[]? seen = ref _seen[pixel];
        int at = seen is null ? 0 : Array.FindIndex(seen, s => s.Id == id || s.Count == 0);
        if (at < 0 || seen is null)
        {
            at = seen?.Length ?? 0;
            Array.Resize(ref seen, 1 + (2 * at));
        }

        seen[at] = (id, seen[at].Count + 1);
    }

    /// <summary>What is seen in a pixel, the most first; of as much, by its number.</summary>
    public IEnumerable<(uint Id, uint Count)> Of(long pixel) => (_seen[pixel] ?? []).Where(s => s.Count > 0).OrderByDescending(s => s.Count).ThenBy(s => s.Id);

    /// <summary>All that is seen anywhere.</summary>
    public IEnumerable<uint> Ids() => _seen.Where(s => s is not null).SelectMany(s => s!).Where(s => s.Count > 0).Select(s => s.Id).Distinct();

    /// <summary>Forgets all.</summary>
    public void Clear() => Array.Clear(_seen);

    /// <summary>A colour to look at, of display values: that of <see cref="PrimitiveImage"/> for each, mixed.</summary>
    /// <param name="pixel">The pixel.</param>
    /// <param name="samples">Its samples.</param>
    /// <param name="values">Takes red, green and blue.</param>
    public void Show(long pixel, uint samples, Span<double> values)
    {
        values.Clear();
        foreach ((uint id, uint count) in Of(pixel))
        {
            (double r, double g, double b) = PrimitiveImage.ColorOf(Hash.Mix(id));
            double part = (double)count / samples;
            (values[0], values[1], values[2]) = (values[0] + (part * r), values[1] + (part * g), values[2] + (part * b));
        }
    }
}
