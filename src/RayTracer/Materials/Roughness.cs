using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>The roughness of a surface, which may vary over it.</summary>
/// <param name="distribution">The distribution of the microfacets' normals.</param>
/// <param name="alphaU">Roughness along u; its red channel counts.</param>
/// <param name="alphaV">Roughness along v; its red channel counts.</param>
internal sealed class Roughness(MicrofacetDistribution distribution, Texture alphaU, Texture alphaV)
{
    /// <summary>The roughness depends on uv.</summary>
    public bool UsesUv => alphaU.Constant is null || alphaV.Constant is null;

    /// <summary>The roughness may differ along u and v.</summary>
    public bool UsesTangent { get; } = alphaU != alphaV && (alphaU.Constant is not { } u || alphaV.Constant is not { } v || u.R != v.R);

    /// <summary>The roughness that a record describes.</summary>
    /// <param name="builder">Gives access to the textures.</param>
    /// <param name="distribution">The distribution of the microfacets' normals.</param>
    /// <param name="alpha">Roughness in both directions.</param>
    /// <param name="alphaU">Roughness along u; null for the same.</param>
    /// <param name="alphaV">Roughness along v; null for the same.</param>
    public static Roughness Of(SceneBuilder builder, MicrofacetDistribution distribution, TextureDescription alpha, TextureDescription? alphaU, TextureDescription? alphaV) =>
        new(distribution, builder.NumberTexture(alphaU ?? alpha), builder.NumberTexture(alphaV ?? alpha));

    /// <summary>The microfacets at a point.</summary>
    internal void Evaluate(in SurfaceW surface, out Microfacets microfacets)
    {
        alphaU.Evaluate(surface, out RgbW u);
        alphaV.Evaluate(surface, out RgbW v);
        microfacets = new(distribution, u.R, v.R);
    }
}
