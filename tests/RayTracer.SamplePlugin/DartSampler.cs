using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.SamplePlugin;

/// <summary>Points thrown like darts.</summary>
public sealed class DartKind() : SamplerKind("dart")
{
    /// <inheritdoc/>
    public override Sampler Create(int samplesPerPixel) => new DartSampler(samplesPerPixel);
}

/// <summary>Independent numbers from a hash of pixel, sample and dimension.</summary>
public sealed class DartSampler(int samplesPerPixel) : Sampler(samplesPerPixel)
{
    /// <inheritdoc/>
    public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points)
    {
        points.Key = Hash.Mix(pixelKey + (group * 0x9E3779B9u));
        points.First = points.Second = sample;
    }

    /// <inheritdoc/>
    public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v)
    {
        UIntW first = Hash.Mix(points.Key + (points.First * 0xC2B2AE3Du) + (pair * 0x85EBCA6Bu));
        u = first.ToUnit();
        v = Hash.Mix(first ^ 0x27D4EB2Fu).ToUnit();
    }
}
