using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="ThinDielectricMaterial"/>.</summary>
[SceneType("thinDielectric", "A pane of glass without thickness: reflects a little and lets the rest straight through.")]
public sealed record ThinDielectricMaterialDescription : MaterialDescription
{
    /// <summary>Refractive index of the pane, relative to the surroundings.</summary>
    [Parameter("Refractive index of the pane relative to its surroundings.", Minimum = 1e-3, Maximum = 100)]
    public float RefractiveIndex { get; init; } = 1.5f;

    /// <summary>Factor on all that is reflected.</summary>
    [Parameter("Factor on what is reflected, per channel.", Minimum = 0, Maximum = 1)]
    public TextureDescription SpecularReflectance { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>Factor on all that goes through.</summary>
    [Parameter("Factor on what passes through, per channel: tinted glass.", Minimum = 0, Maximum = 1)]
    public TextureDescription SpecularTransmittance { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>The medium inside.</summary>
    [Parameter("What fills the inside of the (closed) shape: a bubble's wall around smoke. Shown by path, volPath and the integrators that trace light.")]
    public MediumDescription Interior { get; init; } = new();

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) =>
        new ThinDielectricMaterial(RefractiveIndex, builder.Texture(SpecularReflectance), builder.Texture(SpecularTransmittance), builder.Medium(Interior));
}

/// <summary>
/// Two smooth boundaries on top of each other, with all reflections between them: of each boundary's reflectance R, R + T²R/(1 − R²) = 2R/(1 + R) is
/// reflected, and the rest passes straight through (Stokes 1862).
/// </summary>
/// <param name="refractiveIndex">Index of the pane over that of its surroundings.</param>
/// <param name="reflectance">Factor on what is reflected.</param>
/// <param name="transmittance">Factor on what goes through.</param>
/// <param name="interior">The medium inside; null for none.</param>
internal sealed class ThinDielectricMaterial(float refractiveIndex, Texture reflectance, Texture transmittance, Medium? interior = null) : Material
{
    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new()
    {
        Specular = SpecularLobe.Delta,
        KeepsEnergy = true,
        IsTransparent = true,
        PassesStraight = true,
        Interior = interior,
        UsesUv = reflectance.Constant is null || transmittance.Constant is null,
    };

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo) => albedo = Rgb.White;

    /// <inheritdoc/>
    public override void Transparency(in SurfaceW surface, out RgbW transparency)
    {
        transmittance.Evaluate(surface, out RgbW through);
        transparency = through * (1f - Reflected(surface));
    }

    /// <inheritdoc/>
    public override void Straight(in SurfaceW surface, out RgbW share) => Transparency(surface, out share);

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        FloatW all = Reflected(surface);
        samples.Direction(out FloatW u, out _);
        MaskW reflected = u < all;
        Vec3W mirror = Vec3W.Normalize(Vec3W.MultiplyAdd(surface.Facing, surface.Cosine * 2f, surface.Incoming));
        scatter.Direction = reflected.Select(mirror, surface.Incoming);
        reflectance.Evaluate(surface, out RgbW above);
        transmittance.Evaluate(surface, out RgbW through);
        scatter.Weight = reflected.Select(above, through);
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.All;
        scatter.Absorbed = MaskW.None;
    }

    private FloatW Reflected(in SurfaceW surface)
    {
        FloatW once = Fresnel.Dielectric(surface.Cosine, 1f / refractiveIndex, out _);
        return 2f * once / (1f + once);
    }
}
