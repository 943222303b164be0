using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Media;
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
    private readonly LightSource[] _lights = [.. scene.SampledLights];
    private readonly Transmittance? _transmittance = scene.HasMedia ? new(scene) : null;
    private readonly ShapeSampleW[] _samples = new ShapeSampleW[Batch];
    private readonly RgbW[] _radiance = new RgbW[Batch];

    public long ShadowRays { get; private set; }

    /// <summary>
    /// The share of one way to choose a direction among two (Veach 1997, section 9.2, power heuristic with exponent 2): pdf² / (pdf² + other²).
    /// </summary>
    /// <param name="pdf">Density of that way.</param>
    /// <param name="other">Density of the other.</param>
    public static FloatW Weight(FloatW pdf, FloatW other)
    {
        FloatW ratio = other / pdf;
        return 1f / FloatW.MultiplyAdd(ratio, ratio, 1f);
    }

    /// <summary>Adds the light of all sources to the radiance of a packet, or has its shadow rays wait in the queue.</summary>
    /// <param name="surface">The lit points.</param>
    /// <param name="material">
    /// What scatters the light, by its BSDF, where scattered rays are to find the rest of it; null where what is scattered is the same for all
    /// directions on the ray's side and <paramref name="weight"/> has it, and no scattered ray looks for lights.
    /// </param>
    /// <param name="media">The media on the ray's side; used only where the scene has media.</param>
    /// <param name="isSmoothed">Whether the points are shaded with another normal than the surface's own.</param>
    /// <param name="samples">Random numbers of the vertex.</param>
    /// <param name="time">Times in seconds; used only where something moves.</param>
    /// <param name="active">Lanes in use.</param>
    /// <param name="weight">Throughput, times BRDF where there is no material.</param>
    /// <param name="radiance">Added to.</param>
    public void Add(in SurfaceW surface, Material? material, in UIntW media, bool isSmoothed, VertexSamples samples, in FloatW time, in MaskW active, in RgbW weight, ref RgbW radiance)
    {
        Vec3W side = isSmoothed ? surface.Inside.Select(-surface.Normal, surface.Normal) : surface.Facing;
        Vec3W origin = Vec3W.MultiplyAdd(side, surface.Offset, surface.Point);
        bool transmits = material is { Transmits: true };
        Vec3W from = transmits ? surface.Point : origin;
        RgbW arriving = default;
        queue?.Begin(weight);
        for (int first = 0; first < _lights.Length; first += Batch)
        {
            int count = Math.Min(Batch, _lights.Length - first);
            for (int i = 0; i < count; i++)
            {
                samples.Light(first + i, out FloatW u, out FloatW v);
                _lights[first + i].Sample(from, u, v, time, out _samples[i], out _radiance[i]);
            }

            for (int i = 0; i < count; i++)
            {
                ref readonly ShapeSampleW sample = ref _samples[i];
                FloatW cosine = Vec3W.Dot(sample.Direction, surface.Facing);
                MaskW free = active & (sample.InversePdf > 0f);
                if (transmits)
                {
                    free = free.Except(SurfaceShader.Leaks(surface, sample.Direction));
                    origin = SurfaceShader.Leave(surface, sample.Direction);
                    cosine = FloatW.Abs(cosine);
                }
                else
                {
                    free &= cosine > 0f;
                    if (isSmoothed)
                    {
                        // Light from behind the surface itself would come through it.
                        free &= Vec3W.Dot(sample.Direction, side) > 0f;
                    }
                }

                if (material is not null && free.Any)
                {
                    Scatter(surface, material, first + i, sample, ref free, ref _radiance[i]);
                }

                uint wanted = free.Bits;
                if (wanted != 0)
                {
                    ShadowRays += BitOperations.PopCount(wanted);
                    if (_transmittance is not null)
                    {
                        UIntW there = SurfaceShader.MediaAlong(surface, sample.Direction, scene.NumberOf(material!.Interior), media);
                        _transmittance.Trace(wanted, origin, sample.Direction, sample.Distance, there, time, _lights[first + i], out RgbW part);
                        arriving = RgbW.MultiplyAdd(_radiance[i] * part, cosine, arriving);
                        continue;
                    }

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

    /// <summary>Adds the light of all sources that a medium scatters back along the ray.</summary>
    /// <param name="point">The lit points.</param>
    /// <param name="incoming">Unit directions of the rays.</param>
    /// <param name="anisotropy">The medium's mean cosines of the angle of scattering.</param>
    /// <param name="media">The media there.</param>
    /// <param name="samples">Random numbers of the vertex.</param>
    /// <param name="time">Times in seconds; used only where something moves.</param>
    /// <param name="active">Lanes in use.</param>
    /// <param name="weight">Throughput.</param>
    /// <param name="radiance">Added to.</param>
    public void AddInMedium(
        in Vec3W point, in Vec3W incoming, in FloatW anisotropy, in UIntW media, VertexSamples samples, in FloatW time, in MaskW active, in RgbW weight, ref RgbW radiance)
    {
        for (int i = 0; i < _lights.Length; i++)
        {
            samples.Light(i, out FloatW u, out FloatW v);
            _lights[i].Sample(point, u, v, time, out ShapeSampleW sample, out RgbW light);
            MaskW lit = active & (sample.InversePdf > 0f);
            if (lit.Any)
            {
                ShadowRays += BitOperations.PopCount(lit.Bits);
                FloatW phase = HenyeyGreenstein.Evaluate(Vec3W.Dot(incoming, sample.Direction), anisotropy);
                FloatW share = _lights[i].IsDelta ? phase : phase * Weight(1f, phase * sample.InversePdf);
                _transmittance!.Trace(lit.Bits, point, sample.Direction, sample.Distance, media, time, _lights[i], out RgbW part);
                radiance = RgbW.MultiplyAdd(weight * light * share, part, radiance);
            }
        }
    }

    // What of a light's sample goes on, and what scattered rays leave of it.
    private void Scatter(in SurfaceW surface, Material material, int light, in ShapeSampleW sample, ref MaskW free, ref RgbW radiance)
    {
        material.Bsdf(surface, sample.Direction, out RgbW bsdf);
        free = free.Except((bsdf.R <= 0f) & (bsdf.G <= 0f) & (bsdf.B <= 0f));
        radiance *= bsdf;
        if (!_lights[light].IsDelta)
        {
            material.Pdf(surface, sample.Direction, out FloatW pdf);
            radiance *= Weight(1f, pdf * sample.InversePdf);
        }
    }
}
