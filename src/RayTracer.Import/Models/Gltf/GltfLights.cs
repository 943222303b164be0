using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>
/// The lights without extent of KHR_lights_punctual. Candela and lux are taken as they are for radiant intensity and irradiance.
/// </summary>
internal sealed class GltfLights(GltfDocument document)
{
    // Of a cone, in degrees: the scene has none without a width.
    private const float SmallestAngle = 1e-3f;

    /// <summary>A node's light; null where it has none.</summary>
    /// <param name="node">The node.</param>
    public GltfObject? Find(GltfObject node) =>
        node.Extension("KHR_lights_punctual")?.Integer("light") is { } index ? Light(node, index) : null;

    /// <summary>The light as the scene has it.</summary>
    /// <param name="light">The light in the file.</param>
    /// <param name="world">Its place; it shines along −z. Its scale does not count.</param>
    public ShapeDescription? Describe(GltfObject light, Transform world)
    {
        Rgb color = light.Color("color", Rgb.White, 3, float.MaxValue) * light.Number("intensity", 1, 0);
        document.Notes.AddIf(light.Has("range"), "the range of a light is ignored: its light falls off with the square of the distance");

        Vector3 forward = -world.Vector(Vector3.UnitZ).Unit();
        Vector3 position = world.Point(Vector3.Zero);
        if (!forward.IsFinite() || !position.IsFinite() || !float.IsFinite(color.R + color.G + color.B))
        {
            document.Notes.Add("a light at a node that is scaled to nothing, or too far away, or too strong to compute with, is ignored");
            return null;
        }

        return light.Text("type") switch
        {
            "point" => new PointLightDescription { Name = "point light", Position = position, Intensity = color },
            "spot" => Spot(light.Child("spot"), color, position, forward),
            "directional" => new DirectionalLightDescription { Name = "directional light", Direction = forward, Irradiance = color },
            _ => throw light.Error("type", "expected \"point\", \"spot\" or \"directional\""),
        };
    }

    private static SpotLightDescription Spot(GltfObject? cone, Rgb color, Vector3 position, Vector3 forward)
    {
        float inner = cone?.Number("innerConeAngle", 0, 0, float.Pi / 2) ?? 0;
        float outer = cone?.Number("outerConeAngle", float.Pi / 4, 0, float.Pi / 2) ?? float.Pi / 4;
        if (inner > outer)
        {
            throw cone!.Error("innerConeAngle", "it must not be larger than \"outerConeAngle\"");
        }

        return new()
        {
            Name = "spot light",
            Position = position,
            Direction = forward,
            Intensity = color,
            CutoffAngle = float.Max(outer * (180 / float.Pi), SmallestAngle),
            BeamWidth = inner * (180 / float.Pi),
            Falloff = SpotFalloff.Smooth,
        };
    }

    private GltfObject Light(GltfObject node, int index)
    {
        IReadOnlyList<GltfObject> lights = document.Root.Extension("KHR_lights_punctual")?.Children("lights") ?? [];
        return index < lights.Count ? lights[index] : throw node.Error($"there is no light {index}: the file has {lights.Count}");
    }
}
