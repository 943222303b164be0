using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Spectra;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="RoughDielectricMaterial"/>.</summary>
[SceneType("roughDielectric", "Frosted glass: a rough boundary of a clear inside. Use it on closed shapes.")]
public sealed record RoughDielectricMaterialDescription : GlassDescription
{
    private const float UsualIndex = 1.5f;

    /// <summary>Refractive index of the inside, relative to the outside.</summary>
    [Parameter("Refractive index of the inside relative to the outside: water 1.333, glass 1.5. Not 1: that would be no boundary.",
        Minimum = 1e-3, Maximum = 100)]
    public float RefractiveIndex { get; init; } = UsualIndex;

    /// <summary>The distribution of the microfacets' normals.</summary>
    [Parameter("How the tiny facets are tilted: \"ggx\" has long tails, as ground glass does; \"beckmann\" is a rough surface of normally "
        + "distributed slopes.")]
    public MicrofacetDistribution Distribution { get; init; }

    /// <summary>Roughness.</summary>
    [Parameter("Roughness: the root mean square of the slopes, or about so. 0.01 is polished, 0.1 to 0.3 frosted, 1 very rough.",
        Minimum = 0, Maximum = 10, IsNumber = true)]
    public TextureDescription Alpha { get; init; } = new SolidTextureDescription { Color = new(0.1f, 0.1f, 0.1f) };

    /// <summary>Roughness along u; null for <see cref="Alpha"/>.</summary>
    [Parameter("Roughness in the direction in which u grows, if different.", Minimum = 0, Maximum = 10, IsNumber = true)]
    public TextureDescription? AlphaU { get; init; }

    /// <summary>Roughness across u; null for <see cref="Alpha"/>.</summary>
    [Parameter("Roughness perpendicular to that, if different.", Minimum = 0, Maximum = 10, IsNumber = true)]
    public TextureDescription? AlphaV { get; init; }

    /// <summary>Factor on all that is reflected.</summary>
    [Parameter("Factor on what is reflected, per channel: 1 for real glass.", Minimum = 0, Maximum = 1)]
    public TextureDescription SpecularReflectance { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>Factor on all that is refracted.</summary>
    [Parameter("Factor on what is refracted, per channel: 1 for real glass.", Minimum = 0, Maximum = 1)]
    public TextureDescription SpecularTransmittance { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        if (RefractiveIndex == 1)
        {
            builder.Error(this, nameof(RefractiveIndex), "the refractive index of a rough boundary must not be 1: nothing would be refracted");
        }

        Dispersion? dispersion = BuildDispersion(builder, nameof(RefractiveIndex), RefractiveIndex != UsualIndex);
        return new RoughDielectricMaterial(
            RefractiveIndex, Roughness.Of(builder, Distribution, Alpha, AlphaU, AlphaV), builder.Texture(SpecularReflectance), builder.Texture(SpecularTransmittance), builder.Medium(Interior), dispersion,
            BuildNesting(RefractiveIndex, dispersion, Rgb.Black));
    }
}

/// <summary>
/// Microfacets that are smooth boundaries between the outside and a clear inside (Walter et al., Microfacet models for refraction through rough
/// surfaces, 2007). What one microfacet sends onto another is lost. Radiance grows by the square of the index on entering the denser
/// medium.
/// </summary>
/// <param name="refractiveIndex">Index of the inside over that of the outside, above 0 and not 1.</param>
/// <param name="roughness">The width of the microfacets' tilts.</param>
/// <param name="reflectance">Factor on what is reflected.</param>
/// <param name="transmittance">Factor on what is refracted.</param>
/// <param name="interior">The medium inside besides; null for none.</param>
/// <param name="dispersion">The dependence of the index on the wavelength, in place of <paramref name="refractiveIndex"/>; null where it does
/// not.</param>
/// <param name="nesting">The priority of the inside over others that overlap it; null for an index relative to what is around.</param>
internal sealed class RoughDielectricMaterial(
    float refractiveIndex, Roughness roughness, Texture reflectance, Texture transmittance, Medium? interior = null, Dispersion? dispersion = null, Nesting? nesting = null) : Material
{
    private const float LeastDifference = 1e-3f;

    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new()
    {
        Specular = SpecularLobe.Glossy,
        Transmits = true,
        Interior = interior,
        Nesting = nesting,
        Disperses = dispersion is not null,
        UsesTangent = roughness.UsesTangent,
        UsesUv = roughness.UsesUv || reflectance.Constant is null || transmittance.Constant is null,
    };

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo) => albedo = Rgb.White;

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Begin(surface, direction, out Pair pair, out Microfacets microfacets);
        FloatW shadowed = microfacets.Density(pair.Normal) * microfacets.Masking(pair.View, pair.Normal) * microfacets.Masking(pair.Light, pair.Normal);
        FloatW reflected = shadowed * pair.Fresnel / (pair.View.Z * pair.Light.Z * 4f);
        FloatW refracted = shadowed * (1f - pair.Fresnel) * FloatW.Abs(pair.ViewCosine * pair.LightCosine / (pair.View.Z * pair.Light.Z)) / (pair.Stretch * pair.Stretch);
        reflectance.Evaluate(surface, out RgbW above);
        transmittance.Evaluate(surface, out RgbW through);
        bsdf = pair.Reflects.Select(above * reflected, pair.Refracts.Select(through * refracted, default));
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Begin(surface, direction, out Pair pair, out Microfacets microfacets);
        FloatW visible = microfacets.VisibleDensity(pair.View, pair.Normal);
        FloatW reflected = visible * pair.Fresnel / (4f * pair.ViewCosine);

