using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Along what a gradient grows.</summary>
public enum GradientShape
{
    /// <summary>Along u, from 0 to 1.</summary>
    Linear,

    /// <summary>From the middle of the unit square outwards, up to its edges.</summary>
    Radial,

    /// <summary>Around the middle of the unit square, counter-clockwise from the direction of u.</summary>
    Angular,
}

/// <summary>Describes a <see cref="GradientTexture"/>.</summary>
[SceneType("gradient", "One texture that blends into another: along u, outwards from the middle of uv, or around it. To turn or scale it, "
    + "use placed.")]
public sealed record GradientTextureDescription : TextureDescription
{
    /// <summary>Along what it grows.</summary>
    [Parameter("The direction of the gradient: linear (along u, from 0 to 1), radial (from (1/2, 1/2) up to a distance of 1/2) or angular "
        + "(around that point, counter-clockwise from the direction of u).")]
    public GradientShape Shape { get; init; } = GradientShape.Linear;

    /// <summary>The texture at its beginning.</summary>
    [Parameter("The texture at the start, and before it.")]
    public TextureDescription First { get; init; } = new SolidTextureDescription();

    /// <summary>The texture at its end.</summary>
    [Parameter("The texture at the end, and beyond it.")]
    public TextureDescription Second { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new GradientTexture(Shape, builder.Texture(First), builder.Texture(Second));
}

/// <summary>One texture that turns into another.</summary>
/// <param name="shape">Along what it grows.</param>
/// <param name="first">The texture at its beginning.</param>
/// <param name="second">The texture at its end.</param>
internal sealed class GradientTexture(GradientShape shape, Texture first, Texture second) : BlendTexture(TextureInputs.Uv, first, second)
{
    /// <inheritdoc/>
    protected override void Amount(in TexturePointW at, out FloatW amount)
    {
        FloatW x = at.U - 0.5f;
        FloatW y = at.V - 0.5f;
        FloatW place = shape switch
        {
            GradientShape.Linear => at.U,
            GradientShape.Radial => 2f * FloatW.Sqrt(FloatW.MultiplyAdd(x, x, y * y)),
            _ => LaneMath.Atan2(y, x) * (0.5f / float.Pi),
        };
        if (shape == GradientShape.Angular)
        {
            place -= FloatW.Floor(place);
        }

        amount = FloatW.Max(0f, FloatW.Min(place, 1f));
    }
}
