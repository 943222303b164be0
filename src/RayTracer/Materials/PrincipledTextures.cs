using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>
/// The parameters of a <see cref="PrincipledMaterial"/> or a <see cref="ThinPrincipledMaterial"/>, which may vary over the surface; of all but the colour, the red channel counts.
/// </summary>
internal sealed class PrincipledTextures
{
    private static readonly SolidTexture s_zero = new(Rgb.Black);

    /// <summary>Colour.</summary>
    public required Texture BaseColor { get; init; }

    /// <summary>Roughness: the square root of alpha.</summary>
    public required Texture Roughness { get; init; }

    /// <summary>0 is a dielectric, 1 a metal.</summary>
    public Texture Metallic { get; init; } = s_zero;

    /// <summary>The stretch of highlights along u.</summary>
    public Texture Anisotropic { get; init; } = s_zero;

    /// <summary>The share of a dielectric's highlight that has the colour of the base.</summary>
    public Texture SpecularTint { get; init; } = s_zero;

    /// <summary>0 is opaque, 1 is glass.</summary>
    public Texture Transmission { get; init; } = s_zero;

    /// <summary>Light at grazing angles.</summary>
    public Texture Sheen { get; init; } = s_zero;

    /// <summary>The share of the sheen that has the colour of the base.</summary>
    public Texture SheenTint { get; init; } = s_zero;

    /// <summary>A second coat.</summary>
    public Texture Clearcoat { get; init; } = s_zero;

    /// <summary>Roughness of the second coat.</summary>
    public Texture ClearcoatRoughness { get; init; } = s_zero;

    /// <summary>How much of the surface has a thin film.</summary>
    public Texture Iridescence { get; init; } = s_zero;

    /// <summary>Thickness of the film, in nm.</summary>
    public Texture FilmThickness { get; init; } = s_zero;

    /// <summary>0 is matt, 1 as if light went around below the surface.</summary>
    public Texture Flatness { get; init; } = s_zero;

    /// <summary>Refractive index, of a thin sheet.</summary>
    public Texture RefractiveIndex { get; init; } = s_zero;

    /// <summary>The part of what is matt that comes out on the other side, of a thin sheet.</summary>
    public Texture DiffuseTransmission { get; init; } = s_zero;

    /// <summary>Some of them vary.</summary>
    public bool UsesUv => BaseColor.Constant is null || Roughness.Constant is null || Metallic.Constant is null || Anisotropic.Constant is null
        || SpecularTint.Constant is null || Transmission.Constant is null || Sheen.Constant is null || SheenTint.Constant is null
        || Clearcoat.Constant is null || ClearcoatRoughness.Constant is null || Flatness.Constant is null || RefractiveIndex.Constant is null
        || DiffuseTransmission.Constant is null || Iridescence.Constant is null || FilmThickness.Constant is null;

    /// <summary>Returns whether a parameter is zero everywhere.</summary>
    public static bool IsZero(Texture texture) => texture.Constant is { R: 0 };
}
