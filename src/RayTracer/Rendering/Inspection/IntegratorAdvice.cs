using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Rendering;

/// <summary>The integrator to take for a scene, by simple rules of what the scene has.</summary>
/// <param name="Integrator">The integrator.</param>
/// <param name="Reason">Why, in one sentence.</param>
internal sealed record IntegratorAdvice(Integrator Integrator, string Reason)
{
    // The side of a lamp beside that of the scene.
    private const float SmallLamp = 0.1f;

    /// <summary>
    /// Returns the advice for a scene: <c>vcm</c> where glass or mirrors gather the light of small lights, the sun among them, or glass stands around a
    /// light; <c>bidirectional</c> where glass parts that light into colours; else
    /// <c>path</c>.
    /// </summary>
    /// <param name="scene">The scene.</param>
    public static IntegratorAdvice For(Scene scene)
    {
        if (scene.Render.Integrator == Integrator.Report)
        {
            return new(Integrator.Report, "the scene asks for it, and others give another picture");
        }

        Integrator fromCamera = scene.Render.Integrator == Integrator.VolPath ? Integrator.VolPath : Integrator.Path;
        if (!scene.Camera.CanLink)
        {
            return new(fromCamera, "light paths cannot be connected with a camera of this projection");
        }

        if (scene.Lights.Any(l => IsInGlass(BoxOf(l, scene), scene.World.Itself.Shapes)))
        {
            return new(Integrator.Vcm, "a light stands inside glass, through which surfaces cannot sample it");
        }

        bool disperses = Array.Exists(scene.Groups, g => g.Traits.Disperses);
        return Array.Exists(scene.Groups, g => Focuses(g.Material)) && HasSmallLight(scene)
            ? disperses ? new(Integrator.Bidirectional, "glass parts the light of small lights into its colours, which vcm shows one at a time")
                : new(Integrator.Vcm, "glass or mirrors gather the light of small lights, and paths from the camera find that by rare chance only")
            : new(fromCamera, "no glass or mirror gathers the light of small lights, so paths from the camera find all light");
    }

    // What sends light of one direction on in one, or nearly so; but not what lets it through as it is.
    private static bool Focuses(Material material) => material is not (MaskMaterial or InvisibleMaterial)
        && material.Traits is { Specular: SpecularLobe.Delta } or { Specular: SpecularLobe.Glossy, Transmits: true, IsLit: false };

    private static bool HasSmallLight(Scene scene)
    {
        float most = SmallLamp * DiagonalOf(new SceneStatistics(scene).FiniteBounds);
        return scene.Environment is SkyEnvironment || scene.Lights.Any(l => l.IsDelta || DiagonalOf(BoxOf(l, scene)) < most);
    }

    // Of the world's own shapes: a bulb of triangles is not looked into.
    private static bool IsInGlass(Bounds box, IEnumerable<Shape> shapes) => box.IsFinite && shapes.Any(s =>
        !s.Material.Traits.Emits && Focuses(s.Material) && (s.Material.Traits.IsTransparent || s.Material.Traits.Transmits) && s.Bounds.Union(box) == s.Bounds);

    private static Bounds BoxOf(LightSource light, Scene scene) => light.Extent((scene.Render.Shutter.X, scene.Render.Shutter.Y)).Box;

    private static float DiagonalOf(Bounds box) => box.IsFinite ? (box.Maximum - box.Minimum).Norm() : float.PositiveInfinity;
}
