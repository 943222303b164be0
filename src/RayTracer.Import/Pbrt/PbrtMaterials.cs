using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes materials. What reflects does so on both sides.</summary>
internal sealed class PbrtMaterials(ImportReading reading, PbrtWorld world, PbrtTextures textures)
{
    private const float Glass = 1.5f;

    // What a metal may have here; it reflects 0.9996.
    private const float MostAbsorption = 100;

    // Below this, surfaces are mirrors.
    private const float SmoothAlpha = 1e-3f;

    private static readonly string[] s_types =
        ["diffuse", "conductor", "dielectric", "thindielectric", "coateddiffuse", "coatedconductor", "diffusetransmission", "mix", "interface"];

    private readonly Dictionary<PbrtThing, MaterialDescription> _made = [];
    private readonly HashSet<PbrtThing> _open = [];

    /// <summary>The material of surfaces that give none.</summary>
    public static MaterialDescription Standard { get; } = new DiffuseMaterialDescription { Color = MaterialTextures.Solid(0.5f) };

    /// <summary>The material of what is not supported.</summary>
    public static MaterialDescription Magenta { get; } = new DiffuseMaterialDescription { Color = MaterialTextures.Solid(new Rgb(1, 0, 1)) };

    /// <summary>The materials that have names.</summary>
    public Dictionary<string, MaterialDescription> Named { get; } = new(StringComparer.Ordinal);

    /// <summary>Reads all materials that have names.</summary>
    public void ReadAll()
    {
        foreach ((string name, PbrtThing material) in world.Materials)
        {
            Named[name] = Read(material);
        }
    }

    /// <summary>The material that holds where something stands.</summary>
    public MaterialDescription Of(PbrtState state)
    {
        if (state.MaterialName.Length == 0)
        {
            return state.Material is { } material ? Read(material) : Standard;
        }

        if (state.MaterialName is "interface" && !world.Materials.ContainsKey(state.MaterialName))
        {
            return new InvisibleMaterialDescription();
        }

        return Find(state.MaterialName, state.MaterialPlace);
    }

    private MaterialDescription Find(string name, Scenes.SourcePlace place)
    {
        if (world.Materials.TryGetValue(name, out PbrtThing? named))
        {
            return Read(named);
        }

        reading.Log.Unknown(place, $"there is no material {Quotation.Of(name)}", name, world.Materials.Keys);
        return Standard;
    }

    private MaterialDescription Read(PbrtThing material)
    {
        if (_made.TryGetValue(material, out MaterialDescription? made))
        {
            return made;
        }

        if (!_open.Add(material) || _open.Count > 16)
        {
            reading.Log.Error(material.Place, "the material consists of itself, or of more than 16 others one within the other");
            return Standard;
        }

        made = reading.At(material.Place, Make(material));
        material.Finish();
        _made.Add(material, made);
        _open.Remove(material);
        return made;
    }

    private MaterialDescription Make(PbrtThing material) => material.Type switch
    {
        "diffuse" => Uneven(material, new DiffuseMaterialDescription { Color = textures.Color(material, "reflectance", new Rgb(0.5f, 0.5f, 0.5f)) }),
        "conductor" => Uneven(material, Conductor(material)),
        "dielectric" => Uneven(material, Dielectric(material)),
        "thindielectric" => Uneven(material, new ThinDielectricMaterialDescription { RefractiveIndex = Index(material) }),
        "coateddiffuse" => Uneven(material, PbrtCoats.Diffuse(material, textures, Alpha(material))),
        "coatedconductor" => Uneven(material, PbrtCoats.Conductor(material, Conductor(material, "conductor."), Alpha(material, "interface."), Alpha(material, "conductor."))),
        "diffusetransmission" => Uneven(material, Translucent(material)),
        "mix" => Mix(material),
        "interface" or "" or "none" => new InvisibleMaterialDescription(),
        _ => Unknown(material),
    };

    private static MaterialDescription Unknown(PbrtThing material)
    {
        material.UnknownType(s_types);
        return Magenta;
    }

