using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="CoatedConductorMaterial"/>.</summary>
[SceneType("coatedConductor", "Metal under a clear coat: lacquered brass, candy paint. The coat mirrors some light, bends the rest on its way to the metal and out again, "
    + "throws some of that back onto the metal, and may absorb a part.")]
public sealed record CoatedConductorMaterialDescription : MetalDescription
{
    /// <summary>Roughness of the metal.</summary>
    [Parameter("Roughness of the metal below the coat, as of roughConductor with \"ggx\"; 0 is a mirror.", Minimum = 0, Maximum = 10)]
    public float Alpha { get; init; } = 0.1f;

    /// <summary>Roughness of the coat.</summary>
    [Parameter("Roughness of the coat's surface; 0 is polished.", Minimum = 0, Maximum = 10)]
    public float CoatAlpha { get; init; }

    /// <summary>Refractive index of the coat.</summary>
    [Parameter("Refractive index of the coat relative to the outside. That of the metal is relative to the outside, too.", Minimum = 1, Maximum = 100)]
    public float CoatIndex { get; init; } = 1.5f;

    /// <summary>What the coat absorbs.</summary>
    [Parameter("What the coat absorbs, per channel: of light that goes straight through once, exp(−x) is left; of slanting light less. It tints the metal.", Minimum = 0, Maximum = 100)]
    public Rgb CoatAbsorption { get; init; }

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) =>
        new CoatedConductorMaterial(BuildFresnel(builder, CoatIndex), Alpha, new(CoatAlpha, CoatIndex, CoatAbsorption), builder.Texture(SpecularReflectance));
}

/// <summary>A clear coat.</summary>
internal sealed class ClearCoat
{
    // Rougher ones have a density.
    private const float Smooth = 1e-3f;
    private readonly RoughTransmittance? _rough;
    private readonly float _inverse;

    /// <summary>Makes one.</summary>
    /// <param name="alpha">Roughness of its surface.</param>
    /// <param name="index">Its index over that of the outside, at least 1.</param>
    /// <param name="absorption">The optical depth of its thickness.</param>
    public ClearCoat(float alpha, float index, Rgb absorption)
    {
        (Alpha, Index, Absorption, _inverse) = (alpha, index, absorption, 1 / index);
        _rough = IsSmooth(alpha) ? null : new(MicrofacetDistribution.Ggx, alpha, index);
    }

    /// <summary>Roughness of its surface.</summary>
    public float Alpha { get; }

    /// <summary>Its index over that of the outside.</summary>
    public float Index { get; }

    /// <summary>The optical depth of its thickness.</summary>
    public Rgb Absorption { get; }

    /// <summary>True where its surface has a density of directions.</summary>
    public bool IsRough => _rough is not null;

    /// <summary>The microfacets of its surface.</summary>
    public Microfacets Facets => new(MicrofacetDistribution.Ggx, Alpha, Alpha);

    /// <summary>True where a surface is so smooth that it mirrors.</summary>
    public static bool IsSmooth(float alpha) => alpha < Smooth;

    /// <summary>The fraction of light that gets in.</summary>
    /// <param name="cosine">Cosine of the ray outside, at least 0.</param>
    /// <param name="inside">That inside, as by a smooth surface.</param>
    public FloatW Into(in FloatW cosine, out FloatW inside)
    {
        FloatW smooth = 1f - Fresnel.Dielectric(FloatW.Min(cosine, 1f), _inverse, out inside);
        return _rough?.Into(cosine) ?? smooth;
    }
}

/// <summary>
/// Metal under a clear coat. The coat reflects by Fresnel's equations. What it lets through is bent as by a smooth surface, reflected by the metal's microfacets and let
/// out: f = T(in)·T(out)/n² · f_metal(bent directions) · exp(−x/cos − x/cos) (Weidlich &amp; Wilkie, Arbitrarily layered micro-facet surfaces, 2007). Light that goes back
/// and forth is added by <see cref="CoatBounces"/>: in the same directions, by the root of a factor for each of the two, and as a rest in all directions (Kulla &amp; Conty,
/// Revisiting physically based shading, 2017), so that the material is reciprocal. A rough coat is passed twice, which blurs the metal as if that were rougher.
/// </summary>
internal sealed class CoatedConductorMaterial : Material
{
    private readonly ConductorFresnel _metal;
    private readonly ClearCoat _coat;
    private readonly float _alpha;
    private readonly float _inverse;
    private readonly Texture _reflectance;
    private readonly CoatBounces _bounces;
    private readonly bool _isMirror;

