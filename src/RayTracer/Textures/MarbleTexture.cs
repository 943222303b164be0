using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="MarbleTexture"/>.</summary>
[SceneType("marble", "Layers across x, bent by noise, as in marble.")]
public sealed record MarbleTextureDescription : SpaceTextureDescription
{
    /// <summary>The stone.</summary>
    [Parameter("The texture of the stone.")]
    public TextureDescription First { get; init; } = new SolidTextureDescription { Color = new(0.85f, 0.84f, 0.8f) };

    /// <summary>The veins.</summary>
    [Parameter("The texture of the veins.")]
    public TextureDescription Second { get; init; } = new SolidTextureDescription { Color = new(0.15f, 0.17f, 0.2f) };

    /// <summary>Layers in a unit.</summary>
    [Parameter("Layers per unit along x; the noise has as many cells.", Unit = "1/scene unit", Minimum = 0)]
    public float Scale { get; init; } = 1;

    /// <summary>The amount by which the layers are bent.</summary>
    [Parameter("How much the layers are bent by noise.", Unit = "layers", Minimum = 0)]
    public float Turbulence { get; init; } = 2;

    /// <summary>Number of octaves of the noise.</summary>
    [Parameter("Octaves of noise, each twice as fine as the one before.", Minimum = 1, Maximum = 16)]
    public int Octaves { get; init; } = 6;

    /// <summary>Selects the noise.</summary>
    [Parameter("Selects the noise.", Minimum = 0, Maximum = 1e9)]
    public int Seed { get; init; }

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new MarbleTexture(Place(builder), builder.Texture(First), builder.Texture(Second), Scale, Turbulence)
    {
        Octaves = Octaves,
        Seed = (uint)Seed,
    };
}

/// <summary>A sine of x plus turbulence (Perlin, An image synthesizer, 1985); the veins are its crests.</summary>
/// <param name="place">The place of the block.</param>
/// <param name="first">The stone.</param>
/// <param name="second">The veins.</param>
/// <param name="scale">Layers in a unit.</param>
/// <param name="turbulence">The bending of the layers, in layers.</param>
internal sealed class MarbleTexture(TexturePlace place, Texture first, Texture second, float scale, float turbulence) : SpaceTexture(place, first, second)
{
    /// <summary>Number of octaves of the noise.</summary>
    public int Octaves { get; init; } = 6;

    /// <summary>Selects the noise.</summary>
    public uint Seed { get; init; }

    /// <inheritdoc/>
    protected override void Amount(in Vec3W point, out FloatW amount)
    {
        Vec3W p = point * scale;
        FloatW layer = FloatW.MultiplyAdd(GradientNoise.Sum(p, Seed, Octaves, 0.5f, isTurbulent: true), turbulence, p.X);
        LaneMath.SinCosTurn(layer - FloatW.Floor(layer), out _, out FloatW cos);

        // Narrow crests: the square of a raised cosine.
        FloatW crest = FloatW.MultiplyAdd(cos, 0.5f, 0.5f);
        amount = FloatW.Min(crest * crest, 1f);
    }
}
