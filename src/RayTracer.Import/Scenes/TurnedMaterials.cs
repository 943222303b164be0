using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>The materials of shapes that are turned inside out (<c>flip_normals</c>), on shapes that are not.</summary>
internal static class TurnedMaterials
{
    private static readonly MediumDescription s_nothing = new();

    /// <summary>The material that looks from outside as another one from inside; null where there is none: what shines, is embossed or holds a medium.</summary>
    public static MaterialDescription? Turned(MaterialDescription material) => material switch
    {
        OneSidedMaterialDescription sided => new TwoSidedMaterialDescription { Front = new DiffuseMaterialDescription { Color = MaterialTextures.Solid(Rgb.Black) }, Back = sided.Material },
        TwoSidedMaterialDescription { Back: { } back } sided => sided with { Front = back, Back = sided.Front },
        DielectricMaterialDescription glass when glass.Interior == s_nothing => glass with { RefractiveIndex = 1 / glass.RefractiveIndex },
        RoughDielectricMaterialDescription glass when glass.Interior == s_nothing => glass with { RefractiveIndex = 1 / glass.RefractiveIndex },
        MaskMaterialDescription mask when mask.Interior == s_nothing => Turned(mask.Material) is { } inner ? mask with { Material = inner } : null,
        MixMaterialDescription mix => Turned(mix.First) is { } first && Turned(mix.Second) is { } second ? mix with { First = first, Second = second } : null,
        DiffuseMaterialDescription or MetalDescription or PlasticMaterialDescription or RoughPlasticMaterialDescription => material,
        ThinDielectricMaterialDescription pane when pane.Interior == s_nothing => pane,
        InvisibleMaterialDescription boundary when boundary.Interior == s_nothing => boundary,
        _ => null,
    };

    /// <summary>The material of a shape that may be turned inside out; the same one, after an error, where it cannot be.</summary>
    public static MaterialDescription Turned(MitsubaObject shape, MaterialDescription material)
    {
        if (Turned(material) is { } turned)
        {
            return turned;
        }

        shape.Log.Unsupported(
            shape.PlaceOf("flip_normals"),
            $"a {shape.Type} that is turned inside out and shines, is embossed or transparent all around, or holds a medium is not supported", "it is not turned");
        return material;
    }
}
