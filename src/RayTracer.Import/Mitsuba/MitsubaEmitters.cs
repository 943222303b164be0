using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes lights.</summary>
internal sealed class MitsubaEmitters(ImportReading reading, MitsubaTextures textures)
{
    private static readonly string[] s_known = ["area", "point", "spot", "projector", "directional", "constant", "envmap"];

    /// <summary>A material that shines, and reflects as the surface would without.</summary>
    /// <param name="emitter">The emitter of a shape.</param>
    /// <param name="material">The surface's material.</param>
    public MaterialDescription Area(MitsubaObject emitter, MaterialDescription material)
    {
        if (emitter.Type != "area" && MitsubaPlugins.ReasonOf(emitter) is not null)
        {
            emitter.UnknownType("emitters", "area");
            return material;
        }

        if (emitter.Type != "area")
        {
            reading.Log.Unknown(emitter.TypePlace, $"a shape may have an emitter of type \"area\", but not of type {Quotation.Of(emitter.Type)}", emitter.Type, ["area"]);
            return material;
        }

        emitter.Ignore("sampling_weight");
        LuminaireMaterialDescription luminaire = new() { Color = textures.Read(emitter, "radiance", Rgb.White, isLight: true), Material = material };
        emitter.Finish();
        return reading.At(emitter.Place, luminaire);
    }

    /// <summary>A light without extent; null where the emitter is an environment, or after an error.</summary>
    public ShapeDescription? Punctual(MitsubaObject emitter)
    {
        emitter.Ignore("sampling_weight");
        ShapeDescription? light = emitter.Type switch
        {
            "point" => Point(emitter),
            "spot" => Spot(emitter),
            "projector" => Projector(emitter),
            "directional" => Directional(emitter),
            _ => null,
        };
        if (light is not null)
        {
            emitter.Finish();
            return reading.At(emitter.Place, light);
        }

        if (emitter.Type == "area")
        {
            reading.Log.Error(emitter.Place, "an area emitter must stand in the shape that shines");
        }
        else if (!s_known.Contains(emitter.Type))
        {
            emitter.UnknownType("emitters", s_known);
        }

        return null;
    }

    /// <summary>A scene with the light that comes from all around.</summary>
    public SceneDescription Environment(MitsubaObject emitter, SceneDescription scene)
    {
        emitter.Ignore("sampling_weight", "mis_compensation");
        if (emitter.Type == "constant")
        {
            scene = scene with { Background = MitsubaColors.Read(emitter, "radiance", Rgb.White, isLight: true) };
        }
        else if (emitter.Type == "sunsky")
        {
            scene = scene with { Environment = reading.At(emitter.Place, Sky(emitter)) };
        }
        else if (Picture(emitter) is { } picture)
        {
            scene = scene with { Environment = reading.At(emitter.Place, picture) };
        }

        emitter.Finish();
        return scene;
    }

    /// <summary>True where an emitter shines from all around.</summary>
    public static bool IsEnvironment(MitsubaObject emitter) => emitter.Type is "constant" or "envmap" || (emitter.Type == "sunsky" && emitter.Has("sun_direction"));

    private ImageEnvironmentDescription? Picture(MitsubaObject emitter)
    {
        Transform place = emitter.Transform();
        if (place.UniformScale() is null)
        {
            reading.Log.Error(emitter.PlaceOf("to_world"), "an environment can be turned, but not stretched");
            place = Transform.Identity;
        }

        float scale = emitter.Float("scale", 1, 0);
        return emitter.FileName() is not { } file ? null : new()
        {
            File = file,
            Scale = scale,
            Transform = MatrixSteps.Of(place),
        };
    }

