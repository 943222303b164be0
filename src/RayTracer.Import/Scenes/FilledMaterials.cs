using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;

namespace RayTracer.Import;

/// <summary>Materials of shapes that are filled.</summary>
internal static class FilledMaterials
{
    /// <summary>A material that lets light in, with a medium inside; null where it lets none in.</summary>
    public static MaterialDescription? Fill(MaterialDescription material, MediumDescription medium) =>
        Filled(material, medium, new(ReferenceEqualityComparer.Instance));

    // Each part once: mixes may share theirs.
    private static MaterialDescription? Filled(MaterialDescription material, MediumDescription medium, Dictionary<object, MaterialDescription?> known) =>
        known.TryGetValue(material, out MaterialDescription? done) ? done : known[material] = material switch
        {
            InvisibleMaterialDescription boundary => boundary with { Interior = medium },
            GlassDescription glass => glass with { Interior = medium },
            ThinDielectricMaterialDescription pane => pane with { Interior = medium },
            TranslucentMaterialDescription sheet => sheet with { Interior = medium },
            PrincipledMaterialDescription principled => principled with { Interior = medium },
            ThinPrincipledMaterialDescription sheet => sheet with { Interior = medium },
            MaskMaterialDescription mask => mask with { Interior = medium },
            NormalMapMaterialDescription map => Filled(map.Material, medium, known) is { } inner ? map with { Material = inner } : null,
            BumpMapMaterialDescription map => Filled(map.Material, medium, known) is { } inner ? map with { Material = inner } : null,
            MixMaterialDescription mix => FilledMix(mix, Filled(mix.First, medium, known), Filled(mix.Second, medium, known)),
            _ => null,
        };

    private static MixMaterialDescription? FilledMix(MixMaterialDescription mix, MaterialDescription? first, MaterialDescription? second) =>
        (first ?? second) is null ? null : mix with { First = first ?? mix.First, Second = second ?? mix.Second };
}
