using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Spectra;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>The formulas of a dielectric's reflectance.</summary>
public enum FresnelModel
{
    /// <summary>Fresnel's equations for unpolarised light.</summary>
    Exact,

    /// <summary>Schlick's approximation, as in the report.</summary>
    Schlick,
}

/// <summary>Describes a <see cref="DielectricMaterial"/>.</summary>
[SceneType("dielectric", "Clear glass, water or gems: reflects or refracts, and may tint the light on its way through. Use it on closed "
    + "shapes.")]
public sealed record DielectricMaterialDescription : GlassDescription
{
    private const float UsualIndex = 1.5f;

    /// <summary>Refractive index of the inside, relative to the outside.</summary>
    [Parameter("Refractive index of the inside relative to the outside: water 1.333, glass 1.5, diamond 2.417 (the report's table 4.1).",
        Minimum = 1e-3, Maximum = 100)]
    public float RefractiveIndex { get; init; } = UsualIndex;

    /// <summary>Extinction coefficient of the inside.</summary>
    [Parameter("How fast the inside absorbs light, per channel: after a distance d, the fraction e^(−extinction·d) is left (Beer's law). "
        + "It applies where a ray meets this surface from inside, over the distance since the last hit (or the camera), but not over a "
        + "distance that ends at another shape within.", Unit = "1/scene unit", Minimum = 0)]
    public Rgb Extinction { get; init; }

    /// <summary>The formula of the reflectance.</summary>
    [Parameter("Whether the reflectance is computed by Fresnel's equations or by Schlick's approximation, as the report did (with the "
        + "angle on the side of the lower index).")]
    public FresnelModel Fresnel { get; init; } = FresnelModel.Exact;

    /// <summary>Factor on all that is reflected.</summary>
    [Parameter("Factor on what is reflected, per channel: 1 for real glass.", Minimum = 0, Maximum = 1)]
    public TextureDescription SpecularReflectance { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>Factor on all that is refracted.</summary>
    [Parameter("Factor on what is refracted, per channel: 1 for real glass. It applies at every boundary; to tint the inside, use "
        + "extinction.", Minimum = 0, Maximum = 1)]
    public TextureDescription SpecularTransmittance { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        Dispersion? dispersion = BuildDispersion(builder, nameof(RefractiveIndex), RefractiveIndex != UsualIndex);
        return new DielectricMaterial(
            RefractiveIndex, Extinction, Fresnel, builder.Texture(SpecularReflectance), builder.Texture(SpecularTransmittance), builder.Medium(Interior), dispersion,
            BuildNesting(RefractiveIndex, dispersion, Extinction));
    }
}

/// <summary>
/// A smooth boundary between the outside and a clear inside: reflects with the probability of the Fresnel reflectance,
/// else refracts by Snell's law (report, section 4.2.3); what arrives from inside, along a path of the camera or of light, has been absorbed
/// by Beer's law.
/// Radiance grows by the square of the index on entering the denser medium (Veach 1997, section 5.2).
/// </summary>
/// <param name="refractiveIndex">Index of the inside over that of the outside, above 0.</param>
/// <param name="extinction">Extinction coefficient of the inside, per scene unit.</param>
/// <param name="model">The formula of the reflectance.</param>
/// <param name="reflectedPart">Factor on what is reflected; null for 1.</param>
/// <param name="refractedPart">Factor on what is refracted; null for 1.</param>
/// <param name="interior">The medium inside besides; null for none.</param>
/// <param name="dispersion">The dependence of the index on the wavelength, in place of <paramref name="refractiveIndex"/>; null where it does
/// not.</param>
/// <param name="nesting">The priority of the inside over others that overlap it, whose extinction then counts in place of
/// <paramref name="extinction"/>; null for an index relative to what is around.</param>
internal sealed class DielectricMaterial(
    float refractiveIndex, Rgb extinction, FresnelModel model, Texture? reflectedPart = null, Texture? refractedPart = null, Medium? interior = null,
    Dispersion? dispersion = null, Nesting? nesting = null) : Material
{
    private readonly bool _weakensInside = nesting is null && !extinction.IsBlack;
    private readonly bool _isColored = (reflectedPart is not null && reflectedPart.Constant != Rgb.White) || (refractedPart is not null && refractedPart.Constant != Rgb.White);

    /// <inheritdoc/>
    public override MaterialTraits Traits => new()
    {
        Specular = SpecularLobe.Delta,
        KeepsEnergy = true,
        IsTransparent = true,
        Interior = interior,
        Nesting = nesting,
        Disperses = dispersion is not null,
        UsesDistance = _weakensInside,
        UsesUv = reflectedPart is { Constant: null } || refractedPart is { Constant: null },
    };

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo) => albedo = Rgb.White;

