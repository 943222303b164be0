using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="PhongMaterial"/>.</summary>
[SceneType("phong", "Phong's model, of ambient, diffuse and specular reflection: the surface of early computer graphics.")]
public sealed record PhongMaterialDescription : MaterialDescription
{
    /// <summary>The factor on ambient light; null for the sum of the others.</summary>
    [Parameter("Factor on the scene's ambient light, per channel; without it, the sum of the other two.", Minimum = 0, Maximum = 1)]
    public TextureDescription? Ambient { get; init; }

    /// <summary>Fraction of the light that is reflected alike in all directions.</summary>
    [Parameter("Fraction of the light that is reflected equally in all directions, per channel.", Minimum = 0, Maximum = 1)]
    public TextureDescription Diffuse { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.5f, 0.5f) };

    /// <summary>Fraction of the light that is reflected around the mirror direction.</summary>
    [Parameter("Fraction of the light that is reflected around the mirror direction, per channel. Diffuse and specular together must not "
        + "be above 1.", Minimum = 0, Maximum = 1)]
    public TextureDescription Specular { get; init; } = new SolidTextureDescription { Color = new(0.2f, 0.2f, 0.2f) };

    /// <summary>Exponent of the lobe.</summary>
    [Parameter("Sharpness of the highlights: the density of directions is proportional to the cosine to the mirror direction, to this "
        + "power.", Minimum = 0, Maximum = 1e6)]
    public float Exponent { get; init; } = 50;

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        Texture diffuse = builder.Texture(Diffuse);
        Texture specular = builder.Texture(Specular);
        if (diffuse.Constant is { } a && specular.Constant is { } b && Math.Max(a.R + b.R, Math.Max(a.G + b.G, a.B + b.B)) > 1.00001f)
        {
            builder.Error(this, nameof(Specular), "\"diffuse\" and \"specular\" together must not be above 1 in any channel: more light would leave than arrives");
        }

        return new PhongMaterial(Ambient is null ? null : builder.Texture(Ambient), diffuse, specular, Exponent);
    }
}

/// <summary>
/// Phong's model (report, section 4.2.5; Phong, Illumination for computer generated pictures, 1975) with the specular term k·(R·V)^n in place of BRDF · cosine,
/// scaled so that k is the fraction of light in it; what would go below the surface is lost.
/// </summary>
/// <param name="ambient">The factor on ambient light; null for the sum of the others.</param>
/// <param name="diffuse">Fraction of the light that is reflected alike in all directions.</param>
/// <param name="specular">Fraction of the light that is reflected around the mirror direction.</param>
/// <param name="exponent">Exponent of the lobe, at least 0.</param>
internal sealed class PhongMaterial(Texture? ambient, Texture diffuse, Texture specular, float exponent) : Material
{
    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new()
    {
        IsLit = true,
        Specular = SpecularLobe.Glossy,
        ReciprocityException = "the lobe is divided by the cosine of one of the two directions only (Phong's own formula)",
        UsesUv = ambient is { Constant: null } || diffuse.Constant is null || specular.Constant is null,
    };

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => diffuse.Evaluate(surface, out surface.DiffuseColor);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        if (ambient is not null)
        {
            ambient.Evaluate(surface, out response);
            return;
        }

        Albedo(surface, out response);
    }

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo)
    {
        specular.Evaluate(surface, out RgbW lobe);
        albedo = surface.DiffuseColor + lobe;
    }

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf) => brdf = surface.DiffuseColor * (1f / float.Pi);

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        specular.Evaluate(surface, out RgbW color);
        FloatW cosine = Vec3W.Dot(direction, surface.Facing);
        RgbW sum = RgbW.MultiplyAdd(color, Lobe(surface, direction) / cosine, surface.DiffuseColor * (1f / float.Pi));
        bsdf = (cosine > 0f).Select(sum, default);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        FloatW probability = Probability(surface, out _);
        FloatW cosine = Vec3W.Dot(direction, surface.Facing);
        FloatW sum = FloatW.MultiplyAdd(Lobe(surface, direction), probability, (1f - probability) * Warp.CosineHemispherePdf(cosine));
        pdf = (cosine > 0f).Select(sum, 0f);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        FloatW probability = Probability(surface, out RgbW color);
        MaskW shines = samples.Choice() < probability;
        Onb.FromNormal(shines.Select(Vec3W.Reflect(surface.Incoming, surface.Facing), surface.Facing), out Onb frame);
        scatter.Direction = frame.ToWorld(shines.Select(Warp.CosinePowerLobe(u, v, exponent), Warp.CosineHemisphere(u, v)));
        scatter.Weight = shines.Select(color * (1f / probability), surface.DiffuseColor * (1f / (1f - probability)));
        scatter.Specular = shines;
        scatter.Delta = MaskW.None;
        scatter.Absorbed = Vec3W.Dot(scatter.Direction, surface.Facing) <= 0f;
    }

    private FloatW Probability(in SurfaceW surface, out RgbW color)
    {
        specular.Evaluate(surface, out color);
        return LobeChoice.Probability(color, surface.DiffuseColor);
    }

    private FloatW Lobe(in SurfaceW surface, in Vec3W direction)
    {
        // Of unit vectors, half the squared distance is 1 − cosine, without cancellation in sharp lobes.
        Vec3W off = direction - Vec3W.Reflect(surface.Incoming, surface.Facing);
        return Warp.CosinePowerLobePdf(Vec3W.Dot(off, off) * 0.5f, exponent);
    }
}