    /// <summary>Makes one.</summary>
    /// <param name="metal">The metal's reflectance, inside the coat.</param>
    /// <param name="alpha">Roughness of the metal.</param>
    /// <param name="coat">The coat.</param>
    /// <param name="reflectance">Factor on what the metal reflects.</param>
    public CoatedConductorMaterial(ConductorFresnel metal, float alpha, ClearCoat coat, Texture reflectance)
    {
        (_metal, _coat, _reflectance, _inverse) = (metal, coat, reflectance, 1 / coat.Index);

        // A facet of the coat that is tilted by m bends a ray by (n − 1)·m, measured outside, and so do both together by √2 times that; one of the metal, by 2·n·m.
        float blur = (coat.Index - 1) * _inverse * coat.Alpha;
        _alpha = float.Sqrt((alpha * alpha) + (0.5f * blur * blur));
        _bounces = new(metal, alpha, _alpha, coat);
        _isMirror = ClearCoat.IsSmooth(alpha) && !coat.IsRough;
        Traits = new() { Specular = _isMirror ? SpecularLobe.Delta : SpecularLobe.Glossy, UsesUv = reflectance.Constant is null };
    }

    /// <inheritdoc/>
    public override MaterialTraits Traits { get; }

    private Microfacets MetalFacets => new(MicrofacetDistribution.Ggx, _alpha, _alpha);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        Look(surface, surface.Cosine, out Side side);
        response = side.Mirrored + new RgbW(side.Above, side.Above, side.Above) + (_isMirror ? default : side.Rest);
    }

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Evaluate(surface, direction, out bsdf, out _);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Evaluate(surface, direction, out _, out pdf);
    }

    /// <inheritdoc/>
    public override void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        (bsdf, pdf) = (default, 0f);
        if (_isMirror)
        {
            return;
        }

        Onb.FromNormal(surface.Facing, out Onb frame);
        Vec3W view = frame.ToLocal(-surface.Incoming);
        Vec3W light = frame.ToLocal(direction);
        MaskW isAbove = light.Z > 0f;
        Look(surface, view.Z, out Side viewSide);
        Look(surface, FloatW.Max(light.Z, 0f), out Side lightSide);

        Vec3W bentView = new(view.X * _inverse, view.Y * _inverse, viewSide.Inside);
        Vec3W bentLight = new(light.X * _inverse, light.Y * _inverse, lightSide.Inside);
        Vec3W normal = Vec3W.Normalize(bentView + bentLight);
        Metal(surface, Vec3W.Dot(bentView, normal), out RgbW color);
        bsdf = color * viewSide.Through * lightSide.Through * (MetalFacets.Reflection(bentView, bentLight, normal) * (_inverse * _inverse));
        bsdf += viewSide.Rest * lightSide.Rest * (RgbW)_bounces.Spread;
        pdf = viewSide.MetalShare * MetalFacets.ReflectionPdf(bentView, normal) * (light.Z * _inverse * _inverse / lightSide.Inside);
        pdf = FloatW.MultiplyAdd(viewSide.RestShare, Warp.CosineHemispherePdf(light.Z), pdf);
        if (_coat.IsRough)
        {
            normal = Vec3W.Normalize(view + light);
            FloatW mirrored = _coat.Facets.Reflection(view, light, normal) * Fresnel.Dielectric(FloatW.Min(Vec3W.Dot(view, normal), 1f), _inverse, out _);
            bsdf += new RgbW(mirrored, mirrored, mirrored);
            pdf = FloatW.MultiplyAdd(viewSide.AboveShare, _coat.Facets.ReflectionPdf(view, normal), pdf);
        }

        bsdf = isAbove.Select(bsdf, default);
        pdf = isAbove.Select(pdf, 0f);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.All;
        scatter.Absorbed = MaskW.None;
        Vec3W mirror = Vec3W.Normalize(Vec3W.MultiplyAdd(surface.Facing, surface.Cosine * 2f, surface.Incoming));
        if (_isMirror)
        {
            scatter.Direction = mirror;
            AmbientResponse(surface, out scatter.Weight);
            return;
        }

        samples.Direction(out FloatW u, out FloatW v);
        Onb.FromNormal(surface.Facing, out Onb frame);
        Vec3W view = frame.ToLocal(-surface.Incoming);
        Look(surface, view.Z, out Side side);
        FloatW choice = samples.Choice();
        MaskW reflects = choice < side.AboveShare;
        MaskW isRest = (choice >= side.AboveShare) & (choice < side.AboveShare + side.RestShare);

        Vec3W bent = new(view.X * _inverse, view.Y * _inverse, side.Inside);
        Vec3W light = Mirrored(bent, MetalFacets.Sample(bent, u, v));
        FloatW sine2 = FloatW.MultiplyAdd(light.X, light.X, light.Y * light.Y) * (_coat.Index * _coat.Index);
        MaskW getsOut = isRest | ((light.Z > 0f) & (sine2 < 1f));
        light = new(light.X * _coat.Index, light.Y * _coat.Index, getsOut.Select(FloatW.Sqrt(FloatW.Max(1f - sine2, 0f)), -1f));
        light = isRest.Select(Warp.CosineHemisphere(u, v), light);
        Vec3W fromCoat = _coat.IsRough ? frame.ToWorld(Mirrored(view, _coat.Facets.Sample(view, u, v))) : mirror;
        scatter.Delta = _coat.IsRough ? MaskW.None : reflects;
        scatter.Direction = Vec3W.Normalize(reflects.Select(fromCoat, frame.ToWorld(light)));

        // Where several have densities, any may choose each direction: what counts is their sum.
        Evaluate(surface, scatter.Direction, out RgbW bsdf, out FloatW pdf);
        FloatW above = side.Above / side.AboveShare;
        scatter.Weight = scatter.Delta.Select(new RgbW(above, above, above), bsdf * (Vec3W.Dot(scatter.Direction, surface.Facing) / pdf));
        scatter.Absorbed = ~(scatter.Delta | ((reflects | getsOut) & (pdf > 0f)));
    }

    private static Vec3W Mirrored(in Vec3W view, in Vec3W normal) => Vec3W.MultiplyAdd(normal, Vec3W.Dot(view, normal) * 2f, -view);

    private void Metal(in SurfaceW surface, in FloatW cosine, out RgbW color)
    {
        _metal.Evaluate(FloatW.Min(FloatW.Max(cosine, 0f), 1f), out color);
        _reflectance.Evaluate(surface, out RgbW factor);
        color *= factor;
    }

    private void Look(in SurfaceW surface, in FloatW cosine, out Side side)
    {
        FloatW into = _coat.Into(cosine, out side.Inside);
        side.Above = Fresnel.Dielectric(FloatW.Min(cosine, 1f), _inverse, out _);
        _bounces.At(cosine, out RgbW factor, out side.Rest);
        _reflectance.Evaluate(surface, out RgbW reflectance);
        side.Rest *= reflectance;
        FloatW way = -1f / side.Inside;
        side.Through = new(
            FloatW.Sqrt(factor.R) * LaneMath.Exp(way * _coat.Absorption.R) * into,
            FloatW.Sqrt(factor.G) * LaneMath.Exp(way * _coat.Absorption.G) * into,
            FloatW.Sqrt(factor.B) * LaneMath.Exp(way * _coat.Absorption.B) * into);
        Metal(surface, side.Inside, out RgbW color);
        side.Mirrored = color * side.Through * side.Through;

        // Each lobe is chosen about as often as it sends on light.
        FloatW metal = side.Mirrored.R + side.Mirrored.G + side.Mirrored.B;
        FloatW rest = side.Rest.R + side.Rest.G + side.Rest.B;
        FloatW scale = 1f / FloatW.Max(metal + rest + side.Above * 3f, 1e-9f);
        side.AboveShare = side.Above * 3f * scale;
        side.RestShare = rest * scale;
        side.MetalShare = metal * scale;
    }

    // What a direction outside goes along with, and how often each lobe is chosen where it is the ray's.
    private struct Side
    {
        public FloatW Inside, Above, AboveShare, MetalShare, RestShare;
        public RgbW Through, Mirrored, Rest;
    }
}
