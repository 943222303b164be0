using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="DiffuseMaterial"/>.</summary>
[SceneType("diffuse", "A matt surface that looks equally bright from everywhere (Lambert's law).")]
public sealed record DiffuseMaterialDescription : MaterialDescription
{
    /// <summary>Fraction of the light that is reflected.</summary>
    [Parameter("Fraction of the light that is reflected, per channel.", Minimum = 0, Maximum = 1)]
    public TextureDescription Color { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.5f, 0.5f) };

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) => new DiffuseMaterial(builder.Texture(Color));
}

/// <summary>Lambertian reflection: BRDF = colour/π on the ray's side (report, section 4.2.2).</summary>
/// <param name="texture">Fraction of the light that is reflected.</param>
internal sealed class DiffuseMaterial(Texture texture) : Material
{
    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new() { IsLit = true, KeepsEnergy = true, UsesUv = texture.Constant is null };

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface) => texture.Evaluate(surface, out surface.DiffuseColor);

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response) => response = surface.DiffuseColor;

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf) => brdf = surface.DiffuseColor * (1f / float.Pi);

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Brdf(surface, out RgbW above);
        bsdf = (Vec3W.Dot(direction, surface.Facing) > 0f).Select(above, default);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf) =>
        pdf = Warp.CosineHemispherePdf(Vec3W.Dot(direction, surface.Facing));

    /// <inheritdoc/>
    public override void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        FloatW cosine = Vec3W.Dot(direction, surface.Facing);
        pdf = Warp.CosineHemispherePdf(cosine);
        bsdf = (cosine > 0f).Select(surface.DiffuseColor * (1f / float.Pi), default);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        Onb.FromNormal(surface.Facing, out Onb frame);
        scatter.Direction = frame.ToWorld(Warp.CosineHemisphere(u, v));
        scatter.Weight = surface.DiffuseColor;
        scatter.Specular = MaskW.None;
        scatter.Delta = MaskW.None;
        scatter.Absorbed = MaskW.None;
    }
}
