using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="RoughConductorMaterial"/>.</summary>
[SceneType("roughConductor", "Rough metal: brushed, sand-blasted or hammered, made of tiny mirrors.")]
public sealed record RoughConductorMaterialDescription : MetalDescription
{
    /// <summary>The distribution of the microfacets' normals.</summary>
    [Parameter("How the tiny mirrors are tilted: \"ggx\" has long tails, as most surfaces do; \"beckmann\" is a rough surface of normally "
        + "distributed slopes.")]
    public MicrofacetDistribution Distribution { get; init; }

    /// <summary>Roughness.</summary>
    [Parameter("Roughness: the root mean square of the slopes, or about so. 0.01 is polished, 0.1 to 0.3 satin, 1 very rough.",
        Minimum = 0, Maximum = 10, IsNumber = true)]
    public TextureDescription Alpha { get; init; } = new SolidTextureDescription { Color = new(0.1f, 0.1f, 0.1f) };

    /// <summary>Roughness along u; null for <see cref="Alpha"/>.</summary>
    [Parameter("Roughness in the direction in which u grows, if different.", Minimum = 0, Maximum = 10, IsNumber = true)]
    public TextureDescription? AlphaU { get; init; }

    /// <summary>Roughness across u; null for <see cref="Alpha"/>.</summary>
    [Parameter("Roughness perpendicular to that, if different.", Minimum = 0, Maximum = 10, IsNumber = true)]
    public TextureDescription? AlphaV { get; init; }

    /// <summary>Light that is reflected from one microfacet to another is not lost.</summary>
    [Parameter("Whether light that is reflected more than once among the tiny mirrors is added, about as much as is lost without it: rough "
        + "metal is then as bright as polished metal. It needs one number for alpha.")]
    public bool MultipleScattering { get; init; }

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        Roughness roughness = Roughness.Of(builder, Distribution, Alpha, AlphaU, AlphaV);
        if (MultipleScattering && (roughness.UsesUv || roughness.UsesTangent))
        {
            builder.Error(this, nameof(MultipleScattering), "multiple scattering needs one number for \"alpha\": no texture, and the same in both directions");
        }

        return new RoughConductorMaterial(BuildFresnel(builder), roughness, builder.Texture(SpecularReflectance), MultipleScattering);
    }
}

/// <summary>
/// Microfacets that are mirrors of metal: f = F·D·G₁·G₁/(4·cos·cos) (Torrance &amp; Sparrow 1967, as by Walter et al. 2007, eq. 20). What one
/// microfacet reflects onto another is lost, or made up for by a factor that depends on the ray's angle (Turquin, Practical multiple scattering compensation for
/// microfacet models, 2019, eq. 16).
/// </summary>
/// <param name="fresnel">Their reflectance.</param>
/// <param name="roughness">The width of their tilts.</param>
/// <param name="reflectance">Factor on what is reflected.</param>
/// <param name="multipleScattering">True if what microfacets reflect onto each other is made up for; then the roughness is the same
/// everywhere.</param>
internal sealed class RoughConductorMaterial(ConductorFresnel fresnel, Roughness roughness, Texture reflectance, bool multipleScattering = false) : Material
{
    private readonly RoughLoss? _loss = multipleScattering ? new(roughness) : null;

    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new()
    {
        Specular = SpecularLobe.Glossy,
        ReciprocityException = multipleScattering ? "the compensation depends on the angle of only one of the two directions (Turquin's factor)" : null,
        UsesTangent = roughness.UsesTangent,
        UsesUv = roughness.UsesUv || reflectance.Constant is null,
    };

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
        Compensate(view.Z, ref bsdf);
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
        Compensate(view.Z, ref scatter.Weight);
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.None;
        scatter.Absorbed = Vec3W.Dot(scatter.Direction, surface.Facing) <= 0f;
    }

    private void View(in SurfaceW surface, out Onb frame, out Vec3W view)
    {
        surface.Frame(roughness.UsesTangent, out frame);
        view = frame.ToLocal(-surface.Incoming);
    }

    private void Compensate(FloatW cosine, ref RgbW reflected)
    {
        if (_loss is not null)
        {
            fresnel.Evaluate(1f, out RgbW color);
            reflected *= RgbW.MultiplyAdd(color, _loss.At(cosine), Rgb.White);
        }
    }

    private void Reflectance(in SurfaceW surface, in FloatW cosine, out RgbW color)
    {
        fresnel.Evaluate(FloatW.Min(FloatW.Max(cosine, 0f), 1f), out color);
        reflectance.Evaluate(surface, out RgbW factor);
        color *= factor;
    }
}
