using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Description;

/// <summary>
/// Describes a texture: a colour that may vary over a surface. Wherever a scene file may have a texture, a colour
/// (a <see cref="SolidTextureDescription"/>) or a texture's name may stand instead.
/// </summary>
public abstract record TextureDescription
{
    /// <summary>The same colour everywhere: programs write <c>Color = new Rgb(1, 0, 0)</c>.</summary>
    /// <param name="color">The colour.</param>
    public static implicit operator TextureDescription(Rgb color) => new SolidTextureDescription { Color = color };

    /// <summary>The same colour everywhere: programs write <c>Color = "red"</c> or <c>Color = "#f00"</c>, as scene files do.</summary>
    /// <param name="color">A name of CSS, or # and three or six hexadecimal digits.</param>
    /// <exception cref="FormatException">It is neither.</exception>
    public static implicit operator TextureDescription(string color) => (Rgb)color;

    /// <summary>The same number everywhere: programs write <c>Roughness = 0.2f</c>.</summary>
    /// <param name="number">The number.</param>
    public static implicit operator TextureDescription(float number) => new Rgb(number, number, number);

    /// <summary>Makes the texture that this record describes.</summary>
    /// <param name="builder">Gives access to pictures and takes diagnostics.</param>
    public abstract Texture Build(SceneBuilder builder);
}
