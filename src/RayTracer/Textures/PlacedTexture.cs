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

    /// <summary>A matrix, row by row; empty for none.</summary>
    [Parameter("A matrix, row by row: 2 rows of 3 numbers; the third column is added. Applied before the other parameters.")]
    public IReadOnlyList<float> Matrix { get; init; } = [];

    /// <summary>Factors on u and v.</summary>
    [Parameter("Factors on u and v: 2 shows the texture twice as often, half as large; −1 mirrors it.")]
    public Vector2 Scale { get; init; } = Vector2.One;

    /// <summary>Angle by which the scaled uv is turned about its origin.</summary>
    [Parameter("Angle by which the scaled uv is turned counter-clockwise about its origin; the texture itself turns clockwise.",
        Unit = "degrees")]
    public float Rotate { get; init; }

    /// <summary>Added to u and v last.</summary>
    [Parameter("Added to u and v after scaling and turning.")]
    public Vector2 Offset { get; init; }

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder)
    {
        if (Matrix.Count is not (0 or 6))
        {
            builder.Error(this, nameof(Matrix), $"the matrix of a texture has 2 rows of 3 numbers, which makes 6, not {Matrix.Count}");
            return builder.Texture(Texture);
        }

        return new PlacedTexture(builder.Texture(Texture), Scale, Rotate, Offset) { Matrix = Matrix.Count > 0 ? [.. Matrix] : null };
    }
}

/// <summary>Another texture at other coordinates: scaled, turned, moved.</summary>
/// <param name="texture">The other texture.</param>
/// <param name="scale">Factors on u and v.</param>
/// <param name="rotate">Angle by which the scaled uv is turned counter-clockwise about its origin, in degrees.</param>
/// <param name="offset">Added last.</param>
internal sealed class PlacedTexture(Texture texture, Vector2 scale, float rotate, Vector2 offset) : Texture(texture.Inputs)
{
    private readonly (float Sin, float Cos) _turn = Turn(rotate);

    /// <summary>Two rows of three numbers that are applied first; null for none.</summary>
    public float[]? Matrix { get; init; }

    /// <inheritdoc/>
    public override Rgb? Constant => texture.Constant;

    /// <inheritdoc/>
    public override float Aspect => texture.Aspect;

    /// <inheritdoc/>
    public override long MemoryBytes => texture.MemoryBytes;

    /// <inheritdoc/>
    public override bool HasSlope => texture.HasSlope;

    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color)
    {
        Place(at, out TexturePointW placed);
        texture.Evaluate(placed, out color);
    }

    /// <inheritdoc/>
    public override void Slope(in TexturePointW at, out FloatW alongU, out FloatW alongV)
    {
        Place(at, out TexturePointW placed);
        texture.Slope(placed, out FloatW u, out FloatW v);
        alongU = FloatW.MultiplyAdd(u, _turn.Cos, v * _turn.Sin) * scale.X;
        alongV = FloatW.MultiplyAdd(v, _turn.Cos, -(u * _turn.Sin)) * scale.Y;
        if (Matrix is { } m)
        {
            FloatW first = alongU;
            alongU = FloatW.MultiplyAdd(first, m[0], alongV * m[3]);
            alongV = FloatW.MultiplyAdd(first, m[1], alongV * m[4]);
        }
    }

    private void Place(in TexturePointW at, out TexturePointW placed)
    {
        placed = at;
        if (Matrix is { } m)
        {
            placed.U = FloatW.MultiplyAdd(at.U, m[0], FloatW.MultiplyAdd(at.V, m[1], m[2]));
            placed.V = FloatW.MultiplyAdd(at.U, m[3], FloatW.MultiplyAdd(at.V, m[4], m[5]));
        }

        FloatW x = placed.U * scale.X;
        FloatW y = placed.V * scale.Y;
        placed.U = FloatW.MultiplyAdd(x, _turn.Cos, FloatW.NegatedMultiplyAdd(y, _turn.Sin, offset.X));
        placed.V = FloatW.MultiplyAdd(x, _turn.Sin, FloatW.MultiplyAdd(y, _turn.Cos, offset.Y));
    }

    private static (float Sin, float Cos) Turn(float degrees)
    {
        float turns = degrees / 360;
        LaneMath.SinCosTurn(turns - float.Floor(turns), out float sin, out float cos);
        return (sin, cos);
    }
}
