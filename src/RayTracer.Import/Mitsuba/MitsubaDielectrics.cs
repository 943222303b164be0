using System.Globalization;
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
    private static readonly Dictionary<string, float> s_indices = """
        vacuum 1, helium 1.000036, hydrogen 1.000132, air 1.000277, carbon dioxide 1.00045, water 1.333, acetone 1.36,
        ethanol 1.361, carbon tetrachloride 1.461, glycerol 1.4729, benzene 1.501, silicone oil 1.52045, bromine 1.661,
        water ice 1.31, fused quartz 1.458, pyrex 1.47, acrylic glass 1.49, polypropylene 1.49, bk7 1.5046,
        sodium chloride 1.544, amber 1.55, pet 1.575, diamond 2.419
        """.Split([',', '\n', '\r'], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)
        .ToDictionary(entry => entry[..entry.LastIndexOf(' ')], entry => float.Parse(entry[entry.LastIndexOf(' ')..], CultureInfo.InvariantCulture));

    /// <summary>Smooth, rough or thin glass.</summary>
    public MaterialDescription Read(MitsubaObject bsdf)
    {
        float index = RelativeIndex(bsdf, Bk7);
        TextureDescription factor = textures.Read(bsdf, "specular_reflectance", Rgb.White);
        TextureDescription through = textures.Read(bsdf, "specular_transmittance", Rgb.White);
        return bsdf.Type switch
        {
            "dielectric" => new DielectricMaterialDescription { RefractiveIndex = index, SpecularReflectance = factor, SpecularTransmittance = through },
            "thindielectric" => new ThinDielectricMaterialDescription { RefractiveIndex = index, SpecularReflectance = factor, SpecularTransmittance = through },
            _ => Rough(MitsubaRoughness.Read(bsdf, textures), index, factor, through),
        };
    }

    private static RoughDielectricMaterialDescription Rough(MitsubaRoughness rough, float index, TextureDescription factor, TextureDescription through) => new()
    {
        RefractiveIndex = index,
        SpecularReflectance = factor,
        SpecularTransmittance = through,
        Distribution = rough.Distribution,
        Alpha = rough.Alpha,
        AlphaU = rough.AlphaU,
        AlphaV = rough.AlphaV,
    };

    /// <summary>Smooth or rough plastic.</summary>
    public MaterialDescription Plastic(MitsubaObject bsdf)
    {
        PlasticMaterialDescription smooth = new()
        {
            Color = textures.Read(bsdf, "diffuse_reflectance", new Rgb(0.5f, 0.5f, 0.5f)),
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
            bsdf.Log.Unsupported(bsdf.Place, "the roughness of a roughplastic must be one number here", "0.1 is used instead");
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
