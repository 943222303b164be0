using RayTracer.Media;

namespace RayTracer.Materials;

/// <summary>
/// The constants of a material: what integrators may skip or rely on, what fills its inside, and which laws of scattering it keeps. Tests
/// hold every material to them. A material around another one changes what it must of the other's traits, and <c>|</c> joins the traits of
/// two materials, either of which a path may meet.
/// </summary>
public readonly record struct MaterialTraits()
{
    /// <summary>Light sources are sampled at hits: <see cref="Material.Brdf"/> may be other than zero.</summary>
    public bool IsLit { get; init; }

    /// <summary><see cref="Material.Bsdf"/> may be other than zero for directions through the surface.</summary>
    public bool Transmits { get; init; }

    /// <summary><see cref="Material.Transparency"/> may be other than zero.</summary>
    public bool IsTransparent { get; init; }

    /// <summary>All light goes straight through, so that a path has no vertex here.</summary>
    public bool IsBoundary { get; init; }

    /// <summary><see cref="Material.Straight"/> may be other than zero.</summary>
    public bool PassesStraight { get; init; }

    /// <summary><see cref="Material.Emission"/> may be other than zero.</summary>
    public bool Emits { get; init; }

    /// <summary>Some result depends on uv; where none does, uv need not be computed.</summary>
    public bool UsesUv { get => field || UsesTangent; init; }

    /// <summary>Some result depends on <see cref="SurfaceW.Tangent"/>.</summary>
    public bool UsesTangent { get; init; }

    /// <summary>Scattering depends on <see cref="SurfaceW.Distance"/>, the length of the ray.</summary>
    public bool UsesDistance { get; init; }

    /// <summary>Scattering depends on <see cref="SurfaceW.Wavelength"/>.</summary>
    public bool Disperses { get; init; }

    /// <summary><see cref="Material.Prepare"/> turns <see cref="SurfaceW.Facing"/>.</summary>
    public bool TurnsNormal { get; init; }

    /// <summary>
    /// Normals that would face away are mirrored into view, which leaves nothing to be taken literally
    /// (<see cref="Description.ShadingNormals"/>).
    /// </summary>
    public bool MirrorsNormal { get; init; }

    /// <summary>
    /// With colours of one and nothing absorbed inside, all light is scattered: the weights of <see cref="Material.Scatter"/> have mean 1,
    /// measured in radiance over the squared refractive index. Otherwise, the mean is at most 1.
    /// </summary>
    public bool KeepsEnergy { get; init; }

    /// <summary>The kind of the choices that <see cref="Material.Scatter"/> calls specular.</summary>
    public SpecularLobe Specular { get; init; }

    /// <summary>
    /// The largest part of the light that may be scattered, seen from any angle: 1 unless there is an <see cref="EnergyException"/>.
    /// </summary>
    public float MostEnergy { get; init; } = 1;

    /// <summary>The reason why more light may be scattered than arrives; null where that never is so.</summary>
    public string? EnergyException { get; init; }

    /// <summary>
    /// The reason why the material is not reciprocal; null where it is. Reciprocal: the BSDF is the same with the directions exchanged,
    /// after division by the squared refractive index of the side that the light leaves on (Veach 1997, chapter 6).
    /// </summary>
    public string? ReciprocityException { get; init; }

    /// <summary>The medium that fills the inside of the shape; null for empty space.</summary>
    public Medium? Interior { get; init; }

    /// <summary>
    /// How the inside goes with others that overlap it; null for a boundary whose refractive index is relative to what is around.
    /// </summary>
    public Nesting? Nesting { get; init; }

    /// <summary>What the surface is to the camera, in pictures with alpha.</summary>
    public MatteRole Matte { get; init; }

    /// <summary>
    /// <see cref="Material.Bsdf"/> and <see cref="Material.Pdf"/> may be other than zero, so that light can come from a direction that is
    /// chosen elsewhere.
    /// </summary>
    public bool HasDensity => IsLit || Specular == SpecularLobe.Glossy;

    /// <summary>
    /// The traits of a material that is one of two: what either may do it may do, and only what both keep to it keeps to. The first one's
    /// inside comes first.
    /// </summary>
    public static MaterialTraits operator |(in MaterialTraits one, in MaterialTraits other) => new()
    {
        IsLit = one.IsLit || other.IsLit,
        Transmits = one.Transmits || other.Transmits,
        IsTransparent = one.IsTransparent || other.IsTransparent,
        IsBoundary = one.IsBoundary && other.IsBoundary,
        PassesStraight = one.PassesStraight || other.PassesStraight,
        Emits = one.Emits || other.Emits,
        UsesUv = one.UsesUv || other.UsesUv,
        UsesTangent = one.UsesTangent || other.UsesTangent,
        UsesDistance = one.UsesDistance || other.UsesDistance,
        Disperses = one.Disperses || other.Disperses,
        TurnsNormal = one.TurnsNormal || other.TurnsNormal,
        MirrorsNormal = one.MirrorsNormal || other.MirrorsNormal,
        KeepsEnergy = one.KeepsEnergy && other.KeepsEnergy,
        Specular = one.Specular == SpecularLobe.None ? other.Specular
            : other.Specular == SpecularLobe.None || other.Specular == one.Specular ? one.Specular : SpecularLobe.Glossy,
        MostEnergy = float.Max(one.MostEnergy, other.MostEnergy),
        EnergyException = one.EnergyException ?? other.EnergyException,
        ReciprocityException = one.ReciprocityException ?? other.ReciprocityException,
        Interior = one.Interior ?? other.Interior,
        Nesting = one.Nesting ?? other.Nesting,
        Matte = one.Matte == MatteRole.None ? other.Matte : one.Matte,
    };
}

/// <summary>The kinds of a material's specular choices.</summary>
public enum SpecularLobe
{
    /// <summary>There are none.</summary>
    None,

    /// <summary>They have a density per steradian, so <see cref="Material.Pdf"/> and <see cref="Material.Bsdf"/> hold them.</summary>
    Glossy,

    /// <summary>They have single directions (Dirac's delta): their density is no number, and neither method holds them.</summary>
    Delta,
}
