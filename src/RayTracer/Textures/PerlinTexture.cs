using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>What is made of octaves of noise.</summary>
public enum PerlinPattern
{
    /// <summary>Their sum.</summary>
    Fbm,

    /// <summary>The sum of their magnitudes.</summary>
    Wrinkled,

    /// <summary>Waves of water, which wind raises in some places.</summary>
    Windy,

    /// <summary>Layers of grey marble.</summary>
    Marble,
}

/// <summary>Describes a <see cref="PerlinTexture"/>.</summary>
[SceneType("perlin", "Noise in space by Perlin's published table, as numbers that are not brought into any range: heights of bumps, factors, amounts; or grey marble. The patterns are those "
    + "of pbrt.")]
public sealed record PerlinTextureDescription : SpaceTextureDescription
{
    /// <summary>What is made of the noise.</summary>
    [Parameter("What is made of the noise: \"fbm\" sums octaves, each 1.99 times as fine as the one before, around 0; \"wrinkled\" sums their magnitudes; \"windy\" is water, whose waves are high "
        + "where the wind blows; \"marble\" is the colour of a grey stone in layers across y.")]
    public PerlinPattern Pattern { get; init; }

    /// <summary>Number of octaves.</summary>
    [Parameter("Octaves of noise that are summed; of \"windy\", 3 for the wind and 6 for the waves.", Minimum = 1, Maximum = 16)]
    public int Octaves { get; init; } = 8;

    /// <summary>Height of each octave over that of the one before.</summary>
    [Parameter("Amplitude of each octave relative to the one before; of \"windy\", ½.", Minimum = 0, Maximum = 1)]
    public float Roughness { get; init; } = 0.5f;

    /// <summary>How far the layers of marble are bent.</summary>
    [Parameter("Of \"marble\": how much the layers are bent by the noise.", Minimum = 0)]
    public float Variation { get; init; } = 0.2f;

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new PerlinTexture(Place(builder), this);
}

/// <summary>
/// Patterns of noise by Perlin's table (Pharr &amp; Humphreys, Physically based rendering, 2nd ed. 2010, section 10.6, and pbrt-v4; octaves that are too fine for a pixel
/// are summed here, too).
/// </summary>
/// <param name="place">The place of the noise.</param>
/// <param name="what">The pattern.</param>
internal sealed class PerlinTexture(TexturePlace place, PerlinTextureDescription what) : Texture(place.Inputs)
{
    /// <summary>Frequency of each octave over that of the one before: not 2, lest their zeros meet.</summary>
    public const float Finer = 1.99f;

    private const float Wind = 0.1f;

    // Marble is brighter than its colours by so much.
    private const float Brightness = 1.5f;

    // A curve of six pieces, each of which has four of them in turn as the corners of Bézier's.
    private static readonly Rgb[] s_marble =
        [new(0.58f, 0.58f, 0.6f), new(0.58f, 0.58f, 0.6f), new(0.58f, 0.58f, 0.6f), new(0.5f, 0.5f, 0.5f), new(0.6f, 0.59f, 0.58f), new(0.58f, 0.58f, 0.6f), new(0.58f, 0.58f, 0.6f), new(0.2f, 0.2f, 0.33f), new(0.58f, 0.58f, 0.6f)];

    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color)
    {
        place.Find(at, out Vec3W point);
        if (what.Pattern == PerlinPattern.Marble)
        {
            Marble(FloatW.MultiplyAdd(Sum(point, what.Octaves, what.Roughness, isMagnitude: false), what.Variation, point.Y), out color);
            return;
        }

        FloatW value = what.Pattern == PerlinPattern.Windy
            ? FloatW.Abs(Sum(point * Wind, 3, 0.5f, isMagnitude: false)) * Sum(point, 6, 0.5f, isMagnitude: false)
            : Sum(point, what.Octaves, what.Roughness, what.Pattern == PerlinPattern.Wrinkled);
        color = new(value, value, value);
    }

    /// <summary>Octaves of noise, the first of height 1.</summary>
    /// <param name="p">The points.</param>
    /// <param name="octaves">How many.</param>
    /// <param name="gain">Height of each over that of the one before.</param>
    /// <param name="isMagnitude">True if the magnitude of each is summed.</param>
    public static FloatW Sum(in Vec3W p, int octaves, float gain, bool isMagnitude)
    {
        FloatW sum = 0f;
        (float height, float frequency) = (1, 1);
        for (int octave = 0; octave < octaves; octave++)
        {
            FloatW noise = GradientNoise.Tabled(p * frequency);
            sum = FloatW.MultiplyAdd(isMagnitude ? FloatW.Abs(noise) : noise, height, sum);
            height *= gain;
            frequency *= Finer;
        }

        return sum;
    }

    private static void Marble(in FloatW layer, out RgbW color)
    {
        LaneMath.SinCos(layer, out FloatW sin, out _);
        FloatW along = FloatW.MultiplyAdd(sin, 0.5f, 0.5f) * (s_marble.Length - 3);
        FloatW piece = FloatW.Max(0f, FloatW.Min(FloatW.Floor(along), s_marble.Length - 4));
        FloatW t = along - piece;
        FloatW s = 1f - t;
        color = default;
        for (int i = 0; i + 3 < s_marble.Length; i++)
        {
            RgbW curve = RgbW.MultiplyAdd(s_marble[i], s * s * s, RgbW.MultiplyAdd(s_marble[i + 1], s * s * t * 3f, RgbW.MultiplyAdd(s_marble[i + 2], s * t * t * 3f, (RgbW)s_marble[i + 3] * (t * t * t))));
            color = ((piece >= i) & (piece <= i)).Select(curve * Brightness, color);
        }
    }
}
