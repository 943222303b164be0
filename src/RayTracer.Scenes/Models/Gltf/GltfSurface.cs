using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>What a glTF material says about reflection, whichever of its models it uses; textures of single numbers are averaged.</summary>
internal sealed record GltfSurface
{
    /// <summary>The base colour, linear.</summary>
    public required TextureDescription Color { get; init; }

    /// <summary>Which set of uv the colour uses.</summary>
    public required int UvSet { get; init; }

    /// <summary>0 for dielectrics, 1 for metals.</summary>
    public required float Metallic { get; init; }

    /// <summary>0 for mirrors, 1 for matt surfaces.</summary>
    public required float Roughness { get; init; }

    /// <summary>The refractive index.</summary>
    public float RefractiveIndex { get; init; } = 1.5f;

    /// <summary>What a dielectric reflects head-on: the largest channel.</summary>
    public float R0 { get; init; } = 0.04f;

    /// <summary>Colour of what a dielectric reflects head-on, its largest channel 1.</summary>
    public Rgb CoatColor { get; init; } = Rgb.White;

    /// <summary>Fraction of the light that a dielectric lets through.</summary>
    public float Transmission { get; init; }

    /// <summary>Reads a material.</summary>
    public static GltfSurface Of(GltfDocument document, GltfTextures textures, GltfObject material) =>
        material.Extension("KHR_materials_pbrSpecularGlossiness") is { } old && !material.Has("pbrMetallicRoughness")
            ? OfSpecularGlossiness(document, textures, old)
            : OfMetallicRoughness(document, textures, material);

    private static GltfSurface OfMetallicRoughness(GltfDocument document, GltfTextures textures, GltfObject material)
    {
        GltfObject? pbr = material.Child("pbrMetallicRoughness");
        GltfTextureUse? color = GltfTextureUse.Of(document, pbr, "baseColorTexture");
        int uvSet = color?.UvSet ?? GltfTextureUse.Of(document, material, "emissiveTexture")?.UvSet ?? 0;
        GltfTextureUse? mixed = GltfTextureUse.Of(document, pbr, "metallicRoughnessTexture");
        if (mixed is not null)
        {
            document.Notes.Add("a texture of metalness and roughness is averaged over the picture");
        }

        IReadOnlyList<float> mean = textures.Mean(mixed);
        float index = material.Extension("KHR_materials_ior")?.Number("ior", 1.5f, 0, 100) ?? 1.5f;
        (float r0, Rgb coat) = Specular(document, textures, material.Extension("KHR_materials_specular"), index);
        GltfObject? transmission = material.Extension("KHR_materials_transmission");
        return new()
        {
            Color = textures.Colour(pbr?.Color("baseColorFactor", Rgb.White, 4) ?? Rgb.White, color, uvSet),
            UvSet = uvSet,
            Metallic = (pbr?.Fraction("metallicFactor", 1) ?? 1) * mean[2],
            Roughness = (pbr?.Fraction("roughnessFactor", 1) ?? 1) * mean[1],
            RefractiveIndex = float.Max(index, 1),
            R0 = r0,
            CoatColor = coat,
            Transmission = (transmission?.Fraction("transmissionFactor", 0) ?? 0) * textures.Mean(GltfTextureUse.Of(document, transmission, "transmissionTexture"))[0],
        };
    }

    // Fresnel's reflectance head-on, times the factors of KHR_materials_specular; an index of 0 stands for infinity.
    private static (float R0, Rgb Color) Specular(GltfDocument document, GltfTextures textures, GltfObject? specular, float index)
    {
        float amplitude = (index - 1) / (index + 1);
        Rgb color = specular?.Color("specularColorFactor", Rgb.White, 3, float.MaxValue) ?? Rgb.White;
        float factor = (specular?.Fraction("specularFactor", 1) ?? 1) * textures.Mean(GltfTextureUse.Of(document, specular, "specularTexture"))[0];
        if (specular?.Has("specularColorTexture") == true)
        {
            document.Notes.Add("a texture of the colour of reflections is left out");
        }

        return Split(color * (amplitude * amplitude * factor));
    }

    private static GltfSurface OfSpecularGlossiness(GltfDocument document, GltfTextures textures, GltfObject old)
    {
        GltfTextureUse? diffuse = GltfTextureUse.Of(document, old, "diffuseTexture");
        Rgb specular = old.Color("specularFactor", Rgb.White);
        if (old.Has("specularGlossinessTexture"))
        {
            document.Notes.Add("a texture of specular colour and glossiness is left out");
        }

        // Dielectrics reflect at most some 17 % head-on (diamond); what reflects more is a metal, coloured by its reflection.
        bool isMetal = specular.Luminance > 0.25f && !old.Has("specularGlossinessTexture");
        (float r0, Rgb coat) = old.Has("specularGlossinessTexture") ? (0.04f, Rgb.White) : Split(specular);
        int uvSet = diffuse?.UvSet ?? 0;
        return new()
        {
            Color = isMetal ? textures.Colour(specular, null, 0) : textures.Colour(old.Color("diffuseFactor", Rgb.White, 4), diffuse, uvSet),
            UvSet = uvSet,
            Metallic = isMetal ? 1 : 0,
            Roughness = 1 - old.Fraction("glossinessFactor", 1),
            R0 = r0,
            CoatColor = coat,
        };
    }

    private static (float Largest, Rgb Color) Split(Rgb reflectance)
    {
        float largest = float.Max(reflectance.R, float.Max(reflectance.G, reflectance.B));
        return largest > 0 ? (float.Min(largest, 1), reflectance * (1 / largest)) : (0, Rgb.White);
    }
}
