using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="ConductorMaterial"/>.</summary>
[SceneType("conductor", "Polished metal: a mirror that reflects by Fresnel's equations for its complex refractive index.")]
public sealed record ConductorMaterialDescription : MetalDescription
{
    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) => new ConductorMaterial(BuildFresnel(builder), builder.Texture(SpecularReflectance));
}

/// <summary>A mirror of metal.</summary>
/// <param name="fresnel">Its reflectance.</param>
/// <param name="reflectance">Factor on what is reflected.</param>
internal sealed class ConductorMaterial(ConductorFresnel fresnel, Texture reflectance) : Material
{
    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new() { Specular = SpecularLobe.Delta, UsesUv = reflectance.Constant is null };

    /// <inheritdoc/>
    public override void AmbientResponse(in SurfaceW surface, out RgbW response)
    {
        fresnel.Evaluate(surface.Cosine, out response);
        reflectance.Evaluate(surface, out RgbW factor);
        response *= factor;
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        scatter.Direction = Vec3W.Normalize(Vec3W.MultiplyAdd(surface.Facing, surface.Cosine * 2f, surface.Incoming));
        AmbientResponse(surface, out scatter.Weight);
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.All;
        scatter.Absorbed = MaskW.None;
    }
}
