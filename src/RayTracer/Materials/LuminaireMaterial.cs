using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="LuminaireMaterial"/>.</summary>
[SceneType("luminaire", "A surface that shines: spheres outwards, planes and triangles on the side of their normal.")]
public sealed record LuminaireMaterialDescription : MaterialDescription
{
    /// <summary>Colour of the light.</summary>
    [Parameter("Colour of the light; with a picture it is a lantern.", Minimum = 0)]
    public TextureDescription Color { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>Factor on the colour.</summary>
    [Parameter("Factor on the colour: radiance along the normal is colour times this.", Minimum = 0)]
    public float Multiplier { get; init; } = 1;

    /// <summary>Exponent of the cosine by which radiance falls off with the angle.</summary>
    [Parameter("How the light is concentrated around the normal: radiance is multiplied by the cosine of the angle to this power. 0 shines "
        + "equally in all directions, 1 is the report's spot light.", Minimum = 0, Maximum = 1e6)]
    public float Exponent { get; init; }

    /// <summary>The material that answers for reflection.</summary>
    [Parameter("The material that reflects, of any other type. Without it, the surface is black where it does not shine.")]
    public MaterialDescription Material { get; init; } = new DiffuseMaterialDescription { Color = new SolidTextureDescription() };

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        if (Color is SolidTextureDescription { Color: var c } && !float.IsFinite((c.R + c.G + c.B) * Multiplier))
        {
            builder.Error(this, nameof(Multiplier), "colour times multiplier is too large a number to compute with");
        }

        if (Material is LuminaireMaterialDescription)
        {
            builder.Error(this, nameof(Material), "the material inside a luminaire must not be a luminaire itself");
            return new DiffuseMaterial(new SolidTexture(Rgb.Black));
        }

        bool isBlack = Material is DiffuseMaterialDescription { Color: SolidTextureDescription { Color.IsBlack: true } };
        return new LuminaireMaterial(builder.EmittedTexture(this, nameof(Color), Color), Multiplier, Exponent, isBlack ? null : WrapperMaterial.Part(builder, this, nameof(Material), Material));
    }
}

/// <summary>
/// Emits colour · multiplier · cos^exponent on the side of the outward normal (report, section 6.2.6); an inner material answers for
/// reflection.
/// </summary>
/// <param name="texture">Colour of the light.</param>
/// <param name="multiplier">Factor on the colour.</param>
/// <param name="exponent">Exponent of the cosine.</param>
/// <param name="inner">The material of reflection; null is black.</param>
internal sealed class LuminaireMaterial(Texture texture, float multiplier, float exponent, Material? inner) : WrapperMaterial(inner ?? s_black)
{
    private static readonly BlackMaterial s_black = new();
    private readonly Rgb? _constant = texture.Constant;

    /// <inheritdoc/>
    public override MaterialTraits Traits => base.Traits with
    {
        Emits = true,
        UsesUv = Inner.Traits.UsesUv || texture.Constant is null,

        // What shines is met, whatever it lets through.
        IsBoundary = false,
        IsTransparent = false,
    };

    /// <inheritdoc/>
    public override void Emission(in FloatW cosine, in FloatW u, in FloatW v, out RgbW radiance)
    {
        if (_constant is { } constant)
        {
            radiance = (RgbW)constant * Falloff(cosine);
            return;
        }

        texture.Evaluate(u, v, out radiance);
        radiance *= Falloff(cosine);
    }

    /// <summary>The same luminaire as another object.</summary>
    internal LuminaireMaterial Copy() => (LuminaireMaterial)MemberwiseClone();

    /// <summary>Colour of the emitted light if it does not depend on uv, else null.</summary>
    public Rgb? ConstantColor => _constant;

    /// <summary>
    /// Mean over all directions of the radiant intensity of a piece of area 1, in luminance: a colour that varies is looked at in some
    /// places only.
    /// </summary>
    internal float MeanIntensity
    {
        get
        {
            float sum = 0;
            for (int i = 0; i < 64; i++)
            {
                texture.Evaluate(((i % 8) + 0.5f) / 8, ((i / 8) + 0.5f) / 8, out RgbW color);
                sum += new Rgb(color.R[0], color.G[0], color.B[0]).Luminance;
            }

            // What is bright between those places must not be taken for black.
            sum = texture.Constant is null ? float.Max(sum, 1) : sum;

            // ∫ cosᵉ⁺¹ over the hemisphere is 2π/(e + 2).
            return sum / 64 * multiplier / (2 * (exponent + 2));
        }
    }

    /// <summary>Power per area.</summary>
    /// <param name="u">First surface coordinate.</param>
    /// <param name="v">Second surface coordinate.</param>
    /// <param name="exitance">The radiant exitance: the integral of radiance times cosine over all directions.</param>
    internal void Exitance(in FloatW u, in FloatW v, out RgbW exitance)
    {
        Emission(1f, u, v, out exitance);
        exitance *= 2 * float.Pi / (exponent + 2);
    }

    /// <summary>A direction of emission around +z, chosen in proportion to radiance times cosine.</summary>
    internal Vec3W EmittedDirection(FloatW u, FloatW v) => exponent == 0 ? Warp.CosineHemisphere(u, v) : Warp.CosinePowerLobe(u, v, exponent + 1);

    /// <summary>The density of <see cref="EmittedDirection"/>, per steradian; zero inside.</summary>
    /// <param name="cosine">Cosine between the outward normal and the direction of emission.</param>
    internal FloatW EmissionPdf(FloatW cosine)
    {
        FloatW outside = FloatW.Max(cosine, 0f);
        FloatW lobe = exponent == 0 ? outside : LaneMath.Pow(outside, exponent + 1);
        return lobe * ((exponent + 2) / (2 * float.Pi));
    }

    /// <summary>The factor on the colour in a direction of emission: multiplier · cos^exponent on the outside, zero inside.</summary>
    /// <param name="cosine">Cosine between the outward normal and the direction of emission.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public FloatW Falloff(FloatW cosine)
    {
        FloatW falloff = multiplier;
        if (exponent != 0)
        {
            falloff *= exponent == 1 ? cosine : LaneMath.Pow(FloatW.Max(cosine, 0f), exponent);
        }

        return (cosine > 0f).Select(falloff, 0f);
    }

    private sealed class BlackMaterial : Material
    {
        public override MaterialTraits Traits { get; } = new();

        public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
        {
            scatter = default;
            scatter.Absorbed = MaskW.All;
        }
    }
}
