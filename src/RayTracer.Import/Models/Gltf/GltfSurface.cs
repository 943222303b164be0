using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>The reflection parameters of a glTF material, whichever of its models it uses.</summary>
internal sealed record GltfSurface
{
    /// <summary>The base colour, linear.</summary>
    public required TextureDescription Color { get; init; }

    /// <summary>The set of uv that the colour uses.</summary>
    public required int UvSet { get; init; }

    /// <summary>0 for dielectrics, 1 for metals.</summary>
    public required TextureDescription Metallic { get; init; }

    /// <summary>0 for mirrors, 1 for matt surfaces.</summary>
    public required TextureDescription Roughness { get; init; }

    /// <summary>The refractive index of what light passes through.</summary>
    public float RefractiveIndex { get; init; } = 1.5f;

    /// <summary>The refractive index by which a dielectric reflects head-on what the file says.</summary>
    public float ReflectiveIndex { get; init; } = 1.5f;

    /// <summary>Fraction of the light that a dielectric lets through; null for none.</summary>
    public TextureDescription? Transmission { get; init; }

    /// <summary>The opacity of the surface, where the file says that it counts; null where it does not.</summary>
    public TextureDescription? Opacity { get; init; }

    /// <summary>Reads a material.</summary>
    public static GltfSurface Of(GltfDocument document, GltfTextures textures, GltfObject material) =>
        material.Extension("KHR_materials_pbrSpecularGlossiness") is { } old && !material.Has("pbrMetallicRoughness")
            ? OfSpecularGlossiness(document, textures, old)
            : OfMetallicRoughness(document, textures, material);

    private static GltfSurface OfMetallicRoughness(GltfDocument document, GltfTextures textures, GltfObject material)
    {
        GltfObject? pbr = material.Child("pbrMetallicRoughness");
        GltfTextureUse? color = GltfTextureUse.Of(document, pbr, "baseColorTexture");
        GltfTextureUse? mixed = GltfTextureUse.Of(document, pbr, "metallicRoughnessTexture");
        int uvSet = (color ?? GltfTextureUse.Of(document, material, "emissiveTexture") ?? mixed ?? GltfTextureUse.Of(document, material, "normalTexture"))?.UvSet ?? 0;
        float index = material.Extension("KHR_materials_ior")?.Number("ior", 1.5f, 0, 100) ?? 1.5f;
        GltfObject? transmission = material.Extension("KHR_materials_transmission");
        float passing = transmission?.Fraction("transmissionFactor", 0) ?? 0;
        return new()
        {
            Color = textures.Colour(pbr?.Color("baseColorFactor", Rgb.White, 4) ?? Rgb.White, color, uvSet),
            UvSet = uvSet,
            Metallic = textures.Number(pbr?.Fraction("metallicFactor", 1) ?? 1, mixed, GltfChannel.Blue, uvSet),
            Roughness = textures.Number(pbr?.Fraction("roughnessFactor", 1) ?? 1, mixed, GltfChannel.Green, uvSet),
            RefractiveIndex = float.Max(index, 1),
            ReflectiveIndex = Reflective(document, textures, material.Extension("KHR_materials_specular"), index),
            Transmission = passing > 0 ? textures.Number(passing, GltfTextureUse.Of(document, transmission, "transmissionTexture"), GltfChannel.Red, uvSet) : null,
            Opacity = Alpha(textures, material, pbr?.Numbers("baseColorFactor", 4), color, uvSet),
        };
    }

    private static TextureDescription? Alpha(GltfTextures textures, GltfObject material, IReadOnlyList<float>? factor, GltfTextureUse? color, int uvSet)
    {
        float? threshold = material.Text("alphaMode") == "MASK" ? material.Number("alphaCutoff", 0.5f, 0) : null;
        return threshold is null && material.Text("alphaMode") != "BLEND" ? null : textures.Opacity(float.Clamp(factor?[3] ?? 1, 0, 1), color, threshold, uvSet);
    }

    // Fresnel's reflectance head-on, times the factors of KHR_materials_specular, as an index; one of 0 stands for infinity.
    private static float Reflective(GltfDocument document, GltfTextures textures, GltfObject? specular, float index)
    {
        float amplitude = (index - 1) / (index + 1);
        Rgb color = specular?.Color("specularColorFactor", Rgb.White, 3, float.MaxValue) ?? Rgb.White;
        if (specular is not null && (specular.Has("specularTexture") || specular.Has("specularColorTexture")))
        {
            document.Notes.Add("a texture for a dielectric's reflectance is ignored");
        }

        return IndexOf(document, color * (amplitude * amplitude * (specular?.Fraction("specularFactor", 1) ?? 1)));
    }

    private static GltfSurface OfSpecularGlossiness(GltfDocument document, GltfTextures textures, GltfObject old)
    {
        GltfTextureUse? diffuse = GltfTextureUse.Of(document, old, "diffuseTexture");
        Rgb specular = old.Color("specularFactor", Rgb.White);
        bool isTextured = old.Has("specularGlossinessTexture");
        document.Notes.AddIf(isTextured, "a texture of specular colour and glossiness is ignored");

        // Dielectrics reflect at most some 17 % head-on (diamond); what reflects more is a metal, coloured by its reflection.
        bool isMetal = specular.Luminance > 0.25f && !isTextured;
        int uvSet = diffuse?.UvSet ?? 0;
        return new()
        {
            Color = isMetal ? textures.Colour(specular, null, 0) : textures.Colour(old.Color("diffuseFactor", Rgb.White, 4), diffuse, uvSet),
            UvSet = uvSet,
            Metallic = textures.Number(isMetal ? 1 : 0, null, GltfChannel.Blue, uvSet),
            Roughness = textures.Number(1 - old.Fraction("glossinessFactor", 1), null, GltfChannel.Green, uvSet),
            ReflectiveIndex = isMetal || isTextured ? 1.5f : IndexOf(document, specular),
        };
    }

    // Of R = ((n − 1)/(n + 1))², within what a material takes.
    private static float IndexOf(GltfDocument document, Rgb reflectance)
    {
        float largest = float.Max(reflectance.R, float.Max(reflectance.G, reflectance.B));
        if (float.Min(reflectance.R, float.Min(reflectance.G, reflectance.B)) < 0.99f * largest)
        {
            document.Notes.Add("the colour of a dielectric's reflection is ignored");
        }

        float root = float.Sqrt(float.Min(largest, 1));
        return float.Clamp((1 + root) / float.Max(1 - root, 1e-3f), 1.001f, 10);
    }
}
