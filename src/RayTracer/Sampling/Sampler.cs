using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// Places the samples of a pixel in the unit square of each pair of dimensions. A sampler has no state: the numbers are a
/// function of the pixel's key (which holds the seed), the sample and the pair, all in [0, 1).
/// <see cref="Dimensions"/> says which pair decides what.
/// </summary>
/// <param name="samplesPerPixel">How many samples a pixel will have.</param>
public abstract class Sampler(int samplesPerPixel)
{
    /// <summary>How many samples a pixel will have.</summary>
    public int SamplesPerPixel { get; } = samplesPerPixel;

    /// <summary>Makes the sampler that a description asks for.</summary>
    /// <param name="render">The description; its number of samples must suit the sampler (<see cref="Complaint"/>).</param>
    public static Sampler Create(RenderDescription render) => render.Sampler switch
    {
        SamplerKind.Jittered => new JitteredSampler(render.SamplesPerPixel),
        SamplerKind.Regular => new RegularSampler(render.SamplesPerPixel),
        SamplerKind.Independent => new IndependentSampler(render.SamplesPerPixel),
        _ => new SobolSampler(render.SamplesPerPixel),
    };

    /// <summary>Says why a sampler cannot have that many samples, or returns null where it can.</summary>
    public static string? Complaint(SamplerKind kind, int samplesPerPixel)
    {
        if (kind is not (SamplerKind.Jittered or SamplerKind.Regular) || JitteredSampler.Root(samplesPerPixel) is not null)
        {
            return null;
        }

        int below = (int)double.Sqrt(samplesPerPixel);
        string name = kind == SamplerKind.Jittered ? "jittered" : "regular";
        return $"the {name} sampler needs a square number of samples, but {samplesPerPixel} is none: take {below * below} or {(below + 1) * (below + 1)}";
    }

    /// <summary>One point of the unit square for each lane.</summary>
    /// <param name="pixelKey">Keys of the pixels (<see cref="Hash.PixelKey"/>).</param>
    /// <param name="sample">Numbers of the samples, from 0.</param>
    /// <param name="pair">Numbers of the pairs of dimensions.</param>
    /// <param name="u">First coordinate.</param>
    /// <param name="v">Second coordinate.</param>
    public abstract void Pair(in UIntW pixelKey, in UIntW sample, in UIntW pair, out FloatW u, out FloatW v);
}

/// <summary>
/// Which pair of dimensions decides what. A path's vertices follow one another, each with its own pairs, so that no random
/// number is used twice (the report used its own again down the recursion, which correlates the samples).
/// </summary>
public static class Dimensions
{
    /// <summary>The position within the pixel.</summary>
    public const uint Pixel = 0;

    /// <summary>The position on the lens.</summary>
    public const uint Lens = 1;

    /// <summary>What else the camera needs: the third coordinate of the report's eye jitter.</summary>
    public const uint Camera = 2;

    /// <summary>The first pair of the first vertex.</summary>
    public const uint FirstVertex = 3;

    /// <summary>Within a vertex: the direction of scattering.</summary>
    public const uint Direction = 0;

    /// <summary>Within a vertex: the choice of a lobe.</summary>
    public const uint Choice = 1;

    /// <summary>Within a vertex: the point on the first light; the other lights follow.</summary>
    public const uint FirstLight = 2;

    /// <summary>Pairs of one vertex.</summary>
    /// <param name="lights">How many lights are sampled.</param>
    public static uint PerVertex(int lights) => FirstLight + (uint)lights;
}

/// <summary>The random numbers of one vertex of each lane's path.</summary>
public readonly ref struct VertexSamples
{
    private readonly Sampler _sampler;
    private readonly UIntW _pixelKey;
    private readonly UIntW _sample;
    private readonly UIntW _firstPair;

    /// <summary>Names the vertex.</summary>
    /// <param name="sampler">Where the numbers come from.</param>
    /// <param name="pixelKey">Keys of the pixels.</param>
    /// <param name="sample">Numbers of the samples.</param>
    /// <param name="firstPair">The vertex's first pair of dimensions.</param>
    public VertexSamples(Sampler sampler, in UIntW pixelKey, in UIntW sample, in UIntW firstPair)
    {
        _sampler = sampler;
        _pixelKey = pixelKey;
        _sample = sample;
        _firstPair = firstPair;
    }

    /// <summary>The two numbers that choose the direction of scattering.</summary>
    public void Direction(out FloatW u, out FloatW v) => _sampler.Pair(_pixelKey, _sample, _firstPair + Dimensions.Direction, out u, out v);

    /// <summary>The number that chooses between lobes.</summary>
    public FloatW Choice()
    {
        _sampler.Pair(_pixelKey, _sample, _firstPair + Dimensions.Choice, out FloatW u, out _);
        return u;
    }

    /// <summary>The two numbers that choose a point on a light.</summary>
    /// <param name="light">The light's number.</param>
    /// <param name="u">First number.</param>
    /// <param name="v">Second number.</param>
    public void Light(int light, out FloatW u, out FloatW v) =>
        _sampler.Pair(_pixelKey, _sample, _firstPair + (Dimensions.FirstLight + (uint)light), out u, out v);
}
