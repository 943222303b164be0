using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>The common part of the descriptions of smooth and rough conductors.</summary>
public abstract record MetalDescription : MaterialDescription
{
    /// <summary>The metal; null where <see cref="Eta"/> and <see cref="K"/> describe it.</summary>
    [Parameter("Which metal, from published tables; \"none\" reflects everything. It is \"none\" where neither this nor eta and k are "
        + "given.")]
    public Metal? Metal { get; init; }

    /// <summary>Real part of the refractive index.</summary>
    [Parameter("Real part of the refractive index, per channel, relative to the outside; together with k, in place of a metal's name.",
        Minimum = 1e-3, Maximum = 100)]
    public Rgb? Eta { get; init; }

    /// <summary>Imaginary part of the refractive index.</summary>
    [Parameter("Imaginary part of the refractive index (extinction coefficient), per channel; together with eta.",
        Minimum = 0, Maximum = 100)]
    public Rgb? K { get; init; }

    /// <summary>Factor on all that is reflected.</summary>
    [Parameter("Factor on what is reflected, per channel: 1 for real metals.", Minimum = 0, Maximum = 1)]
    public TextureDescription SpecularReflectance { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>The reflectance of the metal that is named, or whose index is given.</summary>
    /// <param name="builder">Takes the diagnostics.</param>
    /// <param name="coat">Index of what lies on the metal, relative to the outside.</param>
    private protected ConductorFresnel BuildFresnel(SceneBuilder builder, float coat = 1)
    {
        if (Metal is not null && (Eta ?? K) is not null)
        {
            builder.Error(this, nameof(Metal), "a conductor has either a \"metal\" or \"eta\" and \"k\", not both");
        }
        else if ((Eta is null) != (K is null))
        {
            builder.Error(this, Eta is null ? nameof(K) : nameof(Eta), "\"eta\" and \"k\" must be given together");
        }

        return Eta is { } eta && K is { } k ? new(eta * (1 / coat), k * (1 / coat)) : new(Metal ?? Materials.Metal.None, coat);
    }
}
