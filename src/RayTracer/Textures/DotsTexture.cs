using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="DotsTexture"/>.</summary>
[SceneType("dots", "Dots on a surface: one in about half of the fields that are one unit of (scaled) uv wide, where noise puts it (as in pbrt).")]
public sealed record DotsTextureDescription : TextureDescription
{
    /// <summary>The texture of dots.</summary>
    [Parameter("The texture of the dots.")]
    public TextureDescription Inside { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>The texture around them.</summary>
    [Parameter("The texture around them.")]
    public TextureDescription Outside { get; init; } = new SolidTextureDescription();

    /// <summary>Fields along u and v where uv goes from 0 to 1.</summary>
    [Parameter("Factors on u and v: the number of fields where uv goes from 0 to 1.")]
    public Vector2 Scale { get; init; } = Vector2.One;

    /// <summary>Added to the scaled uv.</summary>
    [Parameter("Added to u and v after scaling.", Unit = "fields")]
    public Vector2 Offset { get; init; }

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new DotsTexture(builder.Texture(Outside), builder.Texture(Inside), Scale, Offset);
}

/// <summary>Dots on a surface (Pharr &amp; Humphreys, Physically based rendering, 2nd ed. 2010, section 10.6.2).</summary>
/// <param name="outside">The texture around dots.</param>
/// <param name="inside">That of dots.</param>
/// <param name="scale">Factors on u and v.</param>
/// <param name="offset">Added after scaling.</param>
internal sealed class DotsTexture(Texture outside, Texture inside, Vector2 scale, Vector2 offset) : BlendTexture(TextureInputs.Uv, outside, inside)
{
    // So that a dot stays within its field.
    private const float Radius = 0.35f;
    private const float MostShift = 0.5f - Radius;

    /// <inheritdoc/>
    protected override void Amount(in TexturePointW at, out FloatW amount)
    {
        FloatW u = FloatW.MultiplyAdd(at.U, scale.X, offset.X);
        FloatW v = FloatW.MultiplyAdd(at.V, scale.Y, offset.Y);
        FloatW column = FloatW.Floor(u + 0.5f);
        FloatW row = FloatW.Floor(v + 0.5f);
        FloatW x = u - column - Noise(column + 1.5f, row + 2.8f) * MostShift;
        FloatW y = v - row - Noise(column + 4.5f, row + 9.8f) * MostShift;
        MaskW isInside = (Noise(column + 0.5f, row + 0.5f) > 0f) & (FloatW.MultiplyAdd(x, x, y * y) < Radius * Radius);
        amount = isInside.Select(1f, 0f);
    }

    private static FloatW Noise(FloatW x, FloatW y) => GradientNoise.Tabled(new(x, y, 0.5f));
}