    // With the bumps that all materials may have.
    private MaterialDescription Uneven(PbrtThing material, MaterialDescription made)
    {
        if (textures.Float(material, "displacement") is { } heights)
        {
            made = new BumpMapMaterialDescription { Map = heights, Material = reading.At(material.Place, made) };
        }

        return material.Has("normalmap") && material.FileName("normalmap") is { } file
            ? new NormalMapMaterialDescription { Map = reading.At(material.Place, new ImageTextureDescription { File = file, Raw = true }), Material = reading.At(material.Place, made) }
            : made;
    }

    private MixMaterialDescription Mix(PbrtThing material)
    {
        PbrtParameter? names = material.Parameter("materials");
        if (names is not { Type: "string", Words: [_, _] })
        {
            reading.Log.Error(material.PlaceOf("materials"), "a mix needs two names of materials, \"string materials\"");
            return new() { First = Standard, Second = Standard };
        }

        return new()
        {
            First = Find(names.Words[0], names.Place),
            Second = Find(names.Words[1], names.Place),
            Weight = textures.Float(material, "amount") ?? MaterialTextures.Solid(0.5f),
        };
    }

    private TranslucentMaterialDescription Translucent(PbrtThing material)
    {
        Rgb quarter = new(0.25f, 0.25f, 0.25f);
        float scale = material.Float("scale", 1, 0);
        TextureDescription Scaled(string name) => textures.Color(material, name, quarter) switch
        {
            var texture when scale == 1 => texture,
            SolidTextureDescription solid => MaterialTextures.Solid(solid.Color * scale),
            var texture => new ProductTextureDescription { First = texture, Second = MaterialTextures.Solid(scale) },
        };
        return new() { Color = Scaled("reflectance"), Transmittance = Scaled("transmittance") };
    }

    private MetalDescription Conductor(PbrtThing material, string prefix = "")
    {
        (TextureDescription u, TextureDescription v) = Alpha(material, prefix);
        (Metal? metal, Rgb? eta, Rgb? k, TextureDescription factor) = Substance(material, prefix + "eta", prefix + "k");
        return IsSmooth(u) && IsSmooth(v)
            ? new ConductorMaterialDescription { Metal = metal, Eta = eta, K = k, SpecularReflectance = factor }
            : new RoughConductorMaterialDescription { Metal = metal, Eta = eta, K = k, SpecularReflectance = factor, Alpha = u, AlphaU = u == v ? null : u, AlphaV = u == v ? null : v };
    }

    // A metal by its name or numbers, or whatever reflects so much when seen head-on.
    private (Metal? Metal, Rgb? Eta, Rgb? K, TextureDescription Factor) Substance(PbrtThing material, string etaName, string kName)
    {
        TextureDescription white = MaterialTextures.Solid(Rgb.White);
        if (material.Has("reflectance"))
        {
            material.Ignore(etaName, kName);
            if (material.Has(etaName) || material.Has(kName))
            {
                reading.Log.Error(material.PlaceOf("reflectance"), $"either \"reflectance\" or \"{etaName}\" and \"{kName}\" may be given, but not both");
            }

            // pbrt takes 1 for eta, and of k what gives the reflectance: k = 2 √r / √(1 − r).
            if (textures.Color(material, "reflectance", Rgb.White) is SolidTextureDescription solid)
            {
                return solid.Color == Rgb.White ? (Metal.None, null, null, white)
                    : (null, Rgb.White, new(Absorption(solid.Color.R), Absorption(solid.Color.G), Absorption(solid.Color.B)), white);
            }

            reading.Log.Unsupported(material.PlaceOf("reflectance"), "the reflectance of a metal must be one colour here", "it is a factor on a perfect mirror");
            return (Metal.None, null, null, textures.Color(material, "reflectance", Rgb.White));
        }

        (string? eta, string? k) = (PbrtColors.NameOf(material, etaName), PbrtColors.NameOf(material, kName));
        string of = MetalOf(eta, "-eta") ?? (material.Has(etaName) ? "" : "Cu");
        string ofK = MetalOf(k, "-k") ?? (material.Has(kName) ? "" : "Cu");
        if (of == ofK && PbrtSpectra.Metals.TryGetValue(of, out Metal metal))
        {
            material.Ignore(etaName, kName);
            return (metal, null, null, white);
        }

        return (null, Limited(PbrtColors.Read(material, etaName, new(0.2f, 0.92f, 1.1f))), PbrtColors.Read(material, kName, new(3.91f, 2.45f, 2.14f)), white);
    }

