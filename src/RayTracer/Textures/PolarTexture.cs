using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="PolarTexture"/>.</summary>
[SceneType("polar", "Another texture around the middle of uv, (½, ½): its u is the distance from there (1 at the edge of the unit square), "
    + "its v the angle from the direction of u (1 for a full turn).")]
public sealed record PolarTextureDescription : TextureDescription
{
    /// <summary>The texture.</summary>
    [Parameter("The texture.", Required = true)]
    public TextureDescription Texture { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new PolarTexture(builder.Texture(Texture));
}

/// <summary>Another texture in polar coordinates around (½, ½).</summary>
/// <param name="texture">The other texture.</param>
internal sealed class PolarTexture(Texture texture) : Texture(texture.Inputs)
{
    /// <inheritdoc/>
    public override Rgb? Constant => texture.Constant;

    /// <inheritdoc/>
    public override long MemoryBytes => texture.MemoryBytes;

    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color)
    {
        FloatW x = FloatW.MultiplyAdd(at.U, 2f, -1f);
        FloatW y = FloatW.MultiplyAdd(at.V, 2f, -1f);
        FloatW turn = LaneMath.Atan2(y, x) * (0.5f / float.Pi);
        TexturePointW polar = at;
        polar.U = FloatW.Sqrt(FloatW.MultiplyAdd(x, x, y * y));
        polar.V = (turn < 0f).Select(turn + 1f, turn);
        texture.Evaluate(polar, out color);
    }
}
