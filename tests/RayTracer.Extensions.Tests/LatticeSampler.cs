using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Extensions.Tests;

/// <summary>Points of a lattice, shifted at random in each pixel.</summary>
public sealed class LatticeKind() : SamplerKind("lattice")
{
    /// <inheritdoc/>
    public override bool DependsOnCount => true;

    /// <inheritdoc/>
    public override string? Complaint(int samplesPerPixel) => samplesPerPixel > 1 ? null : "a lattice needs at least 2 samples";

    /// <inheritdoc/>
    public override Sampler Create(int samplesPerPixel) => new LatticeSampler(samplesPerPixel);

    private sealed class LatticeSampler(int samplesPerPixel) : Sampler(samplesPerPixel)
    {
        public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points)
        {
            points.Key = Hash.GroupKey(pixelKey, group);
            points.First = sample * (uint)((1UL << 32) / (ulong)SamplesPerPixel);
            points.Second = sample * Hash.Golden;
        }

        public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v)
        {
            Hash.PairKeys(points.Key, pair, out UIntW first, out UIntW second);
            u = (points.First + Hash.Mix(first)).ToUnit();
            v = (points.Second + Hash.Mix(second)).ToUnit();
        }
    }
}
