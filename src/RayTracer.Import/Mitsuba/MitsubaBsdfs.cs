using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes materials. What reflects does so on its front only, unless it is within <c>twosided</c>.</summary>
internal sealed class MitsubaBsdfs(ImportReading reading, MitsubaTextures textures)
{
    private static readonly Rgb s_half = new(0.5f, 0.5f, 0.5f);

    private readonly Dictionary<(MitsubaObject Bsdf, bool IsTwoSided), MaterialDescription> _made = [];
    private readonly MitsubaMetals _metals = new(textures);
    private readonly MitsubaDielectrics _dielectrics = new(textures);
    private readonly MitsubaWrappers _wrappers = new(reading, textures);

    /// <summary>The material of surfaces that give none.</summary>
    public static MaterialDescription Standard { get; } =
        new OneSidedMaterialDescription { Material = new DiffuseMaterialDescription { Color = MaterialTextures.Solid(s_half) } };

    /// <summary>The material of emitting surfaces that give none.</summary>
    public static MaterialDescription Black { get; } = new DiffuseMaterialDescription { Color = MaterialTextures.Solid(Rgb.Black) };

    /// <summary>The material of what is not supported.</summary>
    public static MaterialDescription Magenta { get; } = new DiffuseMaterialDescription { Color = MaterialTextures.Solid(new Rgb(1, 0, 1)) };

    /// <summary>True where the integrator shows media: then boundaries of nothing do not count as edges of paths.</summary>
    public bool IsVolumetric { get; set; }

    /// <summary>The materials that have names.</summary>
    public Dictionary<string, MaterialDescription> Named { get; } = new(StringComparer.Ordinal);

    /// <summary>The material that a thing is.</summary>
    /// <param name="bsdf">The thing.</param>
    /// <param name="isTwoSided">True where it is seen from both sides.</param>
    public MaterialDescription Read(MitsubaObject bsdf, bool isTwoSided = false)
    {
        if (_made.TryGetValue((bsdf, isTwoSided), out MaterialDescription? made))
        {
            return made;
        }

        made = reading.At(bsdf.Place, Make(bsdf, isTwoSided));
        bsdf.Finish();
        _made.Add((bsdf, isTwoSided), made);
        if (bsdf.Id.Length > 0)
        {
            Named[isTwoSided ? $"{bsdf.Id} (two-sided)" : bsdf.Id] = made;
        }

        return made;
    }

    private MaterialDescription Make(MitsubaObject bsdf, bool isTwoSided) => bsdf.Type switch
    {
        "diffuse" => Sided(bsdf, new DiffuseMaterialDescription { Color = textures.Read(bsdf, "reflectance", s_half) }, isTwoSided),
        "conductor" or "roughconductor" => Sided(bsdf, _metals.Read(bsdf), isTwoSided),
        "plastic" or "roughplastic" => Sided(bsdf, _dielectrics.Plastic(bsdf), isTwoSided),
        "dielectric" or "thindielectric" or "roughdielectric" => _dielectrics.Read(bsdf),
        "principled" => Principled(bsdf, _wrappers.Principled(bsdf), isTwoSided),
        "principledthin" => _wrappers.ThinPrincipled(bsdf),
        "twosided" => OfSides(Inner(bsdf, 1, 2, isTwoSided: true)),
        "mask" => new MaskMaterialDescription { Opacity = textures.Read(bsdf, "opacity", 0.5f), Material = Inner(bsdf, 1, 1, isTwoSided)[0] },
        "blendbsdf" => Mixed(textures.Read(bsdf, "weight", 0.5f), Inner(bsdf, 2, 2, isTwoSided)),
        "normalmap" => _wrappers.NormalMap(bsdf, Inner(bsdf, 1, 1, isTwoSided)[0]),
        "bumpmap" => _wrappers.BumpMap(bsdf, Inner(bsdf, 1, 1, isTwoSided)[0]),
        "null" => IsVolumetric ? new InvisibleMaterialDescription() : new MaskMaterialDescription { Opacity = MaterialTextures.Solid(Rgb.Black) },
        _ => Unknown(bsdf),
    };

    private MaterialDescription Principled(MitsubaObject bsdf, PrincipledMaterialDescription made, bool isTwoSided) =>
        made.Transmission is SolidTextureDescription { Color.R: 0 } ? Sided(bsdf, made, isTwoSided) : made;

    private static MaterialDescription OfSides(MaterialDescription[] sides) =>
        sides.Length == 1 ? sides[0] : new TwoSidedMaterialDescription { Front = sides[0], Back = sides[1] };

    private static MixMaterialDescription Mixed(TextureDescription weight, MaterialDescription[] parts) => new() { First = parts[0], Second = parts[1], Weight = weight };

    private static MaterialDescription Unknown(MitsubaObject bsdf)
    {
        bsdf.UnknownType(
            "BSDFs", "diffuse", "conductor", "roughconductor", "plastic", "roughplastic", "dielectric", "thindielectric", "roughdielectric",
            "principled", "principledthin", "twosided", "mask", "blendbsdf", "normalmap", "bumpmap", "null");
        return bsdf.Log.IsLenient ? Magenta : Standard;
    }

    private MaterialDescription[] Inner(MitsubaObject bsdf, int least, int most, bool isTwoSided)
    {
        MitsubaObject[] inner = [.. bsdf.Children("bsdf")];
        if (inner.Length < least || inner.Length > most)
        {
            if (!bsdf.LacksSomething)
            {
                string wanted = least == most ? $"{least}" : $"{least} or {most}";
                reading.Log.Error(bsdf.Place, $"{bsdf.Describe()} needs {wanted} BSDFs within it, but has {inner.Length}");
            }

            return [.. Enumerable.Repeat(Standard, least)];
        }

        return [.. inner.Select(b => Read(b, isTwoSided))];
    }

    // Black is black from both sides.
    private MaterialDescription Sided(MitsubaObject bsdf, MaterialDescription material, bool isTwoSided) =>
        isTwoSided || material is DiffuseMaterialDescription { Color: SolidTextureDescription { Color.IsBlack: true } }
            ? material
            : new OneSidedMaterialDescription { Material = reading.At(bsdf.Place, material) };
}
