using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Fills shapes.</summary>
internal static class MitsubaMedia
{
    private static readonly Rgb s_albedo = new(0.75f, 0.75f, 0.75f);

    /// <summary>The material of a shape with what is inside; the material itself where nothing is.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="material">The material of its surface.</param>
    public static MaterialDescription Fill(MitsubaObject shape, MaterialDescription material)
    {
        if (shape.Child("medium", "exterior") is { } outside)
        {
            shape.Log.Warn(outside.Place, "the medium outside a shape follows from the shapes around it: this has no effect");
            _ = Read(outside);
        }

        if (shape.Child("medium", "interior") is not { } inside)
        {
            return material;
        }

        MediumDescription medium = Read(inside);
        if (Filled(material, medium, new(ReferenceEqualityComparer.Instance)) is { } filled)
        {
            return filled;
        }

        shape.Log.Warn(inside.Place, "a medium in a shape that lets no light in is invisible");
        return material;
    }

    /// <summary>Takes the medium of a camera as known: the medium around the camera follows from the shapes around it.</summary>
    public static void WarnOfSensorMedium(MitsubaObject sensor)
    {
        if (sensor.Only("medium") is { } medium)
        {
            sensor.Log.Warn(medium.Place, "the medium around the camera follows from the shapes around it: this has no effect");
            _ = Read(medium);
        }
    }

    /// <summary>The properties of a medium.</summary>
    public static MediumDescription Read(MitsubaObject medium)
    {
        medium.Ignore("has_spectral_extinction", "sample_emitters");
        if (medium.Type == "heterogeneous")
        {
            medium.Log.Error(medium.TypePlace, "media that vary in space (heterogeneous) are not supported: only \"homogeneous\" ones");
            return new();
        }

        if (medium.Type != "homogeneous")
        {
            medium.UnknownType("media", "homogeneous");
            return new();
        }

        Rgb extinction = MitsubaColors.Read(medium, "sigma_t", Rgb.White) * medium.Float("scale", 1, 0);
        MediumDescription read = new()
        {
            Extinction = extinction,
            Albedo = MitsubaColors.Read(medium, "albedo", s_albedo, maximum: 1),
            Anisotropy = medium.Only("phase") is { } phase ? Anisotropy(phase) : 0,
        };
        medium.Finish();
        return read;
    }

    // What lets light in, with a medium inside; null where nothing does. Each part once: mixes may share theirs.
    private static MaterialDescription? Filled(MaterialDescription material, MediumDescription medium, Dictionary<object, MaterialDescription?> known) =>
        known.TryGetValue(material, out MaterialDescription? done) ? done : known[material] = material switch
        {
            InvisibleMaterialDescription boundary => boundary with { Interior = medium },
            GlassDescription glass => glass with { Interior = medium },
            ThinDielectricMaterialDescription pane => pane with { Interior = medium },
            PrincipledMaterialDescription principled => principled with { Interior = medium },
            MaskMaterialDescription mask => mask with { Interior = medium },
            NormalMapMaterialDescription map => Filled(map.Material, medium, known) is { } inner ? map with { Material = inner } : null,
            BumpMapMaterialDescription map => Filled(map.Material, medium, known) is { } inner ? map with { Material = inner } : null,
            MixMaterialDescription mix => FilledMix(mix, Filled(mix.First, medium, known), Filled(mix.Second, medium, known)),
            _ => null,
        };

    private static MixMaterialDescription? FilledMix(MixMaterialDescription mix, MaterialDescription? first, MaterialDescription? second) =>
        (first ?? second) is null ? null : mix with { First = first ?? mix.First, Second = second ?? mix.Second };

    private static float Anisotropy(MitsubaObject phase)
    {
        if (phase.Type is not ("isotropic" or "hg"))
        {
            phase.UnknownType("phase functions", "isotropic", "hg");
            return 0;
        }

        float g = phase.Type == "hg" ? phase.Float("g", 0.8f, -0.99f, 0.99f) : 0;
        phase.Finish();
        return g;
    }
}
