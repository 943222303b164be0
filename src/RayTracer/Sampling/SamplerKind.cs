using RayTracer.Sampling;

namespace RayTracer.Description;

/// <summary>The placement of the samples of a pixel: a sampler before their number is known.</summary>
/// <param name="name">The name in scene files, in camelCase.</param>
public abstract class SamplerKind(string name) : NamedValue(name)
{
    /// <summary>Owen-scrambled Sobol points.</summary>
    public static SamplerKind Sobol { get; } = new SobolKind();

    /// <summary>The report's n×n jittered grid.</summary>
    public static SamplerKind Jittered { get; } = new JitteredKind();

    /// <summary>The report's uniform grid: the same n×n points in every pixel, which shows aliasing.</summary>
    public static SamplerKind Regular { get; } = new RegularKind();

    /// <summary>Independent random numbers.</summary>
    public static SamplerKind Independent { get; } = new IndependentKind();

    /// <summary>All samplers.</summary>
    public static Registry<SamplerKind> Known { get; } = new("sampler", s => [s.Name], Sobol, Jittered, Regular, Independent);

    /// <summary>
    /// True where the place of a sample depends on how many there are; otherwise further samples continue those of a picture with fewer.
    /// </summary>
    public virtual bool DependsOnCount => false;

    /// <summary>Says why a pixel cannot have that many samples; null where it can.</summary>
    public virtual string? Complaint(int samplesPerPixel) => null;

    /// <summary>Makes the sampler.</summary>
    /// <param name="samplesPerPixel">The number of samples that a pixel will have; there is no <see cref="Complaint"/> about it.</param>
    public abstract Sampler Create(int samplesPerPixel);
}
