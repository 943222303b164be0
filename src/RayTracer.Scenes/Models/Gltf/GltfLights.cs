using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>
/// Stands shapes that shine in for the lights without extent of KHR_lights_punctual. Candela and lux are taken as they are for
/// radiant intensity and irradiance.
/// </summary>
internal sealed class GltfLights(GltfDocument document)
{
    // Of half the diagonal of what the file shows.
    private const float RelativeRadius = 0.01f;
    private const float RelativeDistance = 1000;

    // The sun's angular radius, as seen from the earth: half of 0.53°.
    private const double SunRadius = 0.53 / 2 * (Math.PI / 180);

    /// <summary>A node's light; null where it has none.</summary>
    /// <param name="node">The node.</param>
    public GltfObject? Find(GltfObject node) =>
        node.Extension("KHR_lights_punctual")?.Integer("light") is { } index ? Light(node, index) : null;

    /// <summary>A shape that shines as the light does.</summary>
    /// <param name="light">The light in the file.</param>
    /// <param name="world">Its place; it shines along −z.</param>
    /// <param name="center">The middle of what the file shows.</param>
    /// <param name="extent">Half the diagonal of what the file shows.</param>
    public ShapeDescription? Describe(GltfObject light, Transform world, Vector3 center, float extent)
    {
        Rgb color = light.Color("color", Rgb.White, 3, float.MaxValue);
        float intensity = light.Number("intensity", 1, 0);
        if (light.Has("range"))
        {
            document.Notes.Add("the range of a light is left out: its light falls off with the square of the distance");
        }

        float radius = RelativeRadius * extent;
        Vector3 forward = -world.Vector(Vector3.UnitZ).Unit();
        Vector3 position = world.Point(Vector3.Zero);
        if (!forward.IsFinite() || !position.IsFinite())
        {
            document.Notes.Add("a light at a node that is scaled to nothing, or too far away, is left out");
            return null;
        }

        return light.Text("type") switch
        {
            "point" => Point(color, intensity, position, radius),
            "spot" => Spot(light.Child("spot"), color, intensity, position, forward, radius),
            "directional" => Sun(color, intensity, center - (forward * (RelativeDistance * extent)), RelativeDistance * extent),
            _ => throw light.Error("type", "expected \"point\", \"spot\" or \"directional\""),
        };
    }

    // A sphere of radiance L has the intensity L·πr² in all directions.
    private SphereDescription Point(Rgb color, float intensity, Vector3 position, float radius)
    {
        document.Notes.Add($"a point light is shown as a small sphere of radius {radius:G3} and the same intensity");
        return Sphere("point light", position, radius, Luminaire(color, intensity / (Math.PI * radius * radius), 0));
    }

    // A disk of radiance L·cosᵉ has the intensity L·πr²·cosᵉ⁺¹.
    private DiskDescription Spot(GltfObject? cone, Rgb color, float intensity, Vector3 position, Vector3 forward, float radius)
    {
        float inner = cone?.Number("innerConeAngle", 0, 0, float.Pi / 2) ?? 0;
        float outer = cone?.Number("outerConeAngle", float.Pi / 4, 0, float.Pi / 2) ?? float.Pi / 4;
        if (inner > outer)
        {
            throw cone!.Error("innerConeAngle", "it must not be larger than \"outerConeAngle\"");
        }

        document.Notes.Add($"a spot light is shown as a small disk of radius {radius:G3}: as strong along its axis, half as strong at the same angle, without an edge");
        float exponent = SpotExponent(inner, outer);
        return new()
        {
            Name = "spot light",
            Center = position,
            Normal = forward,
            Radius = radius,
            Material = Luminaire(color, intensity / (Math.PI * radius * radius), exponent - 1),
        };
    }

    // KHR_lights_punctual: intensity falls as the square of a number that goes from 1 to 0 in proportion to the cosine. The power
    // of the cosine that is one half at the same angle.
    private static float SpotExponent(float inner, float outer)
    {
        LaneMath.SinCos(inner, out _, out float cosInner);
        LaneMath.SinCos(outer, out _, out float cosOuter);
        float cosHalf = cosOuter + ((cosInner - cosOuter) * float.Sqrt(0.5f));
        return cosHalf >= 1 ? 1e6f : float.Clamp(LaneMath.Log(0.5f) / LaneMath.Log(float.Max(cosHalf, 1e-6f)), 1, 1e6f);
    }

    // A sphere of radiance L that is seen under the angular radius a gives the irradiance π·L·sin²a.
    private SphereDescription Sun(Rgb color, float irradiance, Vector3 position, float distance)
    {
        document.Notes.Add("a directional light is shown as a distant sphere as wide as the sun (0.53°), of the same irradiance");
        double sine = SunRadius - (SunRadius * SunRadius * SunRadius / 6);
        return Sphere("directional light", position, (float)(distance * sine), Luminaire(color, irradiance / (Math.PI * sine * sine), 0));
    }

    private static SphereDescription Sphere(string name, Vector3 center, float radius, LuminaireMaterialDescription material) =>
        new() { Name = name, Center = center, Radius = radius, Material = material };

    private static LuminaireMaterialDescription Luminaire(Rgb color, double radiance, float exponent) => new()
    {
        Color = new SolidTextureDescription { Color = color },
        Multiplier = (float)radiance,
        Exponent = exponent,
    };

    private GltfObject Light(GltfObject node, int index)
    {
        IReadOnlyList<GltfObject> lights = document.Root.Extension("KHR_lights_punctual")?.Children("lights") ?? [];
        return index < lights.Count ? lights[index] : throw node.Error($"there is no light {index}: the file has {lights.Count}");
    }
}
