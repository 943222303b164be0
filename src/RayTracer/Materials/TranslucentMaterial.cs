using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="TranslucentMaterial"/>.</summary>
[SceneType("translucent", "Paper, cloth, leaves, lampshades: a thin matt sheet that scatters light to both sides.")]
public sealed record TranslucentMaterialDescription : MaterialDescription
{
    /// <summary>Fraction of the light that is reflected.</summary>
    [Parameter("Fraction of the light that is reflected, per channel.", Minimum = 0, Maximum = 1)]
    public TextureDescription Color { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.5f, 0.5f) };

    /// <summary>Fraction of the light that is let through.</summary>
    [Parameter("Fraction of the light that comes out on the other side, per channel. The sum of both fractions must not be above 1.",
        Minimum = 0, Maximum = 1)]
    public TextureDescription Transmittance { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.5f, 0.5f) };

    /// <summary>The medium inside.</summary>
    [Parameter("What fills the inside of the (closed) shape. Shown by path, volPath and the integrators that trace light.")]
    public MediumDescription Interior { get; init; } = new();

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        Texture above = builder.Texture(Color);
        Texture below = builder.Texture(Transmittance);
        if (above.Constant is { } a && below.Constant is { } b && Math.Max(a.R + b.R, Math.Max(a.G + b.G, a.B + b.B)) > 1.00001f)
        {
            builder.Error(this, nameof(Transmittance), "\"color\" and \"transmittance\" together must not be above 1 in any channel: more light would leave than arrives");
        }

        return new TranslucentMaterial(above, below, builder.Medium(Interior));
    }
}

/// <summary>Lambertian reflection and diffuse transmission (report, sections 4.2.2 and 4.2.4): BSDF = colour/π on each side.</summary>
/// <param name="above">Fraction of the light that is reflected.</param>
/// <param name="below">Fraction of the light that is let through.</param>
/// <param name="interior">The medium inside; null for none.</param>
internal sealed class TranslucentMaterial(Texture above, Texture below, Medium? interior = null) : Material
{
    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new()
    {
        IsLit = true,
        Specular = SpecularLobe.Glossy,
        KeepsEnergy = true,
        Transmits = true,
        Interior = interior,
        UsesUv = above.Constant is null || below.Constant is null,
    };

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => above.Evaluate(surface, out surface.DiffuseColor);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        below.Evaluate(surface, out RgbW through);
        response = surface.DiffuseColor + through;
    }

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf) => brdf = surface.DiffuseColor * (1f / float.Pi);

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        below.Evaluate(surface, out RgbW through);
        FloatW cosine = Vec3W.Dot(direction, surface.Facing);
        bsdf = (cosine > 0f).Select(surface.DiffuseColor, through) * (1f / float.Pi);
    }

    /// <inheritdoc/>
    public override void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) => Bsdf(surface, direction, out bsdf);

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        below.Evaluate(surface, out RgbW through);
        FloatW probability = LobeChoice.Probability(surface.DiffuseColor, through);
        FloatW cosine = Vec3W.Dot(direction, surface.Facing);
        pdf = (cosine > 0f).Select(probability, 1f - probability) * FloatW.Abs(cosine) * (1f / float.Pi);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        below.Evaluate(surface, out RgbW through);
        FloatW probability = LobeChoice.Probability(surface.DiffuseColor, through);
        MaskW reflects = samples.Choice() < probability;
        Onb.FromNormal(surface.Facing, out Onb frame);
        Vec3W local = Warp.CosineHemisphere(u, v);
        scatter.Direction = frame.ToWorld(new(local.X, local.Y, reflects.Select(local.Z, -local.Z)));
        scatter.Weight = reflects.Select(surface.DiffuseColor * (1f / probability), through * (1f / (1f - probability)));

        // Lights are sampled for what is reflected; those on the other side are found by the rays.
        scatter.Specular = ~reflects;
        scatter.Delta = MaskW.None;
        scatter.Absorbed = MaskW.None;
    }
}
