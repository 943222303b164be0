using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>A material of an MTL file, and how it is shown here: by the nearest of our materials.</summary>
internal sealed class MtlMaterial
{
    private const float LargestExponent = 1e6f;
    private const float GlassIndex = 1.5f;
    private const float MostOpaqueGlass = 0.5f;

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

    /// <summary>map_Kd.</summary>
    public ImageTextureDescription? DiffusePicture { get; set; }

    /// <summary>map_Ke.</summary>
    public ImageTextureDescription? EmissionPicture { get; set; }

    /// <summary>The nearest of our materials.</summary>
    /// <param name="notes">Receives what is only approximated.</param>
    public MaterialDescription ToDescription(ISet<string> notes)
    {
        MaterialDescription surface = IsGlass(notes) ? Glass() : Reflecting(notes);
        if (Emission.IsBlack && EmissionPicture is null)
        {
            return surface;
        }

        notes.Add("what radiates (Ke) does so as a luminaire, with Ke as its radiance, on the side that its normal points to");
        return new LuminaireMaterialDescription { Color = EmissionPicture ?? Solid(Emission, float.MaxValue), Material = surface };
    }

    // Ways 4, 6, 7 and 9 of lighting are those of glass; others may be more or less transparent, which we do not have.
    private bool IsGlass(ISet<string> notes)
    {
        float opacity = Opacity ?? 1 - Transparency;
        bool isGlass = Illumination is 4 or 6 or 7 or 9 || opacity <= MostOpaqueGlass;
        if (isGlass)
        {
            notes.Add("what is transparent (illum 4, 6, 7 or 9; or d of at most 0.5) is shown as clear glass of index Ni");
        }
        else if (opacity < 1)
        {
            notes.Add("what is a little transparent (d above 0.5) is shown as opaque");
        }

        return isGlass;
    }

    private DielectricMaterialDescription Glass() => new() { RefractiveIndex = RefractiveIndex is > 1 and <= 100 ? RefractiveIndex : GlassIndex };

    private MaterialDescription Reflecting(ISet<string> notes)
    {
        if (DiffusePicture is not null && Diffuse != Rgb.White && !Diffuse.IsBlack)
        {
            notes.Add("pictures (map_Kd) take the place of colours (Kd), and are not multiplied by them");
        }

        DiffuseMaterialDescription matt = new() { Color = DiffusePicture ?? Solid(Diffuse, 1) };
        float strength = float.Min(1, float.Max(Specular.R, float.Max(Specular.G, Specular.B)));
        if (!(strength > 0) || Illumination is 0 or 1)
        {
            return matt;
        }

        notes.Add("what shines (Ks, Ns) reflects like a Phong metal, alone where Kd is black, else as a coat over the matt surface");
        bool isMetal = Diffuse.IsBlack && DiffusePicture is null;
        TextureDescription color = Solid(isMetal ? Specular : Specular * (1 / strength), 1);
        PhongMetalMaterialDescription metal = new() { Color = color, Exponent = Limited(Exponent, LargestExponent) };
        return isMetal ? metal : new DiffuseSpecularMaterialDescription { Diffuse = matt, Specular = metal, R0 = strength };
    }

    private static TextureDescription Solid(Rgb color, float most) => new SolidTextureDescription { Color = new(Limited(color.R, most), Limited(color.G, most), Limited(color.B, most)) };

    private static float Limited(float value, float most) => value > 0 ? float.Min(value, most) : 0;
}
