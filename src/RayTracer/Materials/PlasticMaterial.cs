using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>The common part of the descriptions of smooth and rough plastic.</summary>
public abstract record CoatedDescription : MaterialDescription
{
    /// <summary>Colour of the base.</summary>
    [Parameter("Fraction of the light that the matt base reflects, per channel.", Minimum = 0, Maximum = 1)]
    public TextureDescription Color { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.5f, 0.5f) };

    /// <summary>Refractive index of the coat.</summary>
    [Parameter("Refractive index of the clear coat relative to the outside: 1.49 is acrylic glass.", Minimum = 1, Maximum = 100)]
    public float RefractiveIndex { get; init; } = 1.49f;

    /// <summary>The base's colour deepens with each reflection inside the coat.</summary>
    [Parameter("Whether light that the coat throws back onto the base is coloured again each time, which deepens colours. Otherwise it is "
        + "coloured only once.")]
    public bool Nonlinear { get; init; }

    /// <summary>Factor on what the coat reflects.</summary>
    [Parameter("Factor on what the coat reflects, per channel: 1 for real coats.", Minimum = 0, Maximum = 1)]
    public TextureDescription SpecularReflectance { get; init; } = new SolidTextureDescription { Color = Rgb.White };
}

/// <summary>Describes a <see cref="PlasticMaterial"/>.</summary>
[SceneType("plastic", "Polished plastic: a matt base under a smooth clear coat, in which light is reflected back and forth.")]
public sealed record PlasticMaterialDescription : CoatedDescription
{
    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) =>
        new PlasticMaterial(builder.Texture(Color), RefractiveIndex, Nonlinear, builder.Texture(SpecularReflectance));
}

/// <summary>
/// A matt base under a smooth clear coat. Light gets through the coat by Fresnel's equations, once on its way in and once on its way out, and is reflected between
/// the two as often as it takes: f = T(in)·T(out)/n² · colour/(1 − colour·R)/π, with R the reflectance of the coat from inside for light from all
/// directions alike (the diffuse part of Weidlich &amp; Wilkie, Arbitrarily layered micro-facet surfaces, 2007, without absorption).
/// </summary>
/// <param name="base">Colour of the base.</param>
/// <param name="refractiveIndex">Index of the coat over that of the outside, at least 1.</param>
/// <param name="nonlinear">True if the colour counts in each reflection inside, or only once.</param>
/// <param name="reflectance">Factor on what the coat reflects.</param>
internal sealed class PlasticMaterial(Texture @base, float refractiveIndex, bool nonlinear, Texture reflectance) : Material
{
    private readonly float _inverse = 1 / refractiveIndex;
    private readonly float _inner = Fresnel.DiffuseReflectance(refractiveIndex);

    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new()
    {
        Specular = SpecularLobe.Glossy,
        KeepsEnergy = true,
        UsesUv = @base.Constant is null || reflectance.Constant is null,
    };

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => @base.Evaluate(surface, out surface.DiffuseColor);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        FloatW coat = Fresnel.Dielectric(surface.Cosine, _inverse, out _);
        reflectance.Evaluate(surface, out RgbW above);
        response = RgbW.MultiplyAdd(above, coat, Below(surface) * (1f - coat) * (1f - _inner));
    }

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        FloatW cosine = Vec3W.Dot(direction, surface.Facing);
        FloatW into = 1f - Fresnel.Dielectric(FloatW.Min(FloatW.Max(cosine, 0f), 1f), _inverse, out _);
        FloatW outOf = 1f - Fresnel.Dielectric(surface.Cosine, _inverse, out _);
        bsdf = (cosine > 0f).Select(Below(surface) * (into * outOf * (_inverse * _inverse / float.Pi)), default);
    }

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) => Bsdf(surface, direction, out bsdf);

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Coat(surface, out _, out _, out FloatW probability);
        pdf = Warp.CosineHemispherePdf(Vec3W.Dot(direction, surface.Facing)) * (1f - probability);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        Coat(surface, out FloatW coat, out RgbW above, out FloatW probability);
        MaskW reflects = samples.Choice() < probability;
        Onb.FromNormal(surface.Facing, out Onb frame);
        Vec3W matt = Warp.CosineHemisphere(u, v);
        Vec3W mirror = Vec3W.Normalize(Vec3W.MultiplyAdd(surface.Facing, surface.Cosine * 2f, surface.Incoming));
        scatter.Direction = reflects.Select(mirror, frame.ToWorld(matt));
        FloatW into = 1f - Fresnel.Dielectric(matt.Z, _inverse, out _);
        FloatW below = into * (1f - coat) * (_inverse * _inverse) / (1f - probability);
        scatter.Weight = reflects.Select(above * (coat / probability), Below(surface) * below);
        scatter.Specular = MaskW.All;
        scatter.Delta = reflects;
        scatter.Absorbed = MaskW.None;
    }

    // The base with all reflections between it and the coat.
    private RgbW Below(in SurfaceW surface)
    {
        RgbW color = surface.DiffuseColor;
        return nonlinear
            ? new(color.R / (1f - (color.R * _inner)), color.G / (1f - (color.G * _inner)), color.B / (1f - (color.B * _inner)))
            : color * (1 / (1 - _inner));
    }

    // The coat is chosen by what it and the base send on, each about.
    private void Coat(in SurfaceW surface, out FloatW coat, out RgbW above, out FloatW probability)
    {
        coat = Fresnel.Dielectric(surface.Cosine, _inverse, out _);
        reflectance.Evaluate(surface, out above);
        probability = LobeChoice.Probability(above * coat, surface.DiffuseColor * (1f - coat));
    }
}