        // Walter et al. 2007, eq. 17, with the indices relative to that of the side of the ray.
        FloatW refracted = visible * (1f - pair.Fresnel) * FloatW.Abs(pair.LightCosine) * pair.Eta * pair.Eta / (pair.Stretch * pair.Stretch);
        pdf = pair.Reflects.Select(reflected, pair.Refracts.Select(refracted, 0f));
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        surface.Frame(roughness.UsesTangent, out Onb frame);
        Vec3W view = frame.ToLocal(-surface.Incoming);
        roughness.Evaluate(surface, out Microfacets microfacets);
        Vec3W normal = microfacets.Sample(view, u, v);
        FloatW cosine = Vec3W.Dot(view, normal);
        FloatW inverse = 1f / Index(surface);
        FloatW reflected = Fresnel.Dielectric(FloatW.Min(cosine, 1f), inverse, out FloatW cosTransmitted);
        MaskW reflects = samples.Choice() < reflected;
        Vec3W reflection = Vec3W.MultiplyAdd(normal, cosine * 2f, -view);
        Vec3W refraction = Vec3W.MultiplyAdd(normal, FloatW.MultiplyAdd(inverse, cosine, -cosTransmitted), -view * inverse);
        Vec3W light = reflects.Select(reflection, refraction);
        scatter.Direction = Vec3W.Normalize(frame.ToWorld(light));
        FloatW masking = microfacets.Masking(light, normal);
        reflectance.Evaluate(surface, out RgbW above);
        transmittance.Evaluate(surface, out RgbW through);
        scatter.Weight = reflects.Select(above * masking, through * (masking * inverse * inverse));
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.None;

        // Masking is of the side where the microfacet sends the light.
        FloatW side = Vec3W.Dot(scatter.Direction, surface.Facing);
        FloatW onFacet = Vec3W.Dot(light, normal);
        scatter.Absorbed = reflects.Select(side, -side) <= 0f | side * onFacet <= 0f;
    }

    // Refractive index of the other side over that of the ray's.
    private FloatW Index(in SurfaceW surface)
    {
        if (dispersion is null && nesting is null)
        {
            return surface.Inside.Select(1f / refractiveIndex, refractiveIndex);
        }

        FloatW index = dispersion?.Index(surface.Wavelength) ?? refractiveIndex;
        if (nesting is not null)
        {
            // Between two of the same index there is no half vector: they are taken to differ a little.
            index /= surface.ExteriorIndex;
            index = (FloatW.Abs(index - 1f) < LeastDifference).Select(1f + LeastDifference, index);
        }

        return surface.Inside.Select(1f / index, index);
    }

    private void Begin(in SurfaceW surface, in Vec3W direction, out Pair pair, out Microfacets microfacets)
    {
        surface.Frame(roughness.UsesTangent, out Onb frame);
        pair.View = frame.ToLocal(-surface.Incoming);
        pair.Light = frame.ToLocal(direction);
        pair.Eta = Index(surface);
        pair.Reflects = pair.Light.Z > 0f;
        Vec3W half = Vec3W.MultiplyAdd(pair.Light, pair.Reflects.Select(1f, pair.Eta), pair.View);
        pair.Normal = Vec3W.Normalize(half * FloatW.CopySign(1f, half.Z));
        pair.ViewCosine = Vec3W.Dot(pair.View, pair.Normal);
        pair.LightCosine = Vec3W.Dot(pair.Light, pair.Normal);
        pair.Stretch = FloatW.MultiplyAdd(pair.Eta, pair.LightCosine, pair.ViewCosine);
        pair.Fresnel = Fresnel.Dielectric(FloatW.Min(FloatW.Max(pair.ViewCosine, 0f), 1f), 1f / pair.Eta, out _);
        pair.Refracts = pair.Light.Z < 0f & pair.ViewCosine > 0f & pair.LightCosine < 0f;
        roughness.Evaluate(surface, out microfacets);
    }

    // Two directions and the microfacets that send light from one to the other. Stretch is their half vector before it is made a unit
    // vector, along it.
    private struct Pair
    {
        public Vec3W View, Light, Normal;
        public FloatW Eta, ViewCosine, LightCosine, Stretch, Fresnel;
        public MaskW Reflects, Refracts;
    }
}
