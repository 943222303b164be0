using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="PlacedTexture"/>.</summary>
[SceneType("placed", "Another texture, scaled, turned and moved on the surface.")]
public sealed record PlacedTextureDescription : TextureDescription
{
    /// <summary>The texture.</summary>
    [Parameter("The texture.", Required = true)]
    public TextureDescription Texture { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>Factors on u and v.</summary>
    [Parameter("Factors on u and v: 2 shows the texture twice as often, half as large; −1 mirrors it.")]
    public Vector2 Scale { get; init; } = Vector2.One;

    /// <summary>Angle by which the scaled uv is turned about its origin.</summary>
    [Parameter("Angle by which the scaled uv is turned counter-clockwise about its origin; the texture itself turns clockwise.", Unit = "degrees")]
    public float Rotate { get; init; }

    /// <summary>Added to u and v last.</summary>
    [Parameter("Added to u and v after scaling and turning.")]
    public Vector2 Offset { get; init; }

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new PlacedTexture(builder.Texture(Texture), Scale, Rotate, Offset);
}

/// <summary>Another texture at other coordinates: scaled, turned, moved.</summary>
/// <param name="texture">The other texture.</param>
/// <param name="scale">Factors on u and v.</param>
/// <param name="rotate">Angle by which the scaled uv is turned counter-clockwise about its origin, in degrees.</param>
/// <param name="offset">Added last.</param>
public sealed class PlacedTexture(Texture texture, Vector2 scale, float rotate, Vector2 offset) : Texture
{
    private readonly (float Sin, float Cos) _turn = Turn(rotate);

    /// <inheritdoc/>
    public override Rgb? Constant => texture.Constant;

    /// <inheritdoc/>
    public override long MemoryBytes => texture.MemoryBytes;

    /// <inheritdoc/>
    public override void Evaluate(in FloatW u, in FloatW v, out RgbW color)
    {
        FloatW x = u * scale.X;
        FloatW y = v * scale.Y;
        FloatW turnedU = FloatW.MultiplyAdd(x, _turn.Cos, FloatW.NegatedMultiplyAdd(y, _turn.Sin, offset.X));
        FloatW turnedV = FloatW.MultiplyAdd(x, _turn.Sin, FloatW.MultiplyAdd(y, _turn.Cos, offset.Y));
        texture.Evaluate(turnedU, turnedV, out color);
    }

    private static (float Sin, float Cos) Turn(float degrees)
    {
        float turns = degrees / 360;
        LaneMath.SinCosTurn(turns - float.Floor(turns), out float sin, out float cos);
        return (sin, cos);
    }
}
