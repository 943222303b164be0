using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Scenes;

/// <summary>Fills shapes.</summary>
internal static class MitsubaMedia
{
    private static readonly Rgb s_albedo = new(0.75f, 0.75f, 0.75f);

    /// <summary>The material of a shape with what is inside; the material itself where nothing is.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="material">What its surface is made of.</param>
    public static MaterialDescription Fill(MitsubaObject shape, MaterialDescription material)
    {
        if (shape.Child("medium", "exterior") is { } outside)
        {
            shape.Log.Error(outside.Place, "a medium outside a shape is not read here");
        }

        if (shape.Child("medium", "interior") is not { } inside)
        {
            return material;
        }

        MediumDescription medium = Read(inside);
        switch (material)
        {
            case InvisibleMaterialDescription boundary:
                return boundary with { Interior = medium };
            case DielectricMaterialDescription glass:
                return glass with { Interior = medium };
            default:
                shape.Log.Error(inside.Place, "a medium is read in shapes of the BSDFs \"null\" and \"dielectric\" only");
                return material;
        }
    }

    private static MediumDescription Read(MitsubaObject medium)
    {
        medium.Ignore("has_spectral_extinction", "sample_emitters");
        if (medium.Type == "heterogeneous")
        {
            medium.Log.Error(medium.TypePlace, "media that vary in space (heterogeneous) are not read here: only \"homogeneous\" ones");
            return new();
        }

        if (medium.Type != "homogeneous")
        {
            medium.Log.Unknown(medium.TypePlace, $"media of the type {Quotation.Of(medium.Type)} are not read here", medium.Type, ["homogeneous"]);
            return new();
        }

        Rgb extinction = MitsubaColors.Read(medium, "sigma_t", Rgb.White) * medium.Float("scale", 1, 0);
        MediumDescription read = new()
        {
            Extinction = extinction,
            Albedo = MitsubaColors.Read(medium, "albedo", s_albedo),
            Anisotropy = medium.Only("phase") is { } phase ? Anisotropy(phase) : 0,
        };
        medium.Finish();
        return read;
    }

    private static float Anisotropy(MitsubaObject phase)
    {
        float g = 0;
        switch (phase.Type)
        {
            case "isotropic":
                break;
            case "hg":
                g = phase.Float("g", 0.8f);
                break;
            default:
                phase.Log.Unknown(phase.TypePlace, $"phase functions of the type {Quotation.Of(phase.Type)} are not read here", phase.Type, ["isotropic", "hg"]);
                return 0;
        }

        phase.Finish();
        return g;
    }
}
