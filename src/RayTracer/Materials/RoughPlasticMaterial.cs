using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="RoughPlasticMaterial"/>.</summary>
[SceneType("roughPlastic", "Plastic with a satin finish: a matt base under a rough clear coat.")]
public sealed record RoughPlasticMaterialDescription : CoatedDescription
{
    /// <summary>The distribution of the microfacets' normals.</summary>
    [Parameter("How the tiny facets of the coat are tilted: \"ggx\" has long tails; \"beckmann\" is a rough surface of normally "
        + "distributed slopes.")]
    public MicrofacetDistribution Distribution { get; init; }

    /// <summary>Roughness of the coat.</summary>
    [Parameter("Roughness of the coat: the root mean square of the slopes, or about so. 0.01 is polished, 0.1 to 0.3 satin.",
        Minimum = 0, Maximum = 10)]
    public float Alpha { get; init; } = 0.1f;

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) =>
        new RoughPlasticMaterial(builder.Texture(Color), RefractiveIndex, Nonlinear, builder.Texture(SpecularReflectance), Distribution, Alpha);
}

/// <summary>
/// A matt base under a rough clear coat: as <see cref="PlasticMaterial"/>, but the coat reflects as microfacets do, and lets through what
/// <see cref="RoughTransmittance"/> gives.
/// </summary>
/// <param name="base">Colour of the base.</param>
/// <param name="refractiveIndex">Index of the coat over that of the outside, at least 1.</param>
/// <param name="nonlinear">True if the colour counts in each reflection inside, or only once.</param>
/// <param name="reflectance">Factor on what the coat reflects.</param>
/// <param name="distribution">The distribution of the microfacets' normals.</param>
/// <param name="alpha">Roughness of the coat.</param>
internal sealed class RoughPlasticMaterial(Texture @base, float refractiveIndex, bool nonlinear, Texture reflectance, MicrofacetDistribution distribution, float alpha) : Material
{
    private readonly float _inverse = 1 / refractiveIndex;
    private readonly RoughTransmittance _coat = new(distribution, alpha, refractiveIndex);

    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new() { Specular = SpecularLobe.Glossy, UsesUv = @base.Constant is null || reflectance.Constant is null };

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => @base.Evaluate(surface, out surface.DiffuseColor);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        FloatW into = _coat.Into(surface.Cosine);
        reflectance.Evaluate(surface, out RgbW above);
        response = RgbW.MultiplyAdd(above, 1f - into, Below(surface) * into * (1f - _coat.Inner));
    }

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Evaluate(surface, direction, out bsdf, out _);
    }

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        FloatW cosine = Vec3W.Dot(direction, surface.Facing);
        bsdf = (cosine > 0f).Select(Below(surface) * Through(cosine, _coat.Into(surface.Cosine)), default);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Evaluate(surface, direction, out _, out pdf);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        Onb.FromNormal(surface.Facing, out Onb frame);
        Vec3W view = frame.ToLocal(-surface.Incoming);
        reflectance.Evaluate(surface, out RgbW above);
        MaskW reflects = samples.Choice() < Probability(surface, above, _coat.Into(surface.Cosine));
        Vec3W normal = new Microfacets(distribution, alpha, alpha).Sample(view, u, v);
        Vec3W mirrored = Vec3W.MultiplyAdd(normal, Vec3W.Dot(view, normal) * 2f, -view);
        scatter.Direction = Vec3W.Normalize(frame.ToWorld(reflects.Select(mirrored, Warp.CosineHemisphere(u, v))));

        // Both lobes may choose each direction: what counts is their sum.
        Evaluate(surface, scatter.Direction, out RgbW bsdf, out FloatW pdf);
        scatter.Weight = bsdf * (Vec3W.Dot(scatter.Direction, surface.Facing) / pdf);
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.None;
        scatter.Absorbed = ~(pdf > 0f);
    }

    /// <inheritdoc/>
    public override void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        Onb.FromNormal(surface.Facing, out Onb frame);
        Vec3W view = frame.ToLocal(-surface.Incoming);
        Vec3W light = frame.ToLocal(direction);
        Vec3W normal = Vec3W.Normalize(view + light);
        Microfacets microfacets = new(distribution, alpha, alpha);
        reflectance.Evaluate(surface, out RgbW above);
        FloatW mirrored = microfacets.Reflection(view, light, normal) * Fresnel.Dielectric(FloatW.Min(Vec3W.Dot(view, normal), 1f), _inverse, out _);
        FloatW outOf = _coat.Into(surface.Cosine);
        FloatW probability = Probability(surface, above, outOf);
        MaskW isAbove = light.Z > 0f;
        bsdf = isAbove.Select(RgbW.MultiplyAdd(Below(surface), Through(light.Z, outOf), above * mirrored), default);
        FloatW both = FloatW.MultiplyAdd(probability, microfacets.ReflectionPdf(view, normal), (1f - probability) * Warp.CosineHemispherePdf(light.Z));
        pdf = isAbove.Select(both, 0f);
    }

    // What of the base's light goes into the coat and out of it again, in 1/sr.
    private FloatW Through(FloatW cosine, FloatW outOf) => _coat.Into(cosine) * outOf * (_inverse * _inverse / float.Pi);

    private RgbW Below(in SurfaceW surface)
    {
        RgbW color = surface.DiffuseColor;
        float inner = _coat.Inner;
        return nonlinear
            ? new(color.R / (1f - (color.R * inner)), color.G / (1f - (color.G * inner)), color.B / (1f - (color.B * inner)))
            : color * (1 / (1 - inner));
    }

    private static FloatW Probability(in SurfaceW surface, RgbW above, FloatW outOf) =>
        LobeChoice.Probability(above * (1f - outOf), surface.DiffuseColor * outOf);
}
