using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace OwnMaterial;

/// <summary>The material as scene files name it: <c>{ "type": "velvet", "color": "crimson" }</c>.</summary>
[SceneType("velvet", "A surface that looks brighter where it is seen from the side.")]
public sealed record VelvetDescription : MaterialDescription
{
    /// <summary>The colour at the edges.</summary>
    [Parameter("Fraction of the light that is reflected where the surface is seen from the side.", Minimum = 0, Maximum = 1)]
    public TextureDescription Color { get; init; } = "darkred";

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) => new Velvet(builder.Texture(Color));
}

/// <summary>A matt surface whose colour is weighed by one minus the cosine of the direction from which it is seen.</summary>
public sealed class Velvet(Texture color) : Material
{
    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } =
        new() { IsLit = true, UsesUv = color.Constant is null, ReciprocityException = "only the direction of the eye counts" };

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface)
    {
        color.Evaluate(surface, out surface.DiffuseColor);
        surface.DiffuseColor *= 1f + Vec3W.Dot(surface.Incoming, surface.Facing);
    }

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
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        samples.Direction(out FloatW u, out FloatW v);
        Onb.FromNormal(surface.Facing, out Onb frame);
        scatter = new() { Direction = frame.ToWorld(Warp.CosineHemisphere(u, v)), Weight = surface.DiffuseColor };
    }
}