    // The native sky, as bright by its model as Mitsuba's is by its own, in W/(m² sr nm): it is in thousands of candelas per square metre, of which a watt of even light has 683 · 106.857 nm. Up is z there.
    private SkyEnvironmentDescription Sky(MitsubaObject emitter)
    {
        const float watts = 1000 / (683 * 106.857f);
        const float diameter = 0.533f;
        reading.Log.Unsupported(emitter.TypePlace, $"emitters of type \"sunsky\" are not supported: {MitsubaPlugins.ReasonOf(emitter)}", "the native sky with the same sun stands in for it");
        Transform place = emitter.Transform();
        Vector3 toSun = place.Inverse().Vector(emitter.Vector("sun_direction") ?? Vector3.UnitZ).Unit();
        float sky = float.Max(emitter.Float("sky_scale", 1, 0), 1e-3f);
        return new()
        {
            Turbidity = float.Clamp(emitter.Float("turbidity", 3), 2, 10),
            Ground = MitsubaColors.Read(emitter, "albedo", new(0.3f, 0.3f, 0.3f)),
            SunElevation = float.Clamp(90 - (LaneMath.Acos(toSun.Z) * (180 / float.Pi)), 0, 90),
            SunAzimuth = LaneMath.Atan2(toSun.X, toSun.Y) * (180 / float.Pi),
            SunSize = float.Clamp(emitter.Float("sun_aperture", diameter) / diameter, 0.1f, 100),
            Scale = watts * sky,
            SunScale = emitter.Float("sun_scale", 1, 0) / sky,
            Transform = MatrixSteps.Of(place * Transform.Rotation(Vector3.UnitX, 90)),
        };
    }

    private static PointLightDescription Point(MitsubaObject emitter) => new()
    {
        Position = emitter.Vector("position") ?? emitter.Transform().Point(Vector3.Zero),
        Intensity = MitsubaColors.Read(emitter, "intensity", Rgb.White, isLight: true),
        Name = emitter.Id,
    };

    private SpotLightDescription Spot(MitsubaObject emitter)
    {
        Transform place = emitter.Transform();
        float cutoff = emitter.Float("cutoff_angle", 20);
        return new()
        {
            Position = place.Point(Vector3.Zero),
            Direction = place.Vector(Vector3.UnitZ).Unit(),
            Intensity = MitsubaColors.Read(emitter, "intensity", Rgb.White, isLight: true),
            CutoffAngle = cutoff,
            BeamWidth = emitter.Float("beam_width", 0.75f * cutoff),
            Picture = emitter.Child("texture", "texture") is { } picture ? Mirrored(textures.Read(picture)) : null,
            PictureUp = place.Vector(Vector3.UnitY).Unit(),
            Name = emitter.Id,
        };
    }

    // Its picture gives the irradiance, over π, of a plane at distance 1; the first row is at the top, and the middle of the first column to the left.
    private ProjectorLightDescription Projector(MitsubaObject emitter)
    {
        Transform place = emitter.Transform();
        float scale = emitter.Float("scale", 1, 0) * float.Pi;
        return new()
        {
            Position = place.Point(Vector3.Zero),
            Direction = place.Vector(Vector3.UnitZ).Unit(),
            Up = place.Vector(Vector3.UnitY).Unit(),
            Intensity = new(scale, scale, scale),
            Picture = Upright(textures.Read(emitter, "irradiance", Rgb.White, isLight: true)),
            FieldOfView = MitsubaSensors.FieldOfView(emitter, out FieldOfViewAxis axis),
            FieldOfViewAxis = axis,
            Name = emitter.Id,
        };
    }

    // Rows of pictures are counted from the top there, and u grows to the left where a light looks along z with y upwards.
    private static PlacedTextureDescription Upright(TextureDescription texture) => new() { Texture = texture, Matrix = [1, 0, 0, 0, -1, 1] };

    private static PlacedTextureDescription Mirrored(TextureDescription texture) => new() { Texture = texture, Matrix = [-1, 0, 1, 0, 1, 0] };

    private static DirectionalLightDescription Directional(MitsubaObject emitter) => new()
    {
        Direction = emitter.Vector("direction") ?? emitter.Transform().Vector(Vector3.UnitZ).Unit(),
        Irradiance = MitsubaColors.Read(emitter, "irradiance", Rgb.White, isLight: true),
        Name = emitter.Id,
    };
}
