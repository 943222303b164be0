using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes lights. pbrt's units: spectra say colours of luminance 1, which are scaled, or brought to a power or an illuminance.</summary>
/// <param name="reading">Takes what is wrong.</param>
/// <param name="exposure">The factor of the film on all light: the imaging ratio.</param>
internal sealed class PbrtLights(ImportReading reading, float exposure)
{
    private static readonly string[] s_types = ["point", "spot", "projection", "goniometric", "distant", "infinite"];

    // The pole of our pictures is y and z is at the top; of theirs the pole is z, and y at the bottom.
    private static readonly Transform s_polar = new(new(1, 0, 0, 0), new(0, 0, -1, 0), new(0, 1, 0, 0));

    private readonly Dictionary<PbrtThing, Rgb> _radiances = [];

    /// <summary>A shape that shines.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="light">The light of its surface.</param>
    /// <param name="made">What it was made.</param>
    /// <param name="material">The material of its surface.</param>
    public ShapeDescription Shining(PbrtThing shape, PbrtThing light, ShapeDescription made, MaterialDescription material)
    {
        if (light.Type != "diffuse")
        {
            light.UnknownType(["diffuse"]);
            return made with { Material = material };
        }

        Rgb radiance = Radiance(light);
        float power = light.Float("power", -1);
        bool isTwoSided = light.Boolean("twosided", false);
        TextureDescription? picture = Picture(light, power);
        light.Finish();
        if (isTwoSided && made is not SphereDescription)
        {
            reading.Log.Unsupported(light.PlaceOf("twosided"), $"a {shape.Type} that shines on both sides is not supported", "it shines on its front");
        }

        // Where pbrt's factor of two for both sides is, there is a closed sphere, whose inside nobody sees.
        float sides = isTwoSided ? 2 : 1;
        if (!(power > 0))
        {
            return made with { Material = Luminaire(light, picture, radiance, material) };
        }

        if (made is MeshDescription { File.Length: 0 } mesh && shape.Type is "trianglemesh" or "bilinearmesh")
        {
            return OfPower((MeshDescription)made, shape.State.Place, triangles => radiance * (power / (sides * float.Pi * triangles)), light, material);
        }

        if (shape.Type is not ("sphere" or "disk" or "cylinder"))
        {
            reading.Log.Unsupported(light.PlaceOf("power"), $"a {shape.Type} cannot be given a power: pbrt gives it to each of its parts", "\"scale\" alone counts");
            return made with { Material = Luminaire(light, picture, radiance, material) };
        }

        float area = QuadricPart.Read(shape).Area;
        return made with { Material = Luminaire(light, picture, radiance * (power / (sides * float.Pi * area)), material) };
    }

    /// <summary>A light that is no surface; null where it is an environment, or after an error.</summary>
    public ShapeDescription? Punctual(PbrtThing light)
    {
        ShapeDescription? made = light.Type switch
        {
            "point" => Point(light),
            "spot" => Spot(light),
            "projection" => Projection(light),
            "goniometric" => Goniometric(light),
            "distant" => Distant(light),
            _ => null,
        };
        if (made is null && !s_types.Contains(light.Type))
        {
            light.UnknownType(s_types);
        }

        if (light.State.Places.Moves)
        {
            reading.Log.Warn(light.Place, "lights without a surface do not move, as in pbrt: the first of the two transforms counts");
        }

        light.Finish();
        return made is null ? null : reading.At(light.Place, made);
    }

    /// <summary>The picture of all around, of an environment that has one.</summary>
    public ImageEnvironmentDescription Surroundings(PbrtThing light)
    {
        light.Refuse("portal", "portals are not read: the light comes from all around", "it comes from all around");
        light.Refuse("illuminance", "a picture cannot be given an illuminance here, which depends on it: \"scale\" says how strong it is", "\"scale\" alone counts");
        light.Refuse("L", "an environment has either a picture or a radiance \"L\"");
        ImageEnvironmentDescription made = new()
        {
            File = light.FileName() ?? "",
            Mapping = DirectionMapping.Octahedral,
            Scale = light.Float("scale", 1, 0) * exposure,
            Transform = MatrixSteps.Of(light.State.Place * s_polar),
        };
        light.Finish();
        return reading.At(light.Place, made);
    }

    /// <summary>The radiance from all around, of one that is an environment without a picture.</summary>
    public Rgb Around(PbrtThing light)
    {
        light.Refuse("portal", "portals are not read: the light comes from all around", "it comes from all around");
        Rgb radiance = Scaled(light, "L");
        float illuminance = light.Float("illuminance", -1);
        light.Finish();
        return illuminance > 0 ? radiance * (illuminance / float.Pi) : radiance;
    }

    // Many shapes may shine as the same directive says.
    private Rgb Radiance(PbrtThing light) => _radiances.TryGetValue(light, out Rgb known) ? known : _radiances[light] = Scaled(light, "L");

    private Rgb Scaled(PbrtThing light, string name) => PbrtColors.Read(light, name, Rgb.White, isLight: true) * (light.Float("scale", 1, 0) * exposure);

    private TextureDescription? Picture(PbrtThing light, float power)
    {
        if (!light.Has("filename") || light.FileName() is not { } file)
        {
            light.Ignore("filename");
            return null;
        }

        if (power > 0)
        {
            reading.Log.Unsupported(light.PlaceOf("power"), "a picture that shines cannot be given a power", "its radiance is given power over area");
        }

        return reading.At(light.Place, new ImageTextureDescription { File = file, Wrapping = Wrapping.Clamp });
    }

