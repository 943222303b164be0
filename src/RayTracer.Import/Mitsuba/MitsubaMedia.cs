using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Fills shapes.</summary>
internal static class MitsubaMedia
{
    private static readonly Rgb s_albedo = new(0.75f, 0.75f, 0.75f);
    private static readonly ConditionalWeakTable<MitsubaObject, MediumDescription> s_known = [];
    private static readonly Dictionary<string, GridInterpolation> s_filters = new() { ["trilinear"] = GridInterpolation.Trilinear, ["nearest"] = GridInterpolation.Nearest };
    private static readonly Dictionary<string, Wrapping> s_wrappings =
        new() { ["clamp"] = Wrapping.Clamp, ["repeat"] = Wrapping.Repeat, ["mirror"] = Wrapping.Mirror };

    /// <summary>The material of a shape with what is inside; the material itself where nothing is.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="material">The material of its surface.</param>
    /// <param name="isShown">True where the integrator shows media.</param>
    public static MaterialDescription Fill(MitsubaObject shape, MaterialDescription material, bool isShown)
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
        if (!isShown)
        {
            shape.Log.Warn(inside.Place, "the scene's integrator shows no media: \"volpath\" and \"volpathmis\" do");
            return material;
        }

        if (FilledMaterials.Fill(material, medium) is { } filled)
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

    /// <summary>The properties of a medium; the same for all that refer to it.</summary>
    public static MediumDescription Read(MitsubaObject medium) => s_known.GetValue(medium, ReadOnce);

    private static MediumDescription ReadOnce(MitsubaObject medium)
    {
        // How Mitsuba samples what varies, which does not change the picture.
        medium.Ignore("has_spectral_extinction", "sample_emitters", "majorant_resolution_factor", "majorant_factor", "majorant_grid_filename");
        if (medium.Type is not ("homogeneous" or "heterogeneous"))
        {
            medium.UnknownType("media", "homogeneous", "heterogeneous");
            return new();
        }

        (Rgb extinction, GridDescription? density) = Volume(medium, "sigma_t", Rgb.White, float.PositiveInfinity);
        (Rgb albedo, GridDescription? albedos) = Volume(medium, "albedo", s_albedo, 1);
        PhaseDescription phase = medium.Only("phase") is { } given ? MitsubaPhases.Read(given) : new();
        MediumDescription read = new()
        {
            Extinction = extinction * medium.Float("scale", 1, 0),
            Albedo = albedo,
            Density = density,
            AlbedoGrid = albedos,
            Anisotropy = phase.Anisotropy,
            Phase = phase.Shape == PhaseShape.HenyeyGreenstein ? null : phase,
        };
        if (density is not null && medium.Type == "homogeneous")
        {
            medium.Log.Error(medium.TypePlace, "a homogeneous medium cannot have a grid: its type must be \"heterogeneous\"");
        }

        if (density is null && albedos is not null)
        {
            medium.Log.Error(medium.PlaceOf("albedo"), "an albedo that varies is read only where \"sigma_t\" is a grid too");
        }

        medium.Finish();
        return read;
    }

    /// <summary>A number or colour, and the grid that it is a factor on: a property, a constvolume or a gridvolume.</summary>
    public static (Rgb Factor, GridDescription? Grid) Volume(MitsubaObject thing, string name, Rgb standard, float maximum)
    {
        if (thing.Child("volume", name) is not { } volume)
        {
            return (MitsubaColors.Read(thing, name, standard, maximum: maximum), null);
        }

        if (volume.Type == "constvolume")
        {
            Rgb value = MitsubaColors.Read(volume, "value", Rgb.White, maximum: maximum);
            volume.Ignore("to_world");
            volume.Finish();
            return (value, null);
        }

        if (volume.Type != "gridvolume")
        {
            volume.UnknownType("volumes", "constvolume", "gridvolume");
            return (Rgb.White, null);
        }

        return (Rgb.White, Grid(volume));
    }

    private static GridDescription Grid(MitsubaObject volume)
    {
        // Numbers are those of red, green and blue in either case; the most of them is found anyway.
        volume.Ignore("raw", "accel", "max_value");
        Transform place = volume.Transform();
        GridDescription grid = new()
        {
            File = volume.FileName() ?? "",
            Box = volume.Boolean("use_grid_bbox", false) ? [] : [Vector3.Zero, Vector3.One],
            Transform = MatrixSteps.Of(place),
            Interpolation = volume.Choice("filter_type", GridInterpolation.Trilinear, s_filters),
            Wrapping = volume.Choice("wrap_mode", Wrapping.Clamp, s_wrappings),
        };
        volume.Finish();
        return grid;
    }
}
