using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Materials;

/// <summary>Describes the surface of a thing that a photograph shows already, and that pictures with alpha leave out (<see cref="FilmPlane.Matte"/>).</summary>
public abstract record MatteMaterialDescription : MaterialDescription
{
    /// <summary>The material of the thing itself.</summary>
    [Parameter("The material that light meets, like that of the thing in the photograph; of any type but a luminaire.")]
    public MaterialDescription Material { get; init; } = new DiffuseMaterialDescription();

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) => new MatteMaterial(WrapperMaterial.Part(builder, this, nameof(Material), Material), Role);

    private protected abstract MatteRole Role { get; }
}

/// <summary>Describes a thing that is cut out.</summary>
[SceneType("holdout", "Another material, cut out of pictures with alpha (--transparent): what stands before a thing of a photograph hides it, and what stands behind "
    + "is hidden by it. Light, shadows and mirrors see the other material.")]
public sealed record HoldoutMaterialDescription : MatteMaterialDescription
{
    private protected override MatteRole Role => MatteRole.Holdout;
}

/// <summary>Describes a thing of which pictures with alpha show the shadows alone.</summary>
[SceneType("shadowCatcher", "Another material, of which pictures with alpha (--transparent) show only what other things change: their shadows darken what the picture is laid over, "
    + "and the light that they throw is added. Light and mirrors see the other material.")]
public sealed record ShadowCatcherMaterialDescription : MatteMaterialDescription
{
    private protected override MatteRole Role => MatteRole.ShadowCatcher;
}

/// <summary>What a surface is to the camera, in pictures with alpha.</summary>
public enum MatteRole
{
    /// <summary>A thing of the scene.</summary>
    None,

    /// <summary>It leaves a hole.</summary>
    Holdout,

    /// <summary>It shows what other things change of its light.</summary>
    ShadowCatcher,
}

/// <summary>Another material, on a thing that stands for one of a photograph.</summary>
/// <param name="inner">The other material.</param>
/// <param name="role">The role that it plays for the camera.</param>
internal sealed class MatteMaterial(Material inner, MatteRole role) : WrapperMaterial(inner)
{
    /// <inheritdoc/>
    public override MaterialTraits Traits => base.Traits with { Matte = role };
}
