using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="MixTexture"/>.</summary>
[SceneType("mix", "Two textures, mixed by a third.")]
public sealed record MixTextureDescription : TextureDescription
{
    /// <summary>The texture where the weight is 0.</summary>
    [Parameter("The texture where the weight is 0.", Required = true)]
    public TextureDescription First { get; init; } = new SolidTextureDescription();

    /// <summary>The texture where the weight is 1.</summary>
    [Parameter("The texture where the weight is 1.", Required = true)]
    public TextureDescription Second { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>The weight of the second texture.</summary>
    [Parameter("The weight of the second texture: the red channel of this one, whose pictures are read raw.",
        Minimum = 0, Maximum = 1, IsNumber = true)]
    public TextureDescription Weight { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.5f, 0.5f) };

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new MixTexture(builder.Texture(First), builder.Texture(Second), builder.NumberTexture(Weight));
}

/// <summary>Two textures, mixed by a third.</summary>
/// <param name="first">The texture where the weight is 0.</param>
/// <param name="second">The texture where it is 1.</param>
/// <param name="weight">Its red channel is the weight; it is cut off at 0 and 1.</param>
internal sealed class MixTexture(Texture first, Texture second, Texture weight) : BlendTexture(weight.Inputs, first, second)
{
    /// <inheritdoc/>
    public override Rgb? Constant => First.Constant is { } a && Second.Constant is { } b && weight.Constant is { } w
        ? (b * float.Clamp(w.R, 0, 1)) + (a * (1 - float.Clamp(w.R, 0, 1)))
        : null;

    /// <inheritdoc/>
    public override long MemoryBytes => base.MemoryBytes + weight.MemoryBytes;

    /// <inheritdoc/>
    protected override void Amount(in TexturePointW at, out FloatW amount)
    {
        weight.Evaluate(at, out RgbW color);
        amount = FloatW.Max(0f, FloatW.Min(color.R, 1f));
    }
}
