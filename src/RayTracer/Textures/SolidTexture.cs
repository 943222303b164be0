using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="SolidTexture"/>; in scene files, simply a colour.</summary>
[SceneType("solid", "The same colour everywhere. A colour alone means the same.")]
public sealed record SolidTextureDescription : TextureDescription
{
    /// <summary>The colour.</summary>
    [Parameter("The colour.", Minimum = 0, Required = true)]
    public Rgb Color { get; init; }

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new SolidTexture(Color);
}

/// <summary>The same colour everywhere (the report's class of that name).</summary>
/// <param name="value">The colour.</param>
public sealed class SolidTexture(Rgb value) : Texture(TextureInputs.None)
{
    /// <inheritdoc/>
    public override Rgb? Constant => value;

    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color) => color = value;
}
