using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="NoiseTexture"/>.</summary>
[SceneType("noise", "Clouds in space: two textures mixed by Perlin's noise, of one octave or several (fractional Brownian motion).")]
public sealed record NoiseTextureDescription : SpaceTextureDescription
{
    /// <summary>The texture in the valleys.</summary>
    [Parameter("The texture where the noise is low.")]
    public TextureDescription First { get; init; } = new SolidTextureDescription();

    /// <summary>The texture on the hills.</summary>
    [Parameter("The texture where the noise is high.")]
    public TextureDescription Second { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>Cells of the first octave in a unit.</summary>
    [Parameter("Cells of the noise per unit of space: larger numbers make it finer.", Unit = "1/scene unit", Minimum = 0)]
    public float Scale { get; init; } = 1;

    /// <summary>Number of octaves.</summary>
    [Parameter("Octaves of noise that are summed, each twice as fine as the one before. 1 is plain noise.", Minimum = 1, Maximum = 16)]
    public int Octaves { get; init; } = 1;

    /// <summary>Height of each octave over that of the one before.</summary>
    [Parameter("Amplitude of each octave relative to the one before: larger numbers make it rougher.", Minimum = 0, Maximum = 1)]
    public float Gain { get; init; } = 0.5f;

    /// <summary>True where magnitudes are summed.</summary>
    [Parameter("Whether the magnitudes of the octaves are summed, which gives billows with creases.")]
    public bool Turbulent { get; init; }

    /// <summary>Selects the noise.</summary>
    [Parameter("Selects the noise.", Minimum = 0, Maximum = 1e9)]
    public int Seed { get; init; }

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) =>
        new NoiseTexture(Place(builder), builder.Texture(First), builder.Texture(Second)) { Scale = Scale, Octaves = Octaves, Gain = Gain, IsTurbulent = Turbulent, Seed = (uint)Seed };
}

/// <summary>Two textures mixed by noise: by half of it and one half, or by its magnitude where it is turbulent.</summary>
/// <param name="place">The place of the noise.</param>
/// <param name="first">The texture where it is low.</param>
/// <param name="second">The texture where it is high.</param>
internal sealed class NoiseTexture(TexturePlace place, Texture first, Texture second) : SpaceTexture(place, first, second)
{
    /// <summary>Cells of the first octave in a unit.</summary>
    public float Scale { get; init; } = 1;

    /// <summary>Number of octaves.</summary>
    public int Octaves { get; init; } = 1;

    /// <summary>Height of each octave over that of the one before.</summary>
    public float Gain { get; init; } = 0.5f;

    /// <summary>True where magnitudes are summed.</summary>
    public bool IsTurbulent { get; init; }

    /// <summary>Selects the noise.</summary>
    public uint Seed { get; init; }

    /// <inheritdoc/>
    protected override void Amount(in Vec3W point, out FloatW amount)
    {
        FloatW noise = GradientNoise.Sum(point * Scale, Seed, Octaves, Gain, IsTurbulent);
        amount = FloatW.Max(0f, FloatW.Min(IsTurbulent ? noise : FloatW.MultiplyAdd(noise, 0.5f, 0.5f), 1f));
    }
}
