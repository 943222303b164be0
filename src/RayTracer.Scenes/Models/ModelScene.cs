using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Scenes;

/// <summary>Makes a scene of a model file alone: what it lacks to be seen, a camera or light, is made up, and said.</summary>
internal static class ModelScene
{
    private const float FieldOfView = 40;

    /// <summary>The scene of a model.</summary>
    /// <param name="path">The file's path, by which diagnostics call it.</param>
    /// <param name="folder">Loads the model, by its file name.</param>
    public static SceneReadResult Read(string path, ModelFolder folder)
    {
        SourceText source = new(path, "");
        string name = Path.GetFileName(path);
        try
        {
            ImportedModel model = folder.Load(name);
            List<Diagnostic> made = [];
            SceneDescription scene = Complete(model, new() { File = name }, message => made.Add(new(path, 0, 0, Severity.Warning, message)));
            return new(source, null, scene, new(), made);
        }
        catch (ModelException e)
        {
            return new(source, null, null, new(), [new(path, 0, 0, Severity.Error, e.Message)]);
        }
    }

    private static SceneDescription Complete(ImportedModel model, ModelDescription description, Action<string> say)
    {
        Bounds box = ModelExtent.Of(model.Scene.Shapes);
        Vector3 center = box.IsFinite ? (box.Minimum * 0.5f) + (box.Maximum * 0.5f) : default;
        float radius = box.IsFinite ? float.Max(0.5f * (box.Maximum - box.Minimum).Norm(), 1e-30f) : 1;
        CameraDescription? camera = model.Camera;
        if (camera is null)
        {
            // From the right, a little above, and so far that the ball around the box is in the picture.
            float distance = radius * 1.1f / LaneMath.Tan(FieldOfView * (float.Pi / 360));
            camera = new() { Position = center + (new Vector3(0.45f, 0.35f, 1).Unit() * distance), LookAt = center, FieldOfView = FieldOfView, FieldOfViewAxis = FieldOfViewAxis.Smaller };
            say($"there is no camera in the file: one was made up at {Text(camera.Position)} that looks at {Text(camera.LookAt)}");
        }

        SceneDescription scene = model.Scene with { Camera = camera, Shapes = [description], Lights = [] };
        if (!model.Scene.Shapes.Concat(model.Scene.Lights).Any(Shines))
        {
            SphereDescription lamp = new()
            {
                Center = center + (new Vector3(-2.5f, 4, 3) * radius),
                Radius = radius,
                Material = new LuminaireMaterialDescription { Multiplier = 30 },
            };
            scene = scene with { Lights = [lamp], Background = new(0.2f, 0.23f, 0.28f) };
            say($"there is no light in the file: a lamp at {Text(lamp.Center)} and a grey sky were made up");
        }

        return scene;
    }

    private static bool Shines(ShapeDescription shape) => shape switch
    {
        GroupDescription group => group.Shapes.Any(Shines),
        InstanceDescription instance => instance.Of is not null && Shines(instance.Of),
        MeshDescription { Materials: { Count: > 0 } materials } => materials.OfType<LuminaireMaterialDescription>().Any(),
        _ => shape.Material is LuminaireMaterialDescription,
    };

    private static string Text(Vector3 v) => string.Create(CultureInfo.InvariantCulture, $"({v.X:G4}, {v.Y:G4}, {v.Z:G4})");
}
