using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="RoughConductorMaterial"/>.</summary>
[SceneType("roughConductor", "Rough metal: brushed, sand-blasted or hammered, made of tiny mirrors.")]
public sealed record RoughConductorMaterialDescription : MetalDescription
{
    /// <summary>How the microfacets' normals are distributed.</summary>
    [Parameter("How the tiny mirrors are tilted: \"ggx\" has long tails, as most surfaces do; \"beckmann\" is a rough surface of normally distributed slopes.")]
    public MicrofacetDistribution Distribution { get; init; }

    /// <summary>Roughness.</summary>
    [Parameter("Roughness: the root mean square of the slopes, or about so. 0.01 is polished, 0.1 to 0.3 satin, 1 very rough.", Minimum = 0, Maximum = 10, IsNumber = true)]
    public TextureDescription Alpha { get; init; } = new SolidTextureDescription { Color = new(0.1f, 0.1f, 0.1f) };

    /// <summary>Roughness along u; null for <see cref="Alpha"/>.</summary>
    [Parameter("Roughness in the direction in which u grows, if another.", Minimum = 0, Maximum = 10, IsNumber = true)]
    public TextureDescription? AlphaU { get; init; }

    /// <summary>Roughness across u; null for <see cref="Alpha"/>.</summary>
    [Parameter("Roughness perpendicular to that, if another.", Minimum = 0, Maximum = 10, IsNumber = true)]
    public TextureDescription? AlphaV { get; init; }

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) => new RoughConductorMaterial(
        BuildFresnel(builder), Roughness.Of(builder, Distribution, Alpha, AlphaU, AlphaV), builder.Texture(SpecularReflectance));
}

/// <summary>
/// Microfacets that are mirrors of metal: f = F·D·G₁·G₁/(4·cos·cos) (Torrance &amp; Sparrow 1967, as by Walter et al. 2007, eq. 20). What one
/// microfacet reflects onto another is lost.
/// </summary>
/// <param name="fresnel">How much they reflect.</param>
/// <param name="roughness">How they are tilted.</param>
/// <param name="reflectance">Factor on what is reflected.</param>
public sealed class RoughConductorMaterial(ConductorFresnel fresnel, Roughness roughness, Texture reflectance) : Material
{
    /// <inheritdoc/>
    public override ScatteringProperties Scattering { get; } = new() { Specular = SpecularLobe.Glossy };

    /// <inheritdoc/>
    public override bool UsesUv => UsesTangent || roughness.UsesUv || reflectance.Constant is null;

    /// <inheritdoc/>
    public override bool UsesTangent => roughness.UsesTangent;

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        fresnel.Evaluate(surface.Cosine, out response);
        reflectance.Evaluate(surface, out RgbW factor);
        response *= factor;
    }

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        View(surface, out Onb frame, out Vec3W view);
        Vec3W light = frame.ToLocal(direction);
        Vec3W normal = Vec3W.Normalize(view + light);
        roughness.Evaluate(surface, out Microfacets microfacets);
        FloatW lobe = microfacets.Reflection(view, light, normal);
        Reflectance(surface, Vec3W.Dot(view, normal), out RgbW color);
        bsdf = (light.Z > 0f).Select(color * lobe, default);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        View(surface, out Onb frame, out Vec3W view);
        Vec3W light = frame.ToLocal(direction);
        roughness.Evaluate(surface, out Microfacets microfacets);
        pdf = (light.Z > 0f).Select(microfacets.ReflectionPdf(view, Vec3W.Normalize(view + light)), 0f);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        View(surface, out Onb frame, out Vec3W view);
        roughness.Evaluate(surface, out Microfacets microfacets);
        Vec3W normal = microfacets.Sample(view, u, v);
        FloatW cosine = Vec3W.Dot(view, normal);
        Vec3W light = Vec3W.MultiplyAdd(normal, cosine * 2f, -view);
        scatter.Direction = Vec3W.Normalize(frame.ToWorld(light));
        Reflectance(surface, cosine, out RgbW color);
        scatter.Weight = color * microfacets.Masking(light, normal);
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.None;
        scatter.Absorbed = Vec3W.Dot(scatter.Direction, surface.Facing) <= 0f;
    }

    private void View(in SurfaceW surface, out Onb frame, out Vec3W view)
    {
        surface.Frame(UsesTangent, out frame);
        view = frame.ToLocal(-surface.Incoming);
    }

    private void Reflectance(in SurfaceW surface, in FloatW cosine, out RgbW color)
    {
        fresnel.Evaluate(FloatW.Min(FloatW.Max(cosine, 0f), 1f), out color);
        reflectance.Evaluate(surface, out RgbW factor);
        color *= factor;
    }
}
