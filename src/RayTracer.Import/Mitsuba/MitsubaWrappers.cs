using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes embossed surfaces, and the material of many parameters.</summary>
internal sealed class MitsubaWrappers(ImportReading reading, MitsubaTextures textures)
{
    private static readonly Rgb s_half = new(0.5f, 0.5f, 0.5f);

    /// <summary>A surface whose normals come from a picture.</summary>
    /// <param name="bsdf">The BSDF.</param>
    /// <param name="inner">The material that scatters light.</param>
    public MaterialDescription NormalMap(MitsubaObject bsdf, MaterialDescription inner)
    {
        TurnedNormal turned = Turned(bsdf);
        bool isSoftened = bsdf.Boolean("use_shadowing_function", true);
        if (bsdf.Child("texture", "normalmap") is not { } map)
        {
            reading.Log.Error(bsdf.Place, "a normalmap needs a texture named \"normalmap\"");
            return inner;
        }

        return new NormalMapMaterialDescription { Map = textures.Read(map), Turned = turned, SoftensShadow = isSoftened, Material = inner };
    }

    /// <summary>A surface whose heights come from a picture.</summary>
    /// <param name="bsdf">The BSDF.</param>
    /// <param name="inner">The material that scatters light.</param>
    public MaterialDescription BumpMap(MitsubaObject bsdf, MaterialDescription inner)
    {
        float scale = bsdf.Float("scale", 1);
        TurnedNormal turned = Turned(bsdf);
        bool isSoftened = bsdf.Boolean("use_shadowing_function", true);
        if (bsdf.Only("texture") is not { } map)
        {
            reading.Log.Error(bsdf.Place, "a bumpmap needs a texture");
            return inner;
        }

        return new BumpMapMaterialDescription { Map = textures.Number(map), Scale = scale, Turned = turned, SoftensShadow = isSoftened, Material = inner };
    }

    /// <summary>The material of Disney's parameters.</summary>
    public PrincipledMaterialDescription Principled(MitsubaObject bsdf)
    {
        bsdf.Ignore("diffuse_reflectance_sampling_rate", "specular_sampling_rate", "main_specular_sampling_rate", "clearcoat_sampling_rate");
        if (bsdf.Has("eta") && bsdf.Has("specular"))
        {
            bsdf.Ignore("specular");
            reading.Log.Error(bsdf.PlaceOf("eta"), "either \"eta\" or \"specular\" may be given, but not both");
        }

        return new()
        {
            BaseColor = textures.Read(bsdf, "base_color", s_half),
            Roughness = textures.Read(bsdf, "roughness", 0.5f),
            Anisotropic = textures.Read(bsdf, "anisotropic", 0f),
            Metallic = textures.Read(bsdf, "metallic", 0f),
            Transmission = textures.Read(bsdf, "spec_trans", 0f),
            RefractiveIndex = bsdf.Has("eta") ? bsdf.Float("eta", 1.5f, 1.001f, 10) : null,
            Specular = bsdf.Has("eta") ? null : bsdf.Float("specular", 0.5f, 0, 1),
            SpecularTint = textures.Read(bsdf, "spec_tint", 0f),
            Sheen = textures.Read(bsdf, "sheen", 0f),
            SheenTint = textures.Read(bsdf, "sheen_tint", 0f),
            Flatness = textures.Read(bsdf, "flatness", 0f),
            Clearcoat = textures.Read(bsdf, "clearcoat", 0f),
            ClearcoatRoughness = Gloss(bsdf),
        };
    }

    /// <summary>The sheet of Disney's parameters.</summary>
    public ThinPrincipledMaterialDescription ThinPrincipled(MitsubaObject bsdf)
    {
        bsdf.Ignore(
            "diffuse_reflectance_sampling_rate", "diffuse_transmittance_sampling_rate", "specular_reflectance_sampling_rate", "specular_transmittance_sampling_rate");
        return new()
        {
            BaseColor = textures.Read(bsdf, "base_color", s_half),
            Roughness = textures.Read(bsdf, "roughness", 0.5f),
            Anisotropic = textures.Read(bsdf, "anisotropic", 0f),
            Transmission = textures.Read(bsdf, "spec_trans", 0f),
            DiffuseTransmission = Half(textures.Read(bsdf, "diff_trans", 0f, 2)),
            RefractiveIndex = textures.Read(bsdf, "eta", 1.5f, 10),
            SpecularTint = textures.Read(bsdf, "spec_tint", 0f),
            Sheen = textures.Read(bsdf, "sheen", 0f),
            SheenTint = textures.Read(bsdf, "sheen_tint", 0f),
            Flatness = textures.Read(bsdf, "flatness", 0f),
        };
    }

    // What goes from 0 to 2 there goes from 0 to 1 here.
    private static TextureDescription Half(TextureDescription texture) =>
        texture is SolidTextureDescription { Color: var whole } ? MaterialTextures.Solid(whole * 0.5f) : new ProductTextureDescription { First = texture, Second = MaterialTextures.Solid(0.5f) };

    private static TurnedNormal Turned(MitsubaObject bsdf) => bsdf.Boolean("flip_invalid_normals", true) ? TurnedNormal.Flip : TurnedNormal.Back;

    // What is gloss there is the absence of roughness here.
    private TextureDescription Gloss(MitsubaObject bsdf)
    {
        TextureDescription gloss = textures.Read(bsdf, "clearcoat_gloss", 0f);
        if (gloss is SolidTextureDescription { Color.R: var value })
        {
            return MaterialTextures.Solid(new Rgb(1 - value, 1 - value, 1 - value));
        }

        reading.Log.Unsupported(bsdf.PlaceOf("clearcoat_gloss"), "\"clearcoat_gloss\" must be one number here", "a sharp coat is used instead");
        return MaterialTextures.Solid(Rgb.Black);
    }
}
