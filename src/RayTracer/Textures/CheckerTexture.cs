using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="CheckerTexture"/>.</summary>
[SceneType("checker", "A chessboard: fields of two textures, each one unit of (scaled) uv wide.")]
public sealed record CheckerTextureDescription : TextureDescription
{
    /// <summary>Texture of the field at the origin.</summary>
    [Parameter("Texture of the field whose lower left corner is the origin of uv, and of every second field from there.")]
    public TextureDescription Even { get; init; } = new SolidTextureDescription { Color = new(0.8f, 0.8f, 0.8f) };

    /// <summary>Texture of the other fields.</summary>
    [Parameter("Texture of the other fields.")]
    public TextureDescription Odd { get; init; } = new SolidTextureDescription { Color = new(0.2f, 0.2f, 0.2f) };

    /// <summary>Fields along u and v where uv goes from 0 to 1.</summary>
    [Parameter("Factors on u and v: the number of fields where uv goes from 0 to 1.")]
    public Vector2 Scale { get; init; } = Vector2.One;

    /// <summary>Added to the scaled uv.</summary>
    [Parameter("Added to u and v after scaling.", Unit = "fields")]
    public Vector2 Offset { get; init; }

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) =>
        new CheckerTexture(builder.Texture(Even), builder.Texture(Odd), Scale, Offset);
}

/// <summary>A chess board of two textures.</summary>
/// <param name="even">Texture of the field at the origin of uv.</param>
/// <param name="odd">Texture of the fields beside it.</param>
/// <param name="scale">Factors on u and v.</param>
/// <param name="offset">Added after scaling.</param>
internal sealed class CheckerTexture(Texture even, Texture odd, Vector2 scale, Vector2 offset) : Texture(TextureInputs.Uv | even.Inputs | odd.Inputs)
{
    /// <inheritdoc/>
    public override long MemoryBytes => even.MemoryBytes + odd.MemoryBytes;

    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color)
    {
        FloatW field = FloatW.Floor(FloatW.MultiplyAdd(at.U, scale.X, offset.X)) + FloatW.Floor(FloatW.MultiplyAdd(at.V, scale.Y, offset.Y));
        FloatW half = field * 0.5f;
        MaskW isEven = FloatW.Floor(half) >= half;
        even.Evaluate(at, out RgbW a);
        odd.Evaluate(at, out RgbW b);
        color = isEven.Select(a, b);
    }
}
