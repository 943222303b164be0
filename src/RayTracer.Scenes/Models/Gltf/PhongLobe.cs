namespace RayTracer.Scenes;

/// <summary>What exponent of a cosine lobe is as wide as a rough surface of microfacets.</summary>
internal static class PhongLobe
{
    // Mirrors beyond this cannot be told apart, and it is the largest exponent that a material takes.
    private const float Sharpest = 1e6f;

    /// <summary>
    /// The exponent for a roughness. α = roughness² (Karis 2013, "Material Model"; glTF 2.0, appendix B.2.3); microfacet normals of
    /// that α are spread as cosⁿ with n = 2/α² − 2 (Walter et al. 2007, section 5.2); reflection turns twice as far as the normal,
    /// so the lobe around the mirror direction has a quarter of it (Fisher &amp; Woo 1994).
    /// </summary>
    /// <param name="roughness">As glTF has it, 0 to 1.</param>
    public static float Exponent(float roughness)
    {
        float alpha = roughness * roughness;
        float exponent = ((2 / (alpha * alpha)) - 2) / 4;
        return float.Clamp(exponent, 0, Sharpest);
    }

    /// <summary>Whether a surface of that exponent looks matt: its lobe is as wide as a matt surface's own cosine.</summary>
    public static bool IsMatt(float exponent) => exponent <= 1;
}
