using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="PhongMetalMaterial"/>.</summary>
[SceneType("phongMetal", "A metal: reflects around the mirror direction, in a lobe that narrows as the exponent grows.")]
public sealed record PhongMetalMaterialDescription : MaterialDescription
{
    /// <summary>Fraction of the light that is reflected.</summary>
    [Parameter("Fraction of the light that is reflected, per channel.", Minimum = 0, Maximum = 1)]
    public TextureDescription Color { get; init; } = new SolidTextureDescription { Color = new(0.9f, 0.9f, 0.9f) };

    /// <summary>Exponent of the lobe.</summary>
    [Parameter("Sharpness of the reflection: the density of directions is proportional to the cosine to the mirror direction, to this "
        + "power (those below the surface are lost). About 10 is brushed metal, 1,000 polished, 100,000 almost a "
        + "mirror.", Minimum = 0, Maximum = 1e6)]
    public float Exponent { get; init; } = 10000;

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) => new PhongMetalMaterial(builder.Texture(Color), Exponent);
}

/// <summary>
/// A cosine-power lobe around the mirror direction (report, section 6.2.6; Shirley &amp; Morley, Realistic Ray Tracing, 2003).
/// The weight of every direction is the colour; directions below the surface end the path. So the BRDF is colour · pdf / cosine.
/// </summary>
/// <param name="texture">Fraction of the light that is reflected.</param>
/// <param name="exponent">Exponent of the lobe, at least 0.</param>
internal sealed class PhongMetalMaterial(Texture texture, float exponent) : Material
{
    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new()
    {
        Specular = SpecularLobe.Glossy,
        ReciprocityException = "the lobe is divided by the cosine of one of the two directions only (the report's metal)",
        UsesUv = texture.Constant is null,
    };

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response) => texture.Evaluate(surface, out response);

    /// <inheritdoc/>
    public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        texture.Evaluate(surface, out RgbW color);
        FloatW cosine = Vec3W.Dot(direction, surface.Facing);
        Pdf(surface, direction, out FloatW pdf);
        bsdf = color * (cosine > 0f).Select(pdf / cosine, 0f);
    }

    /// <inheritdoc/>
    public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        // Of unit vectors, half the squared distance is 1 − cosine, without cancellation in sharp lobes.
        Vec3W off = direction - Vec3W.Reflect(surface.Incoming, surface.Facing);
        FloatW lobe = Warp.CosinePowerLobePdf(Vec3W.Dot(off, off) * 0.5f, exponent);
        pdf = (Vec3W.Dot(direction, surface.Facing) > 0f).Select(lobe, 0f);
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        Vec3W mirror = Vec3W.Reflect(surface.Incoming, surface.Facing);
        Onb.FromNormal(mirror, out Onb frame);
        scatter.Direction = frame.ToWorld(Warp.CosinePowerLobe(u, v, exponent));
        texture.Evaluate(surface, out scatter.Weight);
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.None;
        scatter.Absorbed = Vec3W.Dot(scatter.Direction, surface.Facing) <= 0f;
    }
}
