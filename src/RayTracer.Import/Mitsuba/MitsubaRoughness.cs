using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>The roughness of a surface.</summary>
/// <param name="Distribution">The distribution of the facets' normals.</param>
/// <param name="Alpha">The roughness.</param>
/// <param name="AlphaU">The roughness along u; null where it is <paramref name="Alpha"/>.</param>
/// <param name="AlphaV">The roughness along v; null where it is <paramref name="Alpha"/>.</param>
internal sealed record MitsubaRoughness(MicrofacetDistribution Distribution, TextureDescription Alpha, TextureDescription? AlphaU, TextureDescription? AlphaV)
{
    private const float Standard = 0.1f;
    private const float Roughest = 10;

    private static readonly Dictionary<string, MicrofacetDistribution> s_distributions = new()
    {
        ["beckmann"] = MicrofacetDistribution.Beckmann,
        ["ggx"] = MicrofacetDistribution.Ggx,
    };

    /// <summary>The roughness that a BSDF gives.</summary>
    public static MitsubaRoughness Read(MitsubaObject bsdf, MitsubaTextures textures)
    {
        bsdf.Ignore("sample_visible");
        MicrofacetDistribution distribution = bsdf.Choice("distribution", MicrofacetDistribution.Beckmann, s_distributions);
        TextureDescription? Along(string name) => bsdf.Has(name) || bsdf.HasChild(name) ? textures.Read(bsdf, name, Standard, Roughest) : null;
        (TextureDescription? alphaU, TextureDescription? alphaV) = (Along("alpha_u"), Along("alpha_v"));
        if (alphaU is null != alphaV is null)
        {
            bsdf.Log.Error(bsdf.Place, $"{bsdf.Describe()} needs both \"alpha_u\" and \"alpha_v\", or neither");
        }

        return new(distribution, textures.Read(bsdf, "alpha", Standard, Roughest), alphaU, alphaV);
    }
}
