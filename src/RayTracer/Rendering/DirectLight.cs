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
    // Lights whose samples are computed before their shadow rays are traced: independent chains of roots and
    // divisions then overlap in the processor (a tenth of the whole render on an AVX2 machine).
    private const int Batch = 8;
    private readonly AreaLight[] _lights = [.. scene.Lights];
    private readonly Contribution[] _contributions = new Contribution[Batch];

    public long ShadowRays { get; private set; }

    /// <summary>Adds the light of all sources to the radiance of a packet.</summary>
    /// <param name="surface">The lit points.</param>
    /// <param name="samples">Random numbers of the vertex.</param>
    /// <param name="active">Lanes in use.</param>
    /// <param name="weight">Throughput times BRDF.</param>
    /// <param name="radiance">Added to.</param>
    public void Add(in SurfaceW surface, VertexSamples samples, in MaskW active, in RgbW weight, ref RgbW radiance)
    {
        Vec3W origin = Vec3W.MultiplyAdd(surface.Facing, surface.Offset, surface.Point);
        RgbW arriving = default;
        for (int first = 0; first < _lights.Length; first += Batch)
        {
            int count = Math.Min(Batch, _lights.Length - first);
            for (int i = 0; i < count; i++)
            {
                Sample(first + i, surface, origin, samples, out _contributions[i]);
            }

            for (int i = 0; i < count; i++)
            {
                ref readonly Contribution light = ref _contributions[i];
                MaskW free = active & light.Reaches;
                uint wanted = free.Bits;
                if (wanted != 0)
                {
                    ShadowRays += BitOperations.PopCount(wanted);
                    scene.Primitives.Occlude(origin, light.Direction, light.Distance, _lights[first + i].Primitive, ref free);
                    arriving = RgbW.MultiplyAdd(light.Radiance, free.Select(light.Cosine, 0f), arriving);
                }
            }
        }

        radiance = RgbW.MultiplyAdd(weight, arriving, radiance);
    }

    private void Sample(int number, in SurfaceW surface, in Vec3W origin, VertexSamples samples, out Contribution light)
    {
        samples.Light(number, out FloatW u, out FloatW v);
        _lights[number].Sample(origin, u, v, out ShapeSampleW sample, out light.Radiance);
        light.Direction = sample.Direction;
        light.Distance = sample.Distance;
        light.Cosine = Vec3W.Dot(sample.Direction, surface.Facing);
        light.Reaches = (light.Cosine > 0f) & (sample.InversePdf > 0f);
    }

    /// <summary>What a light would add if nothing stood in the way.</summary>
    private struct Contribution
    {
        public Vec3W Direction;
        public FloatW Distance;
        public RgbW Radiance;
        public FloatW Cosine;
        public MaskW Reaches;
    }
}
