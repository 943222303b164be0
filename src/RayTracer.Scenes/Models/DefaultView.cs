using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>Makes up what a model file does not have and a picture needs: a camera that sees all of it, and light.</summary>
internal static class DefaultView
{
    private const float FieldOfViewDegrees = 35;

    // From the right, the front and above (y is up in nearly all files).
    private static readonly Vector3 TowardsCamera = new Vector3(0.55f, 0.4f, 1).Unit();

    // Over the camera's left shoulder.
    private static readonly Vector3 TowardsLight = new Vector3(-0.6f, 1.2f, 0.9f).Unit();

    // Distance and radius of the luminaire in half diagonals of the model, and its radiance: a white matt surface that faces it
    // has the radiance 6 · (1.5/5)² = 0.54, and up to 0.35 more from the background.
    private const float LightDistance = 5;
    private const float LightRadius = 1.5f;
    private const float LightRadiance = 6;
    private static readonly Rgb Background = new(0.3f, 0.32f, 0.35f);

    /// <summary>The scene of a model as it is rendered by itself.</summary>
    /// <param name="model">The model.</param>
    /// <returns>The scene, with what the model does not have, and the model's notes, with what was made up.</returns>
    public static ImportedModel Complete(ImportedModel model)
    {
        SceneDescription scene = model.Scene;
        (Vector3 center, float extent) = CenterAndExtent(scene.Shapes);
        List<string> notes = [.. model.Notes];
        if (model.Camera is null)
        {
            notes.Add("the file has no camera: the whole model is shown from the front, right and above");
        }

        scene = scene with { Camera = model.Camera ?? Camera(center, extent), Render = scene.Render with { Integrator = Integrator.Path, Exposure = Exposure.Auto } };
        if (scene.Lights.Count == 0 && !scene.Shapes.Any(IsLamp))
        {
            notes.Add("the file has no light: a large luminaire and a grey background are added");
            scene = scene with { Background = Background, Lights = [Light(center, extent)] };
        }

        return model with { Scene = scene, Notes = notes };
    }

    /// <summary>The middle of the box around shapes and half its diagonal; the origin and 1 where there is nothing.</summary>
    private static (Vector3 Center, float Extent) CenterAndExtent(IEnumerable<ShapeDescription> shapes)
    {
        Bounds box = ModelExtent.Of(shapes);
        float extent = ((box.Maximum * 0.5f) - (box.Minimum * 0.5f)).Norm();
        return box.IsFinite ? ((box.Minimum * 0.5f) + (box.Maximum * 0.5f), extent > 0 && float.IsFinite(extent) ? extent : 1) : (Vector3.Zero, 1);
    }

    private static CameraDescription Camera(Vector3 center, float extent)
    {
        // The ball around the model touches the edges of the picture.
        LaneMath.SinCosTurn(FieldOfViewDegrees / 2 / 360, out float sin, out _);
        return new()
        {
            Position = center + (TowardsCamera * (extent / sin)),
            LookAt = center,
            FieldOfView = FieldOfViewDegrees,
            FieldOfViewAxis = FieldOfViewAxis.Smaller,
        };
    }

    private static SphereDescription Light(Vector3 center, float extent) => new()
    {
        Name = "made-up light",
        Center = center + (TowardsLight * (LightDistance * extent)),
        Radius = LightRadius * extent,
        Material = new LuminaireMaterialDescription { Color = new SolidTextureDescription { Color = Rgb.White }, Multiplier = LightRadiance },
    };

    // Materials that shine are headlights, screens or signs, and leave a scene dark.
    private static bool IsLamp(ShapeDescription shape) => shape switch
    {
        GroupDescription group => group.Shapes.Any(IsLamp),
        InstanceDescription { Of: { } of } => IsLamp(of),
        _ => shape is PunctualLightDescription,
    };
}
