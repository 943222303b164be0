using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>Independent random numbers: the yardstick for the others. The variance of a mean falls as 1/N.</summary>
/// <param name="samplesPerPixel">The number of samples that a pixel will have.</param>
internal sealed class IndependentSampler(int samplesPerPixel) : Sampler(samplesPerPixel)
{
    /// <inheritdoc/>
    public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points)
    {
        points.Key = Hash.GroupKey(pixelKey, group);
        points.First = points.Second = sample;
    }

    /// <inheritdoc/>
    public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v)
    {
        Hash.PairKeys(points.Key, pair, out UIntW key, out _);
        Draw(key, points.First, out u, out v);
    }

    /// <summary>Two random numbers from a key and a counter.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Draw(UIntW key, UIntW counter, out FloatW u, out FloatW v)
    {
        UIntW first = Hash.Mix(key + (counter * 0xC2B2AE3Du));
        u = first.ToUnit();
        v = Hash.Mix(first ^ 0x27D4EB2Fu).ToUnit();
    }
}

/// <summary>The independent sampler.</summary>
internal sealed class IndependentKind() : SamplerKind("independent")
{
    public override Sampler Create(int samplesPerPixel) => new IndependentSampler(samplesPerPixel);
}
