using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes glass, and plastic: what has a refractive index.</summary>
internal sealed class MitsubaDielectrics(MitsubaTextures textures)
{
    private const float Air = 1.000277f;
    private const float Bk7 = 1.5046f;
    private const float Polypropylene = 1.49f;

    // By the names under which their documentation lists them.
    private static readonly Dictionary<string, float> s_indices = new()
    {
        ["vacuum"] = 1,
        ["helium"] = 1.000036f,
        ["hydrogen"] = 1.000132f,
        ["air"] = Air,
        ["carbon dioxide"] = 1.00045f,
        ["water"] = 1.333f,
        ["acetone"] = 1.36f,
        ["ethanol"] = 1.361f,
        ["carbon tetrachloride"] = 1.461f,
        ["glycerol"] = 1.4729f,
        ["benzene"] = 1.501f,
        ["silicone oil"] = 1.52045f,
        ["bromine"] = 1.661f,
        ["water ice"] = 1.31f,
        ["fused quartz"] = 1.458f,
        ["pyrex"] = 1.47f,
        ["acrylic glass"] = 1.49f,
        ["polypropylene"] = Polypropylene,
        ["bk7"] = Bk7,
        ["sodium chloride"] = 1.544f,
        ["amber"] = 1.55f,
        ["pet"] = 1.575f,
        ["diamond"] = 2.419f,
    };

    /// <summary>Smooth, rough or thin glass.</summary>
    public MaterialDescription Read(MitsubaObject bsdf)
    {
        float index = RelativeIndex(bsdf, Bk7);
        TextureDescription reflectance = textures.Read(bsdf, "specular_reflectance", Rgb.White);
        TextureDescription transmittance = textures.Read(bsdf, "specular_transmittance", Rgb.White);
        switch (bsdf.Type)
        {
            case "dielectric":
                return new DielectricMaterialDescription { RefractiveIndex = index, SpecularReflectance = reflectance, SpecularTransmittance = transmittance };
            case "thindielectric":
                return new ThinDielectricMaterialDescription { RefractiveIndex = index, SpecularReflectance = reflectance, SpecularTransmittance = transmittance };
            default:
                MitsubaRoughness rough = MitsubaRoughness.Read(bsdf, textures);
                return new RoughDielectricMaterialDescription
                {
                    RefractiveIndex = index,
                    SpecularReflectance = reflectance,
                    SpecularTransmittance = transmittance,
                    Distribution = rough.Distribution,
                    Alpha = rough.Alpha,
                    AlphaU = rough.AlphaU,
                    AlphaV = rough.AlphaV,
                };
        }
    }

    /// <summary>Smooth or rough plastic.</summary>
    public MaterialDescription Plastic(MitsubaObject bsdf)
    {
        PlasticMaterialDescription smooth = new()
        {
            Color = textures.Read(bsdf, "diffuse_reflectance", 0.5f),
            RefractiveIndex = RelativeIndex(bsdf, Polypropylene),
            Nonlinear = bsdf.Boolean("nonlinear", false),
            SpecularReflectance = textures.Read(bsdf, "specular_reflectance", Rgb.White),
        };
        if (bsdf.Type == "plastic")
        {
            return smooth;
        }

        MitsubaRoughness rough = MitsubaRoughness.Read(bsdf, textures);
        if (rough.AlphaU is not null || rough.Alpha is not SolidTextureDescription)
        {
            bsdf.Log.Error(bsdf.Place, "the roughness of a roughplastic must be one number here");
        }

        return new RoughPlasticMaterialDescription
        {
            Color = smooth.Color,
            RefractiveIndex = smooth.RefractiveIndex,
            Nonlinear = smooth.Nonlinear,
            SpecularReflectance = smooth.SpecularReflectance,
            Distribution = rough.Distribution,
            Alpha = rough.Alpha is SolidTextureDescription alpha ? alpha.Color.R : 0.1f,
        };
    }

    /// <summary>The refractive index of the inside relative to the outside.</summary>
    public static float RelativeIndex(MitsubaObject bsdf, float standard) => Index(bsdf, "int_ior", standard) / Index(bsdf, "ext_ior", Air);

    private static float Index(MitsubaObject bsdf, string name, float standard) =>
        bsdf.Property(name) is { Name: "string" } ? bsdf.Choice(name, standard, s_indices) : bsdf.Float(name, standard, 1e-3f);
}
