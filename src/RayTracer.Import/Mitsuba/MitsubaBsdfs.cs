using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes materials. What reflects does so on its front only, unless it is within <c>twosided</c>.</summary>
internal sealed class MitsubaBsdfs(MitsubaReading reading, MitsubaTextures textures)
{
    private static readonly Rgb s_half = new(0.5f, 0.5f, 0.5f);

    private readonly Dictionary<(MitsubaObject Bsdf, bool IsTwoSided), MaterialDescription> _made = [];
    private readonly MitsubaMetals _metals = new(textures);
    private readonly MitsubaDielectrics _dielectrics = new(textures);
    private readonly MitsubaWrappers _wrappers = new(reading, textures);

    /// <summary>The material of surfaces that give none.</summary>
    public static MaterialDescription Standard { get; } =
        new OneSidedMaterialDescription { Material = new DiffuseMaterialDescription { Color = MitsubaTextures.Solid(s_half) } };

    /// <summary>The material of emitting surfaces that give none.</summary>
    public static MaterialDescription Black { get; } = new DiffuseMaterialDescription { Color = MitsubaTextures.Solid(Rgb.Black) };

    /// <summary>True where the integrator shows media: then boundaries of nothing do not count as edges of paths.</summary>
    public bool IsVolumetric { get; set; }

    /// <summary>The materials that have names.</summary>
    public Dictionary<string, MaterialDescription> Named { get; } = new(StringComparer.Ordinal);

    /// <summary>The material that a thing is.</summary>
    /// <param name="bsdf">The thing.</param>
    /// <param name="isTwoSided">Whether it is seen from both sides.</param>
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

    private MaterialDescription Make(MitsubaObject bsdf, bool isTwoSided)
    {
        switch (bsdf.Type)
        {
            case "diffuse":
                return Sided(bsdf, new DiffuseMaterialDescription { Color = textures.Read(bsdf, "reflectance", s_half) }, isTwoSided);
            case "conductor" or "roughconductor":
                return Sided(bsdf, _metals.Read(bsdf), isTwoSided);
            case "plastic" or "roughplastic":
                return Sided(bsdf, _dielectrics.Plastic(bsdf), isTwoSided);
            case "dielectric" or "thindielectric" or "roughdielectric":
                return _dielectrics.Read(bsdf);
            case "null":
                return IsVolumetric ? new InvisibleMaterialDescription() : new MaskMaterialDescription { Opacity = MitsubaTextures.Solid(Rgb.Black) };
            default:
                return MakeOfOthers(bsdf, isTwoSided);
        }
    }

    private MaterialDescription MakeOfOthers(MitsubaObject bsdf, bool isTwoSided)
    {
        switch (bsdf.Type)
        {
            case "twosided":
                MaterialDescription[] sides = Inner(bsdf, 1, 2, isTwoSided: true);
                return sides.Length == 1 ? sides[0] : new TwoSidedMaterialDescription { Front = sides[0], Back = sides[1] };
            case "mask":
                TextureDescription opacity = textures.Read(bsdf, "opacity", 0.5f);
                return new MaskMaterialDescription { Material = Inner(bsdf, 1, 1, isTwoSided)[0], Opacity = opacity };
            case "blendbsdf":
                TextureDescription weight = textures.Read(bsdf, "weight", 0.5f);
                MaterialDescription[] mixed = Inner(bsdf, 2, 2, isTwoSided);
                return new MixMaterialDescription { First = mixed[0], Second = mixed[1], Weight = weight };
            case "normalmap":
                return _wrappers.NormalMap(bsdf, Inner(bsdf, 1, 1, isTwoSided)[0]);
            case "bumpmap":
                return _wrappers.BumpMap(bsdf, Inner(bsdf, 1, 1, isTwoSided)[0]);
            case "principled":
                PrincipledMaterialDescription principled = _wrappers.Principled(bsdf);
                bool isOpaque = principled.Transmission is SolidTextureDescription { Color.R: 0 };
                return isOpaque ? Sided(bsdf, principled, isTwoSided) : principled;
            default:
                string[] known = ["diffuse", "conductor", "roughconductor", "plastic", "roughplastic", "dielectric", "thindielectric", "roughdielectric", "principled", "twosided", "mask", "blendbsdf", "normalmap", "bumpmap", "null"];
                reading.Log.Unknown(bsdf.TypePlace, $"BSDFs of type {Quotation.Of(bsdf.Type)} are not supported", bsdf.Type, known);
                return Standard;
        }
    }

    private MaterialDescription[] Inner(MitsubaObject bsdf, int least, int most, bool isTwoSided)
    {
        MitsubaObject[] inner = [.. bsdf.Children("bsdf")];
        if (inner.Length < least || inner.Length > most)
        {
            if (bsdf.LacksSomething)
            {
                return [.. Enumerable.Repeat(Standard, least)];
            }

            reading.Log.Error(bsdf.Place, $"{bsdf.Describe()} needs {(least == most ? $"{least}" : $"{least} or {most}")} BSDFs within it, but has {inner.Length}");
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
