using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>A material of an MTL file, and how it is shown here: by the nearest of our materials.</summary>
internal sealed class MtlMaterial
{
    private const float GlassIndex = 1.5f;

    /// <summary>Kd: what is reflected by a matt surface.</summary>
    public Rgb Diffuse { get; set; } = new(0.8f, 0.8f, 0.8f);

    /// <summary>Ks: what is reflected by a shining one.</summary>
    public Rgb Specular { get; set; }

    /// <summary>Ke: what it radiates.</summary>
    public Rgb Emission { get; set; }

    /// <summary>Ns: how sharp the reflection is.</summary>
    public float Exponent { get; set; }

    /// <summary>Ni: refractive index.</summary>
    public float RefractiveIndex { get; set; } = 1;

    /// <summary>d: 1 for opaque, 0 for clear; null where it is not said.</summary>
    public float? Opacity { get; set; }

    /// <summary>Tr: the complement of d, where that is not said.</summary>
    public float Transparency { get; set; }

    /// <summary>illum: which of ten ways of lighting is meant; null where it is not said.</summary>
    public int? Illumination { get; set; }

    /// <summary>Pr: roughness; null where only <see cref="Exponent"/> gives it.</summary>
    public float? Roughness { get; set; }

    /// <summary>Pm: 1 for metal.</summary>
    public float? Metallic { get; set; }

    /// <summary>Ps: light at grazing angles.</summary>
    public float Sheen { get; set; }

    /// <summary>Pc: a coat.</summary>
    public float Clearcoat { get; set; }

    /// <summary>Pcr: the coat's roughness.</summary>
    public float ClearcoatRoughness { get; set; }

    /// <summary>aniso.</summary>
    public float Anisotropic { get; set; }

    /// <summary>The pictures, by their keywords without case.</summary>
    public Dictionary<string, ImageTextureDescription> Pictures { get; } = new(StringComparer.OrdinalIgnoreCase);

    /// <summary>-bm of bump: a factor on its heights.</summary>
    public float BumpScale { get; set; } = 1;

    /// <summary>The nearest of our materials.</summary>
    /// <param name="notes">Receives what is only approximated.</param>
    public MaterialDescription ToDescription(ISet<string> notes)
    {
        MaterialDescription surface = CutOut(Embossed(IsGlass ? Glass(notes) : Reflecting(notes)));
        ImageTextureDescription? emission = Picture("map_Ke");
        if (Emission.IsBlack && emission is null)
        {
            return surface;
        }

        notes.Add("emission (Ke) becomes a luminaire with Ke as its radiance, on the side that the normal points to");
        TextureDescription color = emission is null ? Solid(Emission, float.MaxValue) : Product(emission, Emission.IsBlack ? Rgb.White : Emission, float.MaxValue);
        return new LuminaireMaterialDescription { Color = color, Material = surface };
    }

    // Ways 4, 6, 7 and 9 of lighting are those of glass.
    private bool IsGlass => Illumination is 4 or 6 or 7 or 9;

    private DielectricMaterialDescription Glass(ISet<string> notes)
    {
        notes.Add("transparency (illum 4, 6, 7 or 9) becomes clear glass of index Ni");
        return new() { RefractiveIndex = RefractiveIndex is > 1 and <= 100 ? RefractiveIndex : GlassIndex };
    }

    private MaterialDescription Reflecting(ISet<string> notes)
    {
        TextureDescription color = Picture("map_Kd") is { } picture ? Product(picture, Diffuse.IsBlack ? Rgb.White : Diffuse, 1) : Solid(Diffuse, 1);
        float strength = Limited(float.Max(Specular.R, float.Max(Specular.G, Specular.B)), 1);
        bool hasRoughness = Roughness is not null || Picture("map_Pr") is not null;
        bool isPhysical = hasRoughness || Metallic is not null || Picture("map_Pm") is not null || Sheen > 0 || Clearcoat > 0;
        if (!isPhysical && (strength == 0 || Illumination is 0 or 1))
        {
            return new DiffuseMaterialDescription { Color = color };
        }

        if (!isPhysical)
        {
            notes.Add("highlights (Ks, Ns) become principled: a metal where Kd is black, else with Ks as its specular, and with α² = 2/(Ns + 2)");
        }

        // Microfacets of this α are spread as cosⁿ with n = 2/α² − 2 (Walter et al. 2007, section 5.2), and roughness is the root of α.
        bool isMetal = !isPhysical && Diffuse.IsBlack && Picture("map_Kd") is null;
        return new PrincipledMaterialDescription
        {
            BaseColor = isMetal ? Solid(Specular, 1) : color,
            Metallic = isMetal ? Number(1) : Number(Metallic, "map_Pm", 0),
            Roughness = hasRoughness ? Number(Roughness, "map_Pr", 0.5f) : Number(float.Sqrt(float.Sqrt(2 / (Limited(Exponent, 1e12f) + 2)))),
            Specular = strength > 0 ? strength : null,
            Sheen = Number(Sheen, "map_Ps", 0),
            Clearcoat = Number(Clearcoat),
            ClearcoatRoughness = Number(ClearcoatRoughness),
            Anisotropic = Number(Anisotropic),
        };
    }

    // norm is a map of normals, bump one of heights.
    private MaterialDescription Embossed(MaterialDescription inner)
    {
        if (Picture("norm") is { } normals)
        {
            return new NormalMapMaterialDescription { Map = normals with { Raw = true }, GreenAlongV = true, Material = inner };
        }

        return (Picture("map_Bump") ?? Picture("bump")) is { } heights
            ? new BumpMapMaterialDescription { Map = heights with { Raw = true }, Scale = BumpScale, Material = inner }
            : inner;
    }

    private MaterialDescription CutOut(MaterialDescription inner)
    {
        float opacity = IsGlass ? 1 : Limited(Opacity ?? 1 - Transparency, 1);
        return opacity == 1 && Picture("map_d") is null
            ? inner
            : new MaskMaterialDescription { Material = inner, Opacity = Picture("map_d") is { } picture ? Product(picture with { Raw = true }, new(opacity, opacity, opacity), 1) : Number(opacity) };
    }

    private ImageTextureDescription? Picture(string keyword) => Pictures.GetValueOrDefault(keyword);

    // A picture takes the place of its number where that is not given, or 0.
    private TextureDescription Number(float? value, string picture, float otherwise) => Picture(picture) is { } image
        ? Product(image with { Raw = true }, value is > 0 ? new(value.Value, value.Value, value.Value) : Rgb.White, 1)
        : Number(value ?? otherwise);

    private static TextureDescription Number(float value) => Solid(new(value, value, value), 1);

    private static TextureDescription Product(ImageTextureDescription picture, Rgb factor, float most) => factor == Rgb.White
        ? picture
        : new ProductTextureDescription { First = picture, Second = Solid(factor, most) };

    private static TextureDescription Solid(Rgb color, float most) => new SolidTextureDescription { Color = new(Limited(color.R, most), Limited(color.G, most), Limited(color.B, most)) };

    private static float Limited(float value, float most) => value > 0 ? float.Min(value, most) : 0;
}
