using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Rendering;

/// <summary>Light that arrives straight from the sources: one point of every light for every hit (report, listing 6.4).</summary>
internal sealed class DirectLight(Scene scene, ShadowQueue? queue)
{
    // Lights whose samples are computed before their shadow rays are traced: independent chains of roots and
    // divisions then overlap in the processor (a tenth of the whole render on an AVX2 machine).
    private const int Batch = 8;
    private readonly LightSource[] _lights = [.. scene.Lights];
    private readonly ShapeSampleW[] _samples = new ShapeSampleW[Batch];
    private readonly RgbW[] _radiance = new RgbW[Batch];

    public long ShadowRays { get; private set; }

    /// <summary>Adds the light of all sources to the radiance of a packet, or has its shadow rays wait in the queue.</summary>
    /// <param name="surface">The lit points.</param>
    /// <param name="isSmoothed">Whether the points are shaded with another normal than the surface's own.</param>
    /// <param name="samples">Random numbers of the vertex.</param>
    /// <param name="time">Times in seconds; used only where something moves.</param>
    /// <param name="active">Lanes in use.</param>
    /// <param name="weight">Throughput times BRDF.</param>
    /// <param name="radiance">Added to.</param>
    public void Add(in SurfaceW surface, bool isSmoothed, VertexSamples samples, in FloatW time, in MaskW active, in RgbW weight, ref RgbW radiance)
    {
        Vec3W side = isSmoothed ? surface.Inside.Select(-surface.Normal, surface.Normal) : surface.Facing;
        Vec3W origin = Vec3W.MultiplyAdd(side, surface.Offset, surface.Point);
        RgbW arriving = default;
        queue?.Begin(weight);
        for (int first = 0; first < _lights.Length; first += Batch)
        {
            int count = Math.Min(Batch, _lights.Length - first);
            for (int i = 0; i < count; i++)
            {
                samples.Light(first + i, out FloatW u, out FloatW v);
                _lights[first + i].Sample(origin, u, v, time, out _samples[i], out _radiance[i]);
            }

            for (int i = 0; i < count; i++)
            {
                ref readonly ShapeSampleW sample = ref _samples[i];
                FloatW cosine = Vec3W.Dot(sample.Direction, surface.Facing);
                MaskW free = active & (cosine > 0f) & (sample.InversePdf > 0f);
                if (isSmoothed)
                {
                    // Light from behind the surface itself would come through it.
                    free &= Vec3W.Dot(sample.Direction, side) > 0f;
                }

                uint wanted = free.Bits;
                if (wanted != 0)
                {
                    ShadowRays += BitOperations.PopCount(wanted);
                    scene.Primitives.Occlude(origin, sample.Direction, sample.Distance, _lights[first + i].OwnPrimitive, ref free);
                    if (queue is not null)
                    {
                        queue.Add(free.Bits, origin, sample, time, first + i, _radiance[i], cosine);
                        continue;
                    }

                    arriving = RgbW.MultiplyAdd(_radiance[i], free.Select(cosine, 0f), arriving);
                }
            }
        }

        if (queue is null)
        {
            radiance = RgbW.MultiplyAdd(weight, arriving, radiance);
        }
    }
}
