using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// Splitting where paths first meet the scene (Arvo &amp; Kirk 1990): successive samples of a pixel share a camera ray and the light that comes straight from the
/// lamps to what it meets, and scatter from there each in its own direction. What is shared soon has little noise, and most of it comes later.
/// </summary>
/// <remarks>
/// It is a matter of random numbers alone: a sample has those of its ray for the camera and for the lights of its first vertex, and its own for the rest.
/// So it may be followed by itself, with the same result as together with those that share its ray.
/// </remarks>
internal sealed class Splitting
{
    // The first samples share no ray, so that a picture of few has smooth edges; and so many rays there are at least where samplers ask how many.
    private const int Alone = 16;
    private readonly int _alone;

    private Splitting(int ways, int alone, Sampler sampler) => (Ways, _alone, Sampler) = (ways, alone, sampler);

    /// <summary>The most samples that share a ray.</summary>
    public int Ways { get; }

    /// <summary>Places the rays.</summary>
    public Sampler Sampler { get; }

    /// <summary>Returns the splitting of a number of samples; null where each has a ray of its own.</summary>
    /// <param name="ways">The most samples that share a ray.</param>
    /// <param name="kind">How samples are placed.</param>
    /// <param name="sampler">Places all samples.</param>
    public static Splitting? Of(int ways, SamplerKind kind, Sampler sampler)
    {
        int samples = sampler.SamplesPerPixel;
        // Independent samples are those by which others are judged.
        if (ways == 1 || samples <= Alone || kind == SamplerKind.Independent)
        {
            return null;
        }

        if (!kind.DependsOnCount)
        {
            return new(ways, Alone, sampler);
        }

        // A grid of n×n samples is one of rays, each with a grid of samples: as large a one as leaves enough rays.
        int side = JitteredSampler.Root(samples) ?? 1;
        int part = (int)double.Sqrt(ways);
        while (part > 1 && (side % part != 0 || side / part * (side / part) < Alone))
        {
            part--;
        }

        return part == 1 ? null : new(part * part, 0, kind.Create(samples / (part * part)));
    }

    /// <summary>The number of a sample's ray in its pixel.</summary>
    public int RayOf(int sample) => sample < _alone ? sample : _alone + ((sample - _alone) / Ways);

    /// <summary>The first sample, from some one on, that shares no ray with the samples before it.</summary>
    public int EndOf(int sample) => sample <= _alone ? sample : _alone + ((sample - _alone + Ways - 1) / Ways * Ways);

    /// <summary>The numbers of samples' rays in their pixels.</summary>
    public UIntW RayOf(UIntW sample)
    {
        // The quotient in floats may be one off where there are millions of samples; the remainder decides.
        UIntW split = sample - (uint)_alone;
        UIntW group = (split.ToFloat() * (1f / Ways)).ToIntInRange();
        UIntW rest = split - (group * (uint)Ways);
        group = (rest > int.MaxValue).Select(group - 1u, (rest > (uint)(Ways - 1)).Select(group + 1u, group));
        return (sample < (uint)_alone).Select(sample, group + (uint)_alone);
    }

    /// <summary>The first of the samples that share each ray.</summary>
    public UIntW FirstOf(UIntW ray) => (ray < (uint)_alone).Select(ray, ((ray - (uint)_alone) * (uint)Ways) + (uint)_alone);

    /// <summary>The lanes in which a ray has a sample of that number among those that share it.</summary>
    public MaskW Has(UIntW ray, int way) => way == 0 ? MaskW.All : ~(ray < (uint)_alone);
}
