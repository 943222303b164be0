using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="BrickTexture"/>.</summary>
[SceneType("brick", "Courses of bricks with mortar between them.")]
public sealed record BrickTextureDescription : TextureDescription
{
    /// <summary>Texture of the bricks.</summary>
    [Parameter("Texture of the bricks.")]
    public TextureDescription Brick { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.15f, 0.1f) };

    /// <summary>Texture of the mortar.</summary>
    [Parameter("Texture of the mortar.")]
    public TextureDescription Mortar { get; init; } = new SolidTextureDescription { Color = new(0.6f, 0.58f, 0.55f) };

    /// <summary>Bricks along u and courses along v where uv goes from 0 to 1.</summary>
    [Parameter("Bricks along u and courses along v where uv goes from 0 to 1, each with its mortar.",
        Minimum = 0, MinimumIsExclusive = true)]
    public Vector2 Scale { get; init; } = new(4, 8);

    /// <summary>Thickness of the mortar.</summary>
    [Parameter("Thickness of the mortar, above, below and beside each brick.", Unit = "courses", Minimum = 0, Maximum = 1)]
    public float MortarSize { get; init; } = 0.15f;

    /// <summary>The shift of each course against the one below.</summary>
    [Parameter("How far each course is shifted along u against the one below.", Unit = "bricks")]
    public float Shift { get; init; } = 0.5f;

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new BrickTexture(builder.Texture(Brick), builder.Texture(Mortar), Scale, MortarSize, Shift);
}

/// <summary>Courses of bricks. Half of the mortar lies on either side of the lines between them.</summary>
/// <param name="brick">Texture of the bricks.</param>
/// <param name="mortar">Texture of the mortar.</param>
/// <param name="scale">Bricks along u and courses along v.</param>
/// <param name="mortarSize">Thickness of the mortar in courses; as thick in uv between bricks of a course.</param>
/// <param name="shift">The shift of each course against the one below, in bricks.</param>
internal sealed class BrickTexture(Texture brick, Texture mortar, Vector2 scale, float mortarSize, float shift) : BlendTexture(TextureInputs.Uv, brick, mortar)
{
    private readonly float _halfAcross = 0.5f * mortarSize * scale.X / scale.Y;
    private readonly float _halfAlong = 0.5f * mortarSize;

    /// <inheritdoc/>
    protected override void Amount(in TexturePointW at, out FloatW amount)
    {
        FloatW y = at.V * scale.Y;
        FloatW course = FloatW.Floor(y);
        FloatW x = FloatW.NegatedMultiplyAdd(course, shift, at.U * scale.X);
        MaskW isMortar = (ToLine(x) < _halfAcross) | (ToLine(y) < _halfAlong);
        amount = isMortar.Select(1f, 0f);
    }

    // Distance to the nearest whole number.
    private static FloatW ToLine(FloatW x) => FloatW.Abs(x - FloatW.Floor(x + 0.5f));
}
