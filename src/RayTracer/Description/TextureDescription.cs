using RayTracer.Textures;

namespace RayTracer.Description;

/// <summary>
/// Describes a texture: a colour that may vary over a surface. Wherever a scene file may have a texture, a colour
/// (a <see cref="SolidTextureDescription"/>) or a texture's name may stand instead.
/// </summary>
public abstract record TextureDescription
{
    /// <summary>Makes the texture that this record describes.</summary>
    /// <param name="builder">Gives access to pictures and takes diagnostics.</param>
    public abstract Texture Build(SceneBuilder builder);
}
