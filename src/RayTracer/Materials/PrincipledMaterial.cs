using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="PrincipledMaterial"/>.</summary>
[SceneType("principled", "One material for nearly everything, with parameters from 0 to 1 as artists know them: plastic, metal, glass, car "
    + "paint, cloth.")]
public sealed record PrincipledMaterialDescription : MaterialDescription
{
    /// <summary>Colour.</summary>
    [Parameter("Colour of the matt base, of metal, and of what passes through.", Minimum = 0, Maximum = 1)]
    public TextureDescription BaseColor { get; init; } = Number(0.5f);

    /// <summary>0 is a dielectric, 1 a metal.</summary>
    [Parameter("0 is plastic, wood, stone or glass; 1 is metal.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Metallic { get; init; } = Number(0);

    /// <summary>Roughness: the square root of alpha.</summary>
    [Parameter("Roughness of the surface: its square is the alpha of other materials.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Roughness { get; init; } = Number(0.5f);

    /// <summary>The stretch of highlights along u.</summary>
    [Parameter("How much highlights are stretched in the direction in which u grows: 0 is not at all.",
        Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Anisotropic { get; init; } = Number(0);

    /// <summary>Reflectance head-on in units of 8 %; null where <see cref="RefractiveIndex"/> gives it.</summary>
    [Parameter("Reflectance when seen head-on, in units of 8 %: 0.5 is 4 %, as for glass and plastic. It replaces refractiveIndex.",
        Minimum = 0, Maximum = 1)]
    public float? Specular { get; init; }

    /// <summary>Refractive index of the inside; null for 1.5, or by <see cref="Specular"/>.</summary>
    [Parameter("Refractive index of the inside relative to the outside, instead of specular. Without either, it is 1.5.",
        Minimum = 1.001, Maximum = 10)]
    public float? RefractiveIndex { get; init; }

    /// <summary>The share of a dielectric's highlight that has the colour of the base.</summary>
    [Parameter("How much the highlights have the colour of the base.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription SpecularTint { get; init; } = Number(0);

    /// <summary>0 is opaque, 1 is glass.</summary>
    [Parameter("0 is opaque, 1 is glass. Use glass on closed shapes.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Transmission { get; init; } = Number(0);

    /// <summary>Light at grazing angles, as of cloth.</summary>
    [Parameter("Light at grazing angles, as on fuzzy cloth.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Sheen { get; init; } = Number(0);

    /// <summary>The share of the sheen that has the colour of the base.</summary>
    [Parameter("How much the sheen has the colour of the base.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription SheenTint { get; init; } = Number(0);

    /// <summary>A second, clear coat on top.</summary>
    [Parameter("A second, clear coat on top, as on car paint.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Clearcoat { get; init; } = Number(0);

    /// <summary>Roughness of the coat.</summary>
    [Parameter("Roughness of the clear coat: 0 is polished, 1 is satin.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription ClearcoatRoughness { get; init; } = Number(0);

    /// <summary>How much of the surface has a thin film.</summary>
    [Parameter("How much the surface shimmers in the colours of a thin film, as soap bubbles, oil on water and tempered steel do.", Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Iridescence { get; init; } = Number(0);

    /// <summary>Thickness of the film.</summary>
    [Parameter("Only with iridescence: thickness of the film.", Unit = "nm", Minimum = 0, Maximum = 1e5, IsNumber = true)]
    public TextureDescription FilmThickness { get; init; } = Number(400);

    /// <summary>Refractive index of the film.</summary>
    [Parameter("Only with iridescence: refractive index of the film relative to the outside.", Minimum = 1, Maximum = 10)]
    public float FilmIndex { get; init; } = 1.3f;

    /// <summary>0 is matt, 1 as if light went around below the surface.</summary>
    [Parameter("How much the matt base looks as if light scattered below the surface, as in skin and wax.",
        Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Flatness { get; init; } = Number(0);

    /// <summary>The medium inside.</summary>
    [Parameter("What fills the inside of the (closed) shape, where transmission lets light in. Shown by path, volPath and the integrators that trace light.")]
    public MediumDescription Interior { get; init; } = new();

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        if (Specular is not null && RefractiveIndex is not null)
        {
            builder.Error(this, nameof(Specular), "a principled material has either \"specular\" or \"refractiveIndex\", not both");
        }

        return new PrincipledMaterial(
            new()
            {
                BaseColor = builder.Texture(BaseColor),
                Metallic = builder.NumberTexture(Metallic),
                Roughness = builder.NumberTexture(Roughness),
                Anisotropic = builder.NumberTexture(Anisotropic),
                SpecularTint = builder.NumberTexture(SpecularTint),
                Transmission = builder.NumberTexture(Transmission),
                Sheen = builder.NumberTexture(Sheen),
                SheenTint = builder.NumberTexture(SheenTint),
                Clearcoat = builder.NumberTexture(Clearcoat),
                ClearcoatRoughness = builder.NumberTexture(ClearcoatRoughness),
                Flatness = builder.NumberTexture(Flatness),
                Iridescence = builder.NumberTexture(Iridescence),
                FilmThickness = builder.NumberTexture(FilmThickness),
            },
            Specular is { } specular ? IndexOf(specular) : RefractiveIndex ?? 1.5f, builder.Medium(Interior), FilmIndex);
    }

    // Of 8 % · specular = ((n − 1)/(n + 1))².
    private static float IndexOf(float specular) => Math.Max((2 / (1 - float.Sqrt(0.08f * specular))) - 1, 1.001f);

    internal static SolidTextureDescription Number(float value) => new() { Color = new(value, value, value) };
}

/// <summary>
/// Burley's model (Physically-based shading at Disney, 2012; transmission and flatness as in Extending the Disney BRDF to a BSDF with integrated
/// subsurface scattering, 2015): a matt base with retro-reflection and sheen, a rough lobe that is metal, tinted or plain, or the rough boundary of glass, and a coat. Where
/// nothing is let through, both sides of the surface look alike.
/// </summary>
/// <param name="textures">The parameters.</param>
/// <param name="refractiveIndex">Index of the inside over that of the outside, above 1.</param>
/// <param name="interior">The medium inside; null for none.</param>
/// <param name="filmIndex">Index of a film over that of the outside.</param>
internal sealed class PrincipledMaterial(PrincipledTextures textures, float refractiveIndex, Medium? interior = null, float filmIndex = 1.3f) : Material
{
    internal const float SmallestAlpha = 1e-3f;

    // The coat has an index of 1.5, a quarter of the strength of the main lobe, and separate masking.
    private const float CoatReflectance = 0.04f;
    private const float CoatStrength = 0.25f;
    private const float CoatMasking = 0.25f;

    private readonly ThinFilm? _film = PrincipledTextures.IsZero(textures.Iridescence) ? null : new(filmIndex);
    private readonly bool _transmits = !PrincipledTextures.IsZero(textures.Transmission);
    private readonly bool _isAnisotropic = !PrincipledTextures.IsZero(textures.Anisotropic);

    /// <inheritdoc/>
    public override MaterialTraits Traits => new()
    {
        Specular = SpecularLobe.Glossy,
        EnergyException = "base, highlight and sheen are added regardless of what the others leave (Burley's model)",

        // Computed by quadrature for a white base, seen at a cosine of 0.001 with a roughness of 1, where each is largest: of the base 1.56 (its
        // retro-reflection), with the highlight 1.61 at an index of 1.5 and 1.96 at one of 10, and 0.09 of the sheen. The coat adds at most
        // 0.04.
        MostEnergy = 2.1f,
        Transmits = _transmits,
        Interior = interior,
        UsesTangent = _isAnisotropic,
        UsesUv = textures.UsesUv,
    };

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => textures.BaseColor.Evaluate(surface, out surface.DiffuseColor);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response) => response = surface.DiffuseColor;

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Begin(surface, out Values at);
        Evaluate(at, at.Frame.ToLocal(direction), out bsdf, out _);
    }

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Begin(surface, out Values at);
        Vec3W light = at.Frame.ToLocal(direction);
        FloatW lightCosine = Vec3W.Dot(light, Vec3W.Normalize(light + at.View));
        RgbW matt = MattAndSheen(at, light.Z, lightCosine);
        matt *= _film is null ? 1f : BelowFilm(at, Shimmer(at.HeadOn, at.FilmThickness, lightCosine));
        bsdf = (light.Z > 0f).Select(matt, default);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Begin(surface, out Values at);
        Evaluate(at, at.Frame.ToLocal(direction), out _, out pdf);
    }

    /// <inheritdoc/>
    public override void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        Begin(surface, out Values at);
        Evaluate(at, at.Frame.ToLocal(direction), out bsdf, out pdf);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        Begin(surface, out Values at);
        FloatW choice = samples.Choice();
        MaskW isMain = choice < at.MainShare;
        MaskW isCoat = (choice < at.MainShare + at.CoatShare).Except(isMain);

        Vec3W normal = at.Main.Sample(at.View, u, v);
        FloatW cosine = Vec3W.Dot(at.View, normal);
        FloatW fresnel = Fresnel.Dielectric(FloatW.Min(FloatW.Max(cosine, 0f), 1f), 1f / at.Index, out FloatW cosTransmitted);
        FloatW split = _film is null ? fresnel : Split(at.Film, fresnel, Shimmer(at.HeadOn, at.FilmThickness, at.IsFront.Select(cosine, cosTransmitted)));
        MaskW refracts = isMain & (choice >= at.MainShare * ReflectedShare(at, split));
        normal = isCoat.Select(CoatNormal(at, u, v), normal);
        Vec3W light = Vec3W.MultiplyAdd(normal, Vec3W.Dot(at.View, normal) * 2f, -at.View);
        light = (isMain | isCoat).Select(light, Warp.CosineHemisphere(u, v));
        if (refracts.Any)
        {
            FloatW inverse = 1f / at.Index;
            light = refracts.Select(Vec3W.MultiplyAdd(normal, FloatW.MultiplyAdd(inverse, cosine, -cosTransmitted), -at.View * inverse), light);
        }

        scatter.Direction = Vec3W.Normalize(at.Frame.ToWorld(light));
        light = at.Frame.ToLocal(scatter.Direction);

        // Several lobes may choose each direction: what counts is their sum. A path that its lobe sends to the wrong side ends.
        Evaluate(at, light, out RgbW bsdf, out FloatW pdf);
        scatter.Weight = bsdf * (FloatW.Abs(light.Z) / pdf);
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.None;
        scatter.Absorbed = ~(pdf > 0f) | refracts.Select(light.Z >= 0f, light.Z <= 0f);
    }

    // (1 − cos)⁵, Schlick's weight.
    internal static FloatW Grazing(FloatW cosine)
    {
        FloatW x = FloatW.Max(0f, FloatW.Min(1f - cosine, 1f));
        FloatW x2 = x * x;
        return x2 * x2 * x;
    }

    internal static FloatW Red(Texture texture, in SurfaceW surface)
    {
        texture.Evaluate(surface, out RgbW color);
        return color.R;
    }

    internal static RgbW Lerp(RgbW a, RgbW b, FloatW t) => a * (1f - t) + b * t;

    // A colour at a luminance of 1. Returns its luminance.
    internal static FloatW TintOf(in RgbW color, out RgbW tint)
    {
        FloatW luminance = FloatW.MultiplyAdd(color.R, 0.212671f, FloatW.MultiplyAdd(color.G, 0.715160f, color.B * 0.072169f));
        tint = (luminance > 0f).Select(color * (1f / luminance), Rgb.White);
        return luminance;
    }

    private void Begin(in SurfaceW surface, out Values at)
    {
        surface.Frame(_isAnisotropic, out at.Frame);
        at.View = at.Frame.ToLocal(-surface.Incoming);
        at.Base = surface.DiffuseColor;
        at.Metallic = Red(textures.Metallic, surface);
        at.Roughness = Red(textures.Roughness, surface);
        at.SpecularTint = Red(textures.SpecularTint, surface);
        at.Sheen = Red(textures.Sheen, surface);
        at.SheenTint = Red(textures.SheenTint, surface);
        at.Flatness = Red(textures.Flatness, surface);
        at.Film = _film is null ? 0f : Red(textures.Iridescence, surface);
        at.FilmThickness = _film is null ? 0f : FloatW.Max(Red(textures.FilmThickness, surface), 0f);
        FloatW clearcoat = Red(textures.Clearcoat, surface);
        at.CoatAlpha = FloatW.MultiplyAdd(Red(textures.ClearcoatRoughness, surface), 0.099f, 0.001f);
        FloatW transmission = Red(textures.Transmission, surface);
        at.IsFront = _transmits ? ~surface.Inside : MaskW.All;
        at.Index = at.IsFront.Select(refractiveIndex, 1f / refractiveIndex);

        // Of what is no metal, one part is matt and the other glass. Inside, there is only glass.
        FloatW glass = (1f - at.Metallic) * transmission;
        at.Glass = glass;
        at.Matt = at.IsFront.Select((1f - at.Metallic) * (1f - transmission), 0f);
        at.Sheen = at.IsFront.Select(at.Sheen * (1f - at.Metallic), 0f);
        at.Coat = at.IsFront.Select(clearcoat * CoatStrength, 0f);
        FloatW luminance = TintOf(at.Base, out at.Tint);

        FloatW alpha = at.Roughness * at.Roughness;
        FloatW aspect = _isAnisotropic ? FloatW.Sqrt(FloatW.MultiplyAdd(Red(textures.Anisotropic, surface), -0.9f, 1f)) : 1f;
        at.Main = new(MicrofacetDistribution.Ggx, FloatW.Max(alpha / aspect, SmallestAlpha), FloatW.Max(alpha * aspect, SmallestAlpha));

        // Each lobe is chosen about as often as it sends on light.
        FloatW head = Fresnel.Dielectric(FloatW.Min(at.View.Z, 1f), 1f / at.Index, out FloatW cosTransmitted);
        at.HeadOn = default;
        if (_film is not null)
        {
            // Of a metal, or a dielectric that is tinted or not, the film sees what it would reflect head-on.
            float jump = (refractiveIndex - 1) / (refractiveIndex + 1);
            at.HeadOn = Lerp(Lerp(Rgb.White, at.Tint, at.SpecularTint) * (jump * jump), at.Base, at.Metallic);
            head = Split(at.Film, head, Shimmer(at.HeadOn, at.FilmThickness, at.IsFront.Select(at.View.Z, cosTransmitted)));
        }

        FloatW main = FloatW.Max(FloatW.MultiplyAdd(at.Metallic, luminance, (1f - at.Metallic) * head) + glass * (1f - head), 0.05f);
        FloatW coat = at.Coat * FloatW.MultiplyAdd(Grazing(at.View.Z), 1f - CoatReflectance, CoatReflectance);
        FloatW matt = at.Matt * luminance + at.Sheen * Grazing(at.View.Z);
        FloatW scale = at.IsFront.Select(1f / (main + coat + matt), 1f / main);
        at.MainShare = at.IsFront.Select(main * scale, 1f);
        at.CoatShare = coat * scale;
        at.MattShare = matt * scale;
    }

    // Of the paths of the main lobe, those that are reflected at a microfacet.
    private static FloatW ReflectedShare(in Values at, FloatW fresnel)
    {
        FloatW reflected = at.IsFront.Select(FloatW.MultiplyAdd(1f - at.Metallic, fresnel, at.Metallic), at.Glass * fresnel);
        FloatW all = FloatW.MultiplyAdd(at.Glass, 1f - fresnel, reflected);
        return (all > 0f).Select(reflected / all, 1f);
    }

    // Burley 2012, appendix B: the distribution of Trowbridge and Reitz with exponent 1.
    private static Vec3W CoatNormal(in Values at, FloatW u, FloatW v)
    {
        FloatW alpha2 = at.CoatAlpha * at.CoatAlpha;
        FloatW cos2 = (1f - LaneMath.Exp((1f - u) * LaneMath.Log(alpha2))) / (1f - alpha2);
        FloatW sin = FloatW.Sqrt(FloatW.Max(1f - cos2, 0f));
        LaneMath.SinCosTurn(v, out FloatW y, out FloatW x);
        return new(sin * x, sin * y, FloatW.Sqrt(FloatW.Max(cos2, 0f)));
    }

    private static FloatW CoatDensity(in Values at, in Vec3W normal)
    {
        FloatW alpha2 = at.CoatAlpha * at.CoatAlpha;
        FloatW root = FloatW.MultiplyAdd(normal.Z * normal.Z, alpha2, FloatW.MultiplyAdd(normal.X, normal.X, normal.Y * normal.Y));
        return (alpha2 - 1f) / (LaneMath.Log(alpha2) * root * float.Pi);
    }

    private void Evaluate(in Values at, in Vec3W light, out RgbW bsdf, out FloatW pdf)
    {
        MaskW isAbove = light.Z > 0f;
        Vec3W half = Vec3W.MultiplyAdd(light, isAbove.Select(1f, at.Index), at.View);
        Vec3W normal = Vec3W.Normalize(half * FloatW.CopySign(1f, half.Z));
        FloatW viewCosine = Vec3W.Dot(at.View, normal);
        FloatW lightCosine = Vec3W.Dot(light, normal);
        FloatW fresnel = Fresnel.Dielectric(FloatW.Min(FloatW.Max(viewCosine, 0f), 1f), 1f / at.Index, out FloatW cosTransmitted);
        FloatW masking = at.Main.Masking(at.View, normal);
        FloatW visible = at.Main.Density(normal) * masking;
        FloatW shadowed = visible * at.Main.Masking(light, normal);
        RgbW reflected = MainReflectance(at, viewCosine, fresnel);
        FloatW passed = 1f - fresnel;
        RgbW below = Rgb.White;
        FloatW matt = 1f;
        FloatW split = fresnel;
        if (_film is not null)
        {
            // From the inside as from the outside, so that light and eye can be exchanged.
            RgbW shimmer = Shimmer(at.HeadOn, at.FilmThickness, at.IsFront.Select(viewCosine, cosTransmitted));
            below = Lerp(below * passed, new(1f - shimmer.R, 1f - shimmer.G, 1f - shimmer.B), at.Film);
            (passed, matt, split) = (1f, BelowFilm(at, shimmer), Split(at.Film, fresnel, shimmer));
            reflected = Lerp(reflected, at.IsFront.Select(shimmer, shimmer * at.Glass), at.Film);
        }

        FloatW reflectedShare = ReflectedShare(at, split) * at.MainShare;
        RgbW above = reflected * (shadowed / (at.View.Z * light.Z * 4f));
        FloatW pdfAbove = visible * reflectedShare / (at.View.Z * 4f);
        if ((at.Coat > 0f).Any)
        {
            Microfacets wide = new(MicrofacetDistribution.Ggx, CoatMasking, CoatMasking);
            FloatW reflectance = FloatW.MultiplyAdd(Grazing(viewCosine), 1f - CoatReflectance, CoatReflectance);
            FloatW density = CoatDensity(at, normal);
            FloatW coat = at.Coat * reflectance * density * wide.Masking(at.View, normal) * wide.Masking(light, normal);
            above += new RgbW(coat, coat, coat);
            pdfAbove = FloatW.MultiplyAdd(at.CoatShare * density, normal.Z / (4f * viewCosine), pdfAbove);
        }

        above += MattAndSheen(at, light.Z, lightCosine) * matt;
        pdfAbove = FloatW.MultiplyAdd(at.MattShare, Warp.CosineHemispherePdf(light.Z), pdfAbove);
        bsdf = isAbove.Select(above, default);
        pdf = isAbove.Select(pdfAbove, 0f);
        if (!_transmits)
        {
            return;
        }

        // As in Walter et al. 2007, eqs. 17 and 21; the colour counts at each boundary, so its root is taken.
        FloatW stretch = FloatW.MultiplyAdd(at.Index, lightCosine, viewCosine);
        FloatW through = shadowed * at.Glass * passed * FloatW.Abs(viewCosine * lightCosine / (at.View.Z * light.Z)) / (stretch * stretch);
        MaskW refracts = light.Z < 0f & viewCosine > 0f & lightCosine < 0f;
        RgbW root = new(FloatW.Sqrt(at.Base.R), FloatW.Sqrt(at.Base.G), FloatW.Sqrt(at.Base.B));
        FloatW pdfThrough = visible * (at.MainShare - reflectedShare) * FloatW.Abs(viewCosine * lightCosine) * at.Index * at.Index / (at.View.Z * stretch * stretch);
        bsdf = refracts.Select(root * below * through, bsdf);
        pdf = refracts.Select(pdfThrough, pdf);
    }

    // What the boundary reflects below the film, by the cosine of the angle outside.
    private RgbW Shimmer(in RgbW headOn, FloatW thickness, FloatW cosine) => _film!.Reflectance(FloatW.Max(0f, FloatW.Min(cosine, 1f)), headOn, thickness);

    // The part of the light that is reflected, as a mean over the channels, by which lobes are chosen.
    private static FloatW Split(FloatW film, FloatW fresnel, in RgbW shimmer) =>
        FloatW.MultiplyAdd(film, ((shimmer.R + shimmer.G + shimmer.B) * (1f / 3)) - fresnel, fresnel);

    // What a film leaves of the light of the base: as in the glTF extension, by its brightest channel.
    private static FloatW BelowFilm(in Values at, in RgbW shimmer) => FloatW.NegatedMultiplyAdd(at.Film, FloatW.Max(shimmer.R, FloatW.Max(shimmer.G, shimmer.B)), 1f);

    // Metal and tint by Schlick's approximation, the rest by Fresnel's equations.
    private RgbW MainReflectance(in Values at, FloatW cosine, FloatW fresnel)
    {
        float head = (refractiveIndex - 1) / (refractiveIndex + 1);
        FloatW grazing = Grazing(cosine);
        RgbW metal = Lerp(at.Base, Rgb.White, grazing) * at.Metallic;
        RgbW tinted = Lerp(at.Tint * (head * head), Rgb.White, grazing) * (at.SpecularTint * (1f - at.Metallic));
        FloatW plain = (1f - at.Metallic) * (1f - at.SpecularTint) * fresnel;
        FloatW inside = at.Glass * fresnel;
        return at.IsFront.Select(metal + tinted + new RgbW(plain, plain, plain), new RgbW(inside, inside, inside));
    }

    // Burley 2012, section 5.3, the retro-reflection apart (2015, eq. 4), and the sheen of section 5.6.
    internal static RgbW MattAndSheen(in Values at, FloatW cosLight, FloatW cosHalf)
    {
        FloatW grazingLight = Grazing(cosLight);
        FloatW grazingView = Grazing(at.View.Z);
        FloatW matt = FloatW.MultiplyAdd(grazingView, -0.5f, 1f) * FloatW.MultiplyAdd(grazingLight, -0.5f, 1f);
        FloatW retro = 2f * at.Roughness * cosHalf * cosHalf;
        matt = FloatW.MultiplyAdd(retro, grazingLight + grazingView + grazingLight * grazingView * (retro - 1f), matt);

        // After Hanrahan and Krueger's model of light below the surface (Burley 2012, section 5.3).
        FloatW below = retro * 0.5f - 1f;
        FloatW flat = FloatW.MultiplyAdd(below, grazingLight, 1f) * FloatW.MultiplyAdd(below, grazingView, 1f);
        flat = 1.25f * FloatW.MultiplyAdd(flat, 1f / (cosLight + at.View.Z) - 0.5f, 0.5f);
        matt = FloatW.MultiplyAdd(at.Flatness, flat - matt, matt) * at.Matt * (1f / float.Pi);
        RgbW sheen = Lerp(Rgb.White, at.Tint, at.SheenTint) * (at.Sheen * Grazing(FloatW.Abs(cosHalf)));
        return RgbW.MultiplyAdd(at.Base, matt, sheen);
    }

    // The parameters where a path meets the surface, and how often each lobe is chosen.
    internal struct Values
    {
        public Onb Frame;
        public Vec3W View;
        public RgbW Base, Tint, HeadOn;
        public FloatW Metallic, Roughness, SpecularTint, Sheen, SheenTint, Flatness, Film, FilmThickness, Coat, CoatAlpha, Matt, Glass, Index, MainShare, CoatShare, MattShare;
        public MaskW IsFront;
        public Microfacets Main;
    }
}
