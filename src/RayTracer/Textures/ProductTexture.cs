using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="ProductTexture"/>.</summary>
[SceneType("product", "Two textures multiplied, channel by channel: a tinted picture, or a picture and its shadows.")]
public sealed record ProductTextureDescription : TextureDescription
{
    /// <summary>One factor.</summary>
    [Parameter("One factor.", Required = true)]
    public TextureDescription First { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>The other factor.</summary>
    [Parameter("The other factor.", Required = true)]
    public TextureDescription Second { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new ProductTexture(builder.Texture(First), builder.Texture(Second));
}

/// <summary>Two textures multiplied, channel by channel.</summary>
/// <param name="first">One factor.</param>
/// <param name="second">The other factor.</param>
internal sealed class ProductTexture(Texture first, Texture second) : Texture(first.Inputs | second.Inputs)
{
    /// <inheritdoc/>
    public override Rgb? Constant => first.Constant * second.Constant;

    /// <inheritdoc/>
    public override long MemoryBytes => first.MemoryBytes + second.MemoryBytes;

    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color)
    {
        first.Evaluate(at, out RgbW a);
        second.Evaluate(at, out RgbW b);
        color = a * b;
    }
}