    private static string? MetalOf(string? name, string end) =>
        name is not null && name.StartsWith("metal-", StringComparison.Ordinal) && name.EndsWith(end, StringComparison.Ordinal) ? name["metal-".Length..^end.Length] : null;

    private static float Absorption(float reflectance) => float.Min(2 * float.Sqrt(reflectance) / float.Sqrt(1 - float.Min(reflectance, 0.9999f)), MostAbsorption);

    private static Rgb Limited(Rgb eta) => new(float.Max(eta.R, 1e-3f), float.Max(eta.G, 1e-3f), float.Max(eta.B, 1e-3f));

    private GlassDescription Dielectric(PbrtThing material)
    {
        (TextureDescription u, TextureDescription v) = Alpha(material);
        Glass? glass = PbrtColors.NameOf(material, "eta") is { } name && PbrtSpectra.Glasses.TryGetValue(name, out Glass known) ? known : null;
        float index = glass is null ? Index(material) : Glass;
        return IsSmooth(u) && IsSmooth(v)
            ? new DielectricMaterialDescription { RefractiveIndex = index, Glass = glass }
            : new RoughDielectricMaterialDescription { RefractiveIndex = index, Glass = glass, Alpha = u, AlphaU = u == v ? null : u, AlphaV = u == v ? null : v };
    }

    private float Index(PbrtThing material)
    {
        if (PbrtColors.NameOf(material, "eta") is { } name)
        {
            reading.Log.Unsupported(
                material.PlaceOf("eta"), $"the spectrum {Quotation.Of(name)} is not read for \"eta\"{ImportLog.Hint(name, PbrtSpectra.Glasses.Keys)}", "1.5 is used instead");
            return Glass;
        }

        if (material.Parameter("eta") is { Type: not "float" } parameter)
        {
            reading.Log.Unsupported(parameter.Place, "a refractive index is one number here, or the name of a glass", "1.5 is used instead");
            return Glass;
        }

        return material.Float("eta", Glass, 1e-3f, 100);
    }

    // The alphas along u and v: of roughness the square root, unless it is said that they are alphas already.
    private (TextureDescription U, TextureDescription V) Alpha(PbrtThing material, string prefix = "")
    {
        bool isRemapped = material.Boolean("remaproughness", true);
        TextureDescription both = Alpha(material, prefix + "roughness", isRemapped) ?? MaterialTextures.Solid(0);
        TextureDescription u = Alpha(material, prefix + "uroughness", isRemapped) ?? both;
        TextureDescription v = Alpha(material, prefix + "vroughness", isRemapped) ?? both;
        return u is SolidTextureDescription { Color: var a } && v is SolidTextureDescription { Color: var b } && a == b ? (u, u) : (u, v);
    }

    private TextureDescription? Alpha(PbrtThing material, string name, bool isRemapped)
    {
        switch (textures.Float(material, name))
        {
            case null:
                return null;
            case SolidTextureDescription { Color.R: var roughness }:
                return MaterialTextures.Solid(isRemapped ? float.Sqrt(float.Max(roughness, 0)) : float.Max(roughness, 0));
            case var texture when isRemapped:
                reading.Log.Unsupported(material.PlaceOf(name), "a texture of roughness is read with \"bool remaproughness\" false only", "it is taken for alpha");
                return texture;
            case var texture:
                return texture;
        }
    }

    private static bool IsSmooth(TextureDescription alpha) => alpha is SolidTextureDescription { Color.R: < SmoothAlpha };
}