    /// <inheritdoc/>
    public override void Transparency(in SurfaceW surface, out RgbW transparency)
    {
        Refract(surface, out _, out _, out FloatW reflectance);
        FloatW through = 1f - reflectance;
        transparency = new(through, through, through);
        if (_weakensInside && surface.Inside.Any)
        {
            transparency = surface.Inside.Select(transparency * Transmittance(surface.Distance), transparency);
        }

        if (_isColored)
        {
            Color(surface, MaskW.None, ref transparency);
        }
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        Refract(surface, out FloatW eta, out FloatW cosTransmitted, out FloatW reflectance);
        FloatW cosIncident = surface.Cosine;
        samples.Direction(out FloatW u, out _);
        MaskW reflected = u < reflectance;
        Vec3W refraction = Vec3W.MultiplyAdd(surface.Facing, FloatW.MultiplyAdd(eta, cosIncident, -cosTransmitted), surface.Incoming * eta);
        Vec3W reflection = Vec3W.MultiplyAdd(surface.Facing, cosIncident * 2f, surface.Incoming);
        scatter.Direction = Vec3W.Normalize(reflected.Select(reflection, refraction));
        FloatW weight = surface.CarriesLight ? 1f : reflected.Select(1f, eta * eta);
        scatter.Weight = new(weight, weight, weight);
        if (_weakensInside && surface.Inside.Any)
        {
            scatter.Weight = surface.Inside.Select(scatter.Weight * Transmittance(surface.Distance), scatter.Weight);
        }

        if (_isColored)
        {
            Color(surface, reflected, ref scatter.Weight);
        }

        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.All;
        scatter.Absorbed = MaskW.None;
    }

    // The index of the ray's side over that of the other, the cosine of refraction by Snell's law, and what is reflected.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Refract(in SurfaceW surface, out FloatW eta, out FloatW cosTransmitted, out FloatW reflectance)
    {
        FloatW index = dispersion?.Index(surface.Wavelength) ?? refractiveIndex;
        if (nesting is not null)
        {
            index /= surface.ExteriorIndex;
        }

        eta = surface.Inside.Select(index, 1f / index);
        FloatW cosIncident = surface.Cosine;
        FloatW sin2Transmitted = eta * eta * FloatW.Max(FloatW.NegatedMultiplyAdd(cosIncident, cosIncident, 1f), 0f);
        MaskW total = sin2Transmitted >= 1f;
        cosTransmitted = FloatW.Sqrt(FloatW.Max(1f - sin2Transmitted, 0f));
        reflectance = total.Select(1f, Reflectance(cosIncident, cosTransmitted, eta, index));
    }

    private FloatW Reflectance(FloatW cosIncident, FloatW cosTransmitted, FloatW eta, FloatW index)
    {
        if (model == FresnelModel.Exact)
        {
            return Fresnel.Dielectric(cosIncident, cosTransmitted, eta);
        }

        FloatW r = (index - 1f) / (index + 1f);
        MaskW fromDenser = eta > 1f;
        return Fresnel.Schlick(fromDenser.Select(cosTransmitted, cosIncident), r * r);
    }

    private void Color(in SurfaceW surface, MaskW reflected, ref RgbW weight)
    {
        RgbW above = Rgb.White;
        RgbW through = Rgb.White;
        reflectedPart?.Evaluate(surface, out above);
        refractedPart?.Evaluate(surface, out through);
        weight *= reflected.Select(above, through);
    }

    // Beer 1852; report, section 6.2.6: the fraction of light that is left after a distance.
    private RgbW Transmittance(FloatW distance) => new(
        LaneMath.Exp(distance * -extinction.R), LaneMath.Exp(distance * -extinction.G), LaneMath.Exp(distance * -extinction.B));
}
