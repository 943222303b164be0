namespace RayTracer.Materials;

/// <summary>
/// What a material declares about its scattering: which laws it keeps, and which it breaks and why. Tests hold every material
/// to its declaration, and integrators may rely on it.
/// </summary>
public sealed record ScatteringProperties
{
    /// <summary>What the choices are like that <see cref="Material.Scatter"/> calls specular.</summary>
    public SpecularLobe Specular { get; init; }

    /// <summary>
    /// Why the material is not reciprocal; null where it is. Reciprocal: the BSDF is the same with the directions exchanged,
    /// after division by the squared refractive index of the side that the light leaves on (Veach 1997, chapter 6).
    /// </summary>
    public string? ReciprocityException { get; init; }

    /// <summary>Why more light may go on than arrives; null where that never is so.</summary>
    public string? EnergyException { get; init; }

    /// <summary>The largest part of the light that may go on, seen from any angle: 1 unless there is an <see cref="EnergyException"/>.</summary>
    public float MostEnergy { get; init; } = 1;

    /// <summary>
    /// Whether, with colours of one and nothing absorbed inside, all light goes on: the weights of <see cref="Material.Scatter"/>
    /// have mean 1, measured in radiance over the squared refractive index. Where not, the mean is at most 1.
    /// </summary>
    public bool KeepsEnergy { get; init; }
}

/// <summary>What a material's specular choices are like.</summary>
public enum SpecularLobe
{
    /// <summary>There are none.</summary>
    None,

    /// <summary>They have a density per steradian, so <see cref="Material.Pdf"/> and <see cref="Material.Bsdf"/> hold them.</summary>
    Glossy,

    /// <summary>They have single directions (Dirac's delta): their density is no number, and neither method holds them.</summary>
    Delta,
}
