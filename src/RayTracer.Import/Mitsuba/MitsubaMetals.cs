using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Makes metals.</summary>
internal sealed class MitsubaMetals(MitsubaTextures textures)
{
    private static readonly Dictionary<string, Metal> s_names = """
        none None, Ag Silver, Al Aluminium, Au Gold, Be Beryllium, Cr Chromium, Cu Copper, Hg Mercury, Ir Iridium,
        K Potassium, Li Lithium, Mo Molybdenum, Na_palik Sodium, Nb Niobium, Ni_palik Nickel, Rh Rhodium, Ta Tantalum,
        TiN TitaniumNitride, V_palik Vanadium, W Tungsten
        """.Split([',', '\n', '\r'], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries)
        .Select(entry => entry.Split(' ')).ToDictionary(words => words[0], words => Enum.Parse<Metal>(words[1]));

    /// <summary>A smooth or rough metal.</summary>
    public MaterialDescription Read(MitsubaObject bsdf)
    {
        (Metal? name, Rgb? eta, Rgb? k) = Index(bsdf);
        TextureDescription factor = textures.Read(bsdf, "specular_reflectance", Rgb.White);
        if (bsdf.Type == "conductor")
        {
            return new ConductorMaterialDescription { Metal = name, Eta = eta, K = k, SpecularReflectance = factor };
        }

        MitsubaRoughness rough = MitsubaRoughness.Read(bsdf, textures);
        return new RoughConductorMaterialDescription
        {
            Metal = name,
            Eta = eta,
            K = k,
            SpecularReflectance = factor,
            Distribution = rough.Distribution,
            Alpha = rough.Alpha,
            AlphaU = rough.AlphaU,
            AlphaV = rough.AlphaV,
        };
    }

    private static (Metal? Name, Rgb? Eta, Rgb? K) Index(MitsubaObject bsdf)
    {
        bsdf.Ignore("eta", "k", "material");
        if (bsdf.Has("material") && bsdf.Has("eta"))
        {
            bsdf.Log.Error(bsdf.PlaceOf("eta"), "either \"material\" or \"eta\" and \"k\" may be given, but not both");
        }

        if (bsdf.Has("material"))
        {
            return (bsdf.Choice("material", Metal.None, s_names), null, null);
        }

        bool hasEta = bsdf.Has("eta") || bsdf.HasChild("eta");
        bool hasK = bsdf.Has("k") || bsdf.HasChild("k");
        if (hasEta != hasK)
        {
            bsdf.Log.Error(bsdf.Place, $"{bsdf.Describe()} needs both \"eta\" and \"k\", or neither");
        }

        return hasEta && hasK ? (null, MitsubaColors.Read(bsdf, "eta", Rgb.White), MitsubaColors.Read(bsdf, "k", Rgb.Black)) : (Metal.None, null, null);
    }
}
