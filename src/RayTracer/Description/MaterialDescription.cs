using RayTracer.Materials;

namespace RayTracer.Description;

/// <summary>Describes a material. Wherever a scene file may have a material, its name may stand instead.</summary>
public abstract record MaterialDescription
{
    /// <summary>Makes the material that this record describes; records that are the same object share one material.</summary>
    /// <param name="builder">Gives access to textures and other materials, and takes diagnostics.</param>
    public abstract Material Build(SceneBuilder builder);
}