    private LuminaireMaterialDescription Luminaire(PbrtThing light, TextureDescription? picture, Rgb radiance, MaterialDescription material)
    {
        TextureDescription color = MaterialTextures.Solid(radiance);
        return reading.At(light.Place, new LuminaireMaterialDescription
        {
            Color = picture is null ? color : new ProductTextureDescription { First = picture, Second = color },
            Material = material is InvisibleMaterialDescription ? new DiffuseMaterialDescription { Color = MaterialTextures.Solid(0) } : material,
        });
    }

    // In pbrt each triangle is a lamp of its own, of that power.
    private MeshDescription OfPower(MeshDescription mesh, Transform place, Func<float, Rgb> radiance, PbrtThing light, MaterialDescription material)
    {
        Vector3[] points = [.. mesh.Positions.Select(p => place.Point(p))];
        float Area(TriangleIndices t) => 0.5f * (points[t.B] - points[t.A]).Cross(points[t.C] - points[t.A]).Norm();
        Dictionary<float, int> areas = [];
        List<MaterialDescription> materials = [];
        List<int> ofTriangle = [];
        foreach (TriangleIndices triangle in mesh.Triangles)
        {
            float area = Area(triangle);
            if (!areas.TryGetValue(area, out int index))
            {
                areas.Add(area, index = materials.Count);
                materials.Add(area > 0 ? Luminaire(light, null, radiance(area), material) : material);
            }

            ofTriangle.Add(index);
        }

        return materials.Count == 1 ? mesh with { Material = materials[0] } : mesh with { Materials = materials, MaterialOfTriangle = ofTriangle };
    }

    private PointLightDescription Point(PbrtThing light)
    {
        Rgb intensity = Scaled(light, "I");
        float power = light.Float("power", -1);
        return new()
        {
            Position = light.State.Place.Point(light.Vector("from", "point3") ?? Vector3.Zero),
            Intensity = power > 0 ? intensity * (power / (4 * float.Pi)) : intensity,
        };
    }

    private SpotLightDescription Spot(PbrtThing light)
    {
        Rgb intensity = Scaled(light, "I");
        float power = light.Float("power", -1);
        float cone = light.Float("coneangle", 30, 0.001f, 180);
        float beam = float.Max(cone - light.Float("conedeltaangle", 5, 0, cone), 0);
        float solid = 2 * float.Pi * (1 - (0.5f * (Cosine(beam) + Cosine(cone))));
        Vector3 from = light.Vector("from", "point3") ?? Vector3.Zero;
        return new()
        {
            Position = light.State.Place.Point(from),
            Direction = Direction(light, (light.Vector("to", "point3") ?? Vector3.UnitZ) - from),
            Intensity = power > 0 ? intensity * (power / solid) : intensity,
            CutoffAngle = cone,
            BeamWidth = beam,
            Falloff = SpotFalloff.Smoothstep,
        };
    }

    // A picture of what goes into each direction: of z its middle, and upright where y is upwards. x is to its right, and space is left-handed unless it is mirrored.
    private ProjectorLightDescription Projection(PbrtThing light)
    {
        Transform place = light.State.Place;
        light.Refuse("power", "a projection cannot be given a power here, which depends on its picture: \"scale\" says how strong it is", "\"scale\" alone counts");
        float scale = light.Float("scale", 1, 0) * exposure;
        ImageTextureDescription picture = new() { File = light.FileName() ?? "", Interpolation = Interpolation.Nearest, Wrapping = Wrapping.Clamp };
        if (place.Determinant > 0)
        {
            picture = picture with { Scale = new(-1, 1), Offset = new(1, 0) };
        }

        return new()
        {
            Position = place.Point(Vector3.Zero),
            Direction = place.Vector(Vector3.UnitZ).Unit(),
            Up = place.Vector(Vector3.UnitY).Unit(),
            Picture = picture.File.Length > 0 ? reading.At(light.Place, picture) : MaterialTextures.Solid(0),
            Intensity = new(scale, scale, scale),
            FieldOfView = light.Float("fov", 90, 0.001f, 179),
            FieldOfViewAxis = FieldOfViewAxis.Smaller,
            EvenOnWalls = false,
        };
    }

    // pbrt exchanges y and z of the picture's directions, of which z is the pole otherwise.
    private PointLightDescription Goniometric(PbrtThing light)
    {
        light.Refuse("power", "a goniometric light cannot be given a power here, which depends on its picture: \"scale\" says how strong it is", "\"scale\" alone counts");
        ImageTextureDescription picture = new() { File = light.FileName() ?? "", Interpolation = Interpolation.Nearest, Wrapping = Wrapping.Clamp, Luminance = true };
        return new()
        {
            Intensity = Scaled(light, "I"),
            Picture = picture.File.Length > 0 ? reading.At(light.Place, picture) : MaterialTextures.Solid(0),
            Mapping = DirectionMapping.Octahedral,
            Transform = MatrixSteps.Of(light.State.Place * Transform.Scaling(new(1, 1, -1))),
        };
    }

    private DirectionalLightDescription Distant(PbrtThing light)
    {
        Rgb irradiance = Scaled(light, "L");
        float illuminance = light.Float("illuminance", -1);
        return new()
        {
            Direction = Direction(light, (light.Vector("to", "point3") ?? Vector3.UnitZ) - (light.Vector("from", "point3") ?? Vector3.Zero)),
            Irradiance = illuminance > 0 ? irradiance * illuminance : irradiance,
        };
    }

    private static Vector3 Direction(PbrtThing light, Vector3 own)
    {
        Vector3 direction = light.State.Place.Vector(own).Unit();
        return direction.IsFinite() ? direction : light.Log.Fail<Vector3?>(light.Place, "\"from\" and \"to\" must be different points") ?? Vector3.UnitZ;
    }

    private static float Cosine(float degrees)
    {
        LaneMath.SinCosTurn(degrees / 360, out _, out float cosine);
        return cosine;
    }
}
