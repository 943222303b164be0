using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>Makes up what a model file does not have and a picture needs: a camera that sees all of it, light, and a ground to stand on.</summary>
internal static class DefaultView
{
    private const float FieldOfViewDegrees = 35;

    // How much of the picture's half the model takes.
    private const float Filling = 0.9f;

    // From the right, above and the front.
    private static readonly Vector3 TowardsCamera = new Vector3(0.55f, 0.4f, 1).Unit();

    // Over the camera's left shoulder.
    private static readonly Vector3 TowardsLight = new Vector3(-0.6f, 1.2f, 0.9f).Unit();

    // Distance and radius of the luminaire in half diagonals of the model, and its radiance: a white matt surface that faces it
    // has the radiance 6 · (1.5/5)² = 0.54, and up to 0.35 more from the background.
    private const float LightDistance = 5;
    private const float LightRadius = 1.5f;
    private const float LightRadiance = 6;
    private static readonly Rgb Background = new(0.3f, 0.32f, 0.35f);

    // So far below the model, in half diagonals, that it shows nothing of a model that is flat there.
    private const float GroundDepth = 1e-4f;

    /// <summary>The scene of a model as it is rendered by itself.</summary>
    /// <param name="model">The model.</param>
    /// <param name="up">The direction that is up; null for that of the format.</param>
    /// <returns>The scene, with what the model does not have, and the model's notes, with one more on what was made up.</returns>
    public static ImportedModel Complete(ImportedModel model, Vector3? up = null)
    {
        SceneDescription scene = model.Scene;
        Bounds box = ModelExtent.Of(scene.Shapes);
        (Vector3 center, float extent) = CenterAndExtent(box);
        Frame axes = Axes(up ?? model.Up);
        List<string> notes = [.. model.Notes];
        bool isDark = scene.Lights.Count == 0 && !scene.Shapes.Any(IsLamp);
        scene = scene with
        {
            Camera = model.Camera ?? Camera(box, center, axes),
            Render = scene.Render with { Integrator = Integrator.Path, Exposure = Exposure.Auto },
        };
        if (isDark)
        {
            scene = scene with { Background = Background, Lights = [Light(center, extent, axes)] };
        }

        if (isDark && model.Camera is null && box.IsFinite)
        {
            scene = scene with { Shapes = [.. scene.Shapes, Ground(box, extent, axes)] };
        }

        notes.AddRange((model.Camera is null, isDark) switch
        {
            (true, true) =>
                ["the file has no camera and no light: it is shown from the front, right and above, in made-up light on a made-up ground (--up y or z)"],
            (true, false) => ["the file has no camera: the whole model is shown from the front, right and above (--up y or z)"],
            (false, true) => ["the file has no light: a large luminaire and a grey background are added"],
            _ => Array.Empty<string>(),
        });
        return model with { Scene = scene, Notes = notes };
    }

    /// <summary>The middle of a box and half its diagonal; the origin and 1 where there is nothing.</summary>
    private static (Vector3 Center, float Extent) CenterAndExtent(in Bounds box)
    {
        float extent = ((box.Maximum * 0.5f) - (box.Minimum * 0.5f)).Norm();
        return box.IsFinite ? ((box.Minimum * 0.5f) + (box.Maximum * 0.5f), extent > 0 && float.IsFinite(extent) ? extent : 1) : (Vector3.Zero, 1);
    }

    // To the right, up, and to the front: x, y and z where y is up, and x, z and −y where z is.
    private static Frame Axes(Vector3 up)
    {
        up = up.Unit();
        Vector3 right = Vector3.UnitX - (up * up.X);
        right = right.Norm() > 1e-3f ? right.Unit() : Vector3.UnitY;
        return new(right, up, right.Cross(up));
    }

    private static Vector3 At(in Frame axes, Vector3 local) => (axes.Right * local.X) + (axes.Up * local.Y) + (axes.Front * local.Z);

    // As near as all corners of the box are in the picture.
    private static CameraDescription Camera(in Bounds box, Vector3 center, in Frame axes)
    {
        Vector3 back = At(axes, TowardsCamera);
        Vector3 right = axes.Up.Cross(back).Unit();
        Vector3 above = back.Cross(right);
        LaneMath.SinCosTurn(FieldOfViewDegrees / 2 / 360, out float sin, out float cos);
        float slope = Filling * sin / cos;
        float distance = 0;
        for (int i = 0; i < 8 && box.IsFinite; i++)
        {
            Vector3 corner = new(
                ((i & 1) == 0 ? box.Minimum : box.Maximum).X, ((i & 2) == 0 ? box.Minimum : box.Maximum).Y, ((i & 4) == 0 ? box.Minimum : box.Maximum).Z);
            Vector3 to = corner - center;
            float aside = float.Max(float.Abs(to.Dot(right)), float.Abs(to.Dot(above)));
            distance = float.Max(distance, to.Dot(back) + (aside / slope));
        }

        return new()
        {
            Position = center + (back * (distance > 0 && float.IsFinite(distance) ? distance : 1 / slope)),
            LookAt = center,
            Up = axes.Up,
            FieldOfView = FieldOfViewDegrees,
            FieldOfViewAxis = FieldOfViewAxis.Smaller,
        };
    }

    private static SphereDescription Light(Vector3 center, float extent, in Frame axes) => new()
    {
        Name = "made-up light",
        Center = center + (At(axes, TowardsLight) * (LightDistance * extent)),
        Radius = LightRadius * extent,
        Material = new LuminaireMaterialDescription { Color = new SolidTextureDescription { Color = Rgb.White }, Multiplier = LightRadiance },
    };

    // Below the lowest corner of the box.
    private static PlaneDescription Ground(in Bounds box, float extent, in Frame axes)
    {
        Vector3 up = axes.Up;
        Vector3 lowest = new(
            (up.X > 0 ? box.Minimum : box.Maximum).X, (up.Y > 0 ? box.Minimum : box.Maximum).Y, (up.Z > 0 ? box.Minimum : box.Maximum).Z);
        return new() { Name = "made-up ground", Point = lowest - (up * (GroundDepth * extent)), Normal = up };
    }

    // Materials that shine are headlights, screens or signs, and leave a scene dark.
    private static bool IsLamp(ShapeDescription shape) => shape switch
    {
        GroupDescription group => group.Shapes.Any(IsLamp),
        InstanceDescription { Of: { } of } => IsLamp(of),
        _ => shape is PunctualLightDescription,
    };

    private readonly record struct Frame(Vector3 Right, Vector3 Up, Vector3 Front);
}
