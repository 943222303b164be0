using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="ThinPrincipledMaterial"/>.</summary>
[SceneType("thinPrincipled", "The sheet that goes with principled: paper, leaves, curtains, frosted panes, without an inside in which light would be bent.")]
public sealed record ThinPrincipledMaterialDescription : MaterialDescription
{
    /// <summary>Colour.</summary>
    [Parameter("Colour of what is matt, and of what passes through.", Minimum = 0, Maximum = 1)]
    public TextureDescription BaseColor { get; init; } = PrincipledMaterialDescription.Number(0.5f);

    /// <summary>Roughness: the square root of alpha.</summary>
    [Parameter("Roughness of the surface: its square is the alpha of other materials. What passes through is blurred less, by the refractive index.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Roughness { get; init; } = PrincipledMaterialDescription.Number(0.5f);

    /// <summary>The stretch of highlights along u.</summary>
    [Parameter("How much highlights are stretched in the direction in which u grows: 0 is not at all.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Anisotropic { get; init; } = PrincipledMaterialDescription.Number(0);

    /// <summary>0 is matt, 1 a pane.</summary>
    [Parameter("0 is matt, 1 a pane that reflects and lets through.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Transmission { get; init; } = PrincipledMaterialDescription.Number(0);

    /// <summary>The part of what is matt that comes out on the other side.</summary>
    [Parameter("The part of the matt light that comes out on the other side: 0 is none, 1 all.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription DiffuseTransmission { get; init; } = PrincipledMaterialDescription.Number(0);

    /// <summary>Refractive index of the sheet.</summary>
    [Parameter("Refractive index of the sheet relative to what is around it.", Minimum = 1.001, Maximum = 10, IsNumber = true)]
    public TextureDescription RefractiveIndex { get; init; } = PrincipledMaterialDescription.Number(1.5f);

    /// <summary>The share of the highlight that has the colour of the base.</summary>
    [Parameter("How much the highlights have the colour of the base.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription SpecularTint { get; init; } = PrincipledMaterialDescription.Number(0);

    /// <summary>Light at grazing angles, as of cloth.</summary>
    [Parameter("Light at grazing angles, as on fuzzy cloth.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Sheen { get; init; } = PrincipledMaterialDescription.Number(0);

    /// <summary>The share of the sheen that has the colour of the base.</summary>
    [Parameter("How much the sheen has the colour of the base.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription SheenTint { get; init; } = PrincipledMaterialDescription.Number(0);

    /// <summary>0 is matt, 1 as if light went around below the surface.</summary>
    [Parameter("How much the matt part looks as if light scattered below the surface, as in skin and wax.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Flatness { get; init; } = PrincipledMaterialDescription.Number(0);

    /// <summary>The medium inside.</summary>
    [Parameter("What fills the inside of the (closed) shape. Shown by path, volPath and the integrators that trace light.")]
    public MediumDescription Interior { get; init; } = new();

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) => new ThinPrincipledMaterial(
        new()
        {
            BaseColor = builder.Texture(BaseColor),
            Roughness = builder.NumberTexture(Roughness),
            Anisotropic = builder.NumberTexture(Anisotropic),
            SpecularTint = builder.NumberTexture(SpecularTint),
            Transmission = builder.NumberTexture(Transmission),
            Sheen = builder.NumberTexture(Sheen),
            SheenTint = builder.NumberTexture(SheenTint),
            Flatness = builder.NumberTexture(Flatness),
            RefractiveIndex = builder.NumberTexture(RefractiveIndex),
            DiffuseTransmission = builder.NumberTexture(DiffuseTransmission),
        },
        builder.Medium(Interior));
}

/// <summary>
/// Burley's model of thin sheets (Extending the Disney BRDF to a BSDF with integrated subsurface scattering, 2015, section 5.3): the matt base of <see cref="PrincipledMaterial"/>,
/// of which a part comes out on the other side, and rough reflection with what it leaves going straight through, blurred. Both sides are alike.
/// </summary>
/// <param name="textures">The parameters.</param>
/// <param name="interior">The medium inside; null for none.</param>
internal sealed class ThinPrincipledMaterial(PrincipledTextures textures, Medium? interior = null) : Material
{
    private const float SmallestIndex = 1.001f;
    private readonly bool _isAnisotropic = !PrincipledTextures.IsZero(textures.Anisotropic);

    /// <inheritdoc/>
    public override MaterialTraits Traits => new()
    {
        Specular = SpecularLobe.Glossy,
        EnergyException = "retro-reflection and sheen are added regardless of what the base leaves (Burley's model)",
        MostEnergy = 1.7f,
        Transmits = !PrincipledTextures.IsZero(textures.Transmission) || !PrincipledTextures.IsZero(textures.DiffuseTransmission),
        Interior = interior,
        UsesTangent = _isAnisotropic,
        UsesUv = textures.UsesUv,
    };

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => textures.BaseColor.Evaluate(surface, out surface.DiffuseColor);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response) => response = surface.DiffuseColor;

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) => Evaluate(surface, direction, out bsdf, out _);

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Begin(surface, out Values at);
        bsdf = Matt(at, at.Base.Frame.ToLocal(direction));
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf) => Evaluate(surface, direction, out _, out pdf);

    /// <inheritdoc/>
    public override void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        Begin(surface, out Values at);
        Evaluate(at, at.Base.Frame.ToLocal(direction), out bsdf, out pdf);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        Begin(surface, out Values at);
        Vec3W view = at.Base.View;
        FloatW choice = samples.Choice();
        MaskW isBelow = choice < at.ThroughShare + at.BelowShare;
        MaskW isThrough = choice < at.ThroughShare;
        MaskW isRough = isThrough | (choice >= 1f - at.ReflectedShare);
        Vec3W normal = isThrough.Select(at.Through.Sample(view, u, v), at.Base.Main.Sample(view, u, v));
        Vec3W light = isRough.Select(Vec3W.MultiplyAdd(normal, Vec3W.Dot(view, normal) * 2f, -view), Warp.CosineHemisphere(u, v));
        MaskW isCut = isRough & (light.Z <= 0f);
        light = isBelow.Select(new Vec3W(light.X, light.Y, -light.Z), light);
        scatter.Direction = Vec3W.Normalize(at.Base.Frame.ToWorld(light));
        light = at.Base.Frame.ToLocal(scatter.Direction);

        // Two lobes may choose each direction: what counts is their sum. A path that its lobe sends to the wrong side ends.
        Evaluate(at, light, out RgbW bsdf, out FloatW pdf);
        scatter.Weight = bsdf * (FloatW.Abs(light.Z) / pdf);
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.None;
        scatter.Absorbed = ~(pdf > 0f) | isCut | isBelow.Select(light.Z >= 0f, light.Z <= 0f);
    }

    private void Begin(in SurfaceW surface, out Values at)
    {
        at = default;
        ref PrincipledMaterial.Values common = ref at.Base;
        surface.Frame(_isAnisotropic, out common.Frame);
        common.View = common.Frame.ToLocal(-surface.Incoming);
        common.Base = surface.DiffuseColor;
        common.Roughness = PrincipledMaterial.Red(textures.Roughness, surface);
        common.SpecularTint = PrincipledMaterial.Red(textures.SpecularTint, surface);
        common.SheenTint = PrincipledMaterial.Red(textures.SheenTint, surface);
        common.Flatness = PrincipledMaterial.Red(textures.Flatness, surface);
        common.Glass = PrincipledMaterial.Red(textures.Transmission, surface);
        common.Index = FloatW.Max(PrincipledMaterial.Red(textures.RefractiveIndex, surface), SmallestIndex);
        PrincipledMaterial.TintOf(common.Base, out common.Tint);
        FloatW below = PrincipledMaterial.Red(textures.DiffuseTransmission, surface);
        common.Matt = (1f - common.Glass) * (1f - below);
        common.Sheen = PrincipledMaterial.Red(textures.Sheen, surface) * common.Matt;

        // What passes through is blurred by as much less as the index is small (Burley 2015, figure 15).
        FloatW aspect = _isAnisotropic ? FloatW.Sqrt(FloatW.MultiplyAdd(PrincipledMaterial.Red(textures.Anisotropic, surface), -0.9f, 1f)) : 1f;
        common.Main = Facets(common.Roughness, aspect);
        at.Through = Facets(FloatW.MultiplyAdd(common.Index, 0.65f, -0.35f) * common.Roughness, aspect);

        // Of the pane, reflection is chosen about as often as it sends on light; the rest by the parts of the light.
        FloatW head = Fresnel.Dielectric(FloatW.Min(common.View.Z, 1f), 1f / common.Index, out _);
        at.ReflectedShare = common.Glass * FloatW.Max(0.1f, FloatW.Min(head, 0.9f));
        at.ThroughShare = common.Glass - at.ReflectedShare;
        at.BelowShare = (1f - common.Glass) * below;
    }

    private static Microfacets Facets(FloatW roughness, FloatW aspect)
    {
        FloatW alpha = roughness * roughness;
        return new(MicrofacetDistribution.Ggx, FloatW.Max(alpha / aspect, PrincipledMaterial.SmallestAlpha), FloatW.Max(alpha * aspect, PrincipledMaterial.SmallestAlpha));
    }

    private static RgbW Matt(in Values at, in Vec3W light)
    {
        FloatW cosine = Vec3W.Dot(light, Vec3W.Normalize(light + at.Base.View));
        return (light.Z > 0f).Select(PrincipledMaterial.MattAndSheen(at.Base, light.Z, cosine), at.Base.Base * (at.BelowShare * (1f / float.Pi)));
    }

    private static void Evaluate(in Values at, in Vec3W light, out RgbW bsdf, out FloatW pdf)
    {
        // What passes through is as what would be reflected, on the other side.
        Vec3W view = at.Base.View;
        MaskW isAbove = light.Z > 0f;
        Vec3W above = new(light.X, light.Y, FloatW.Abs(light.Z));
        Vec3W normal = Vec3W.Normalize(view + above);
        FloatW cosine = Vec3W.Dot(view, normal);
        FloatW fresnel = Fresnel.Dielectric(FloatW.Min(FloatW.Max(cosine, 0f), 1f), 1f / at.Base.Index, out _);
        RgbW through = at.Base.Base * ((1f - fresnel) * at.Through.Reflection(view, above, normal));

        // As in Mitsuba, microfacets that face away from the light which passes let none of it through. From the other side others do so: particles go there, too.
        through = (Vec3W.Dot(light, normal) < 0f).Select(through, default);
        RgbW rough = isAbove.Select(Reflectance(at, cosine, fresnel) * at.Base.Main.Reflection(view, above, normal), through);
        bsdf = RgbW.MultiplyAdd(rough, at.Base.Glass, Matt(at, light));

        FloatW pdfThrough = at.ThroughShare * at.Through.ReflectionPdf(view, normal);
        FloatW pdfRough = isAbove.Select(at.ReflectedShare * at.Base.Main.ReflectionPdf(view, normal), pdfThrough);
        FloatW mattShare = isAbove.Select(1f - at.Base.Glass - at.BelowShare, at.BelowShare);
        pdf = FloatW.MultiplyAdd(mattShare, Warp.CosineHemispherePdf(above.Z), pdfRough);
    }

    // Tint by Schlick's approximation, the rest by Fresnel's equations.
    private static RgbW Reflectance(in Values at, FloatW cosine, FloatW fresnel)
    {
        FloatW head = (at.Base.Index - 1f) / (at.Base.Index + 1f);
        RgbW tinted = PrincipledMaterial.Lerp(at.Base.Tint * (head * head), Rgb.White, PrincipledMaterial.Grazing(cosine));
        return PrincipledMaterial.Lerp(new(fresnel, fresnel, fresnel), tinted, at.Base.SpecularTint);
    }

    // The parameters where a path meets the sheet, and how often each lobe is chosen; what is left is chosen by the matt reflection.
    private struct Values
    {
        public PrincipledMaterial.Values Base;
        public Microfacets Through;
        public FloatW ReflectedShare, ThroughShare, BelowShare;
    }
}
