using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="WoodTexture"/>.</summary>
[SceneType("wood", "Rings around y, distorted by noise, as in a trunk: each ring turns slowly into dark late wood and ends abruptly.")]
public sealed record WoodTextureDescription : SpaceTextureDescription
{
    /// <summary>The early wood.</summary>
    [Parameter("The texture where a ring starts.")]
    public TextureDescription First { get; init; } = new SolidTextureDescription { Color = new(0.6f, 0.38f, 0.18f) };

    /// <summary>The late wood.</summary>
    [Parameter("The texture where a ring ends.")]
    public TextureDescription Second { get; init; } = new SolidTextureDescription { Color = new(0.25f, 0.12f, 0.05f) };

    /// <summary>Rings in a unit.</summary>
    [Parameter("Rings per unit of the radius.", Unit = "1/scene unit", Minimum = 0)]
    public float Rings { get; init; } = 8;

    /// <summary>The amount by which the rings are distorted.</summary>
    [Parameter("How much the rings are distorted by noise.", Unit = "rings", Minimum = 0)]
    public float Turbulence { get; init; } = 1;

    /// <summary>Cells of the noise in a unit.</summary>
    [Parameter("Cells of the noise per unit of space; along the trunk it is stretched ten times.", Unit = "1/scene unit", Minimum = 0)]
    public float Scale { get; init; } = 2;

    /// <summary>Selects the noise.</summary>
    [Parameter("Selects the noise.", Minimum = 0, Maximum = 1e9)]
    public int Seed { get; init; }

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) =>
        new WoodTexture(Place(builder), builder.Texture(First), builder.Texture(Second), Rings, Turbulence, Scale) { Seed = (uint)Seed };
}

/// <summary>Rings around the y axis.</summary>
/// <param name="place">The place of the trunk.</param>
/// <param name="first">The early wood.</param>
/// <param name="second">The late wood.</param>
/// <param name="rings">Rings in a unit.</param>
/// <param name="turbulence">The distortion of the rings, in rings.</param>
/// <param name="scale">Cells of the noise in a unit.</param>
internal sealed class WoodTexture(TexturePlace place, Texture first, Texture second, float rings, float turbulence, float scale) : SpaceTexture(place, first, second)
{
    private const float Stretch = 10;

    /// <summary>Selects the noise.</summary>
    public uint Seed { get; init; }

    /// <inheritdoc/>
    protected override void Amount(in Vec3W point, out FloatW amount)
    {
        FloatW radius = FloatW.Sqrt(FloatW.MultiplyAdd(point.X, point.X, point.Z * point.Z));
        Vec3W stretched = new(point.X * scale, point.Y * (scale / Stretch), point.Z * scale);
        FloatW ring = FloatW.MultiplyAdd(GradientNoise.Perlin(stretched, Seed), turbulence, radius * rings);
        FloatW inside = ring - FloatW.Floor(ring);
        amount = FloatW.Min(inside * inside, 1f);
    }
}
