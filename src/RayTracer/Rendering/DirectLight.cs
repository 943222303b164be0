using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Rendering;

/// <summary>Light that arrives straight from the sources: one point of every light for every hit (report, listing 6.4).</summary>
internal sealed class DirectLight(Scene scene)
{
    private readonly AreaLight[] _lights = [.. scene.Lights];

    public long ShadowRays { get; private set; }

    /// <summary>Adds the light of all sources to the radiance of a packet.</summary>
    /// <param name="surface">The lit points.</param>
    /// <param name="samples">Random numbers of the vertex.</param>
    /// <param name="active">Lanes in use.</param>
    /// <param name="weight">Throughput times BRDF.</param>
    /// <param name="radiance">Added to.</param>
    [SkipLocalsInit]
    public void Add(in SurfaceW surface, in VertexSamples samples, in MaskW active, in RgbW weight, ref RgbW radiance)
    {
        Vec3W origin = Vec3W.MultiplyAdd(surface.Facing, surface.Offset, surface.Point);
        RgbW arriving = default;
        for (int i = 0; i < _lights.Length; i++)
        {
            AreaLight light = _lights[i];
            samples.Light(i, out FloatW u, out FloatW v);
            light.Sample(origin, u, v, out ShapeSampleW sample, out RgbW emitted);
            FloatW cosine = Vec3W.Dot(sample.Direction, surface.Facing);
            MaskW free = active & (cosine > 0f) & (sample.InversePdf > 0f);
            uint wanted = free.Bits;
            if (wanted == 0)
            {
                continue;
            }

            ShadowRays += BitOperations.PopCount(wanted);
            scene.Primitives.Occlude(origin, sample.Direction, sample.Distance, light.Primitive, ref free);
            arriving = RgbW.MultiplyAdd(emitted, free.Select(cosine * sample.InversePdf, 0f), arriving);
        }

        radiance = RgbW.MultiplyAdd(weight, arriving, radiance);
    }
}
