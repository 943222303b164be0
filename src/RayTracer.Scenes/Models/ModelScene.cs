using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Scenes;

/// <summary>Makes a scene of a model file alone: what it lacks to be seen, a camera or light, is made up, and said.</summary>
internal static class ModelScene
{
    /// <summary>The scene that shows a model, which it names by its file.</summary>
    /// <param name="model">The contents of the file.</param>
    /// <param name="file">The file, as a scene names it.</param>
    /// <param name="up">The direction that is up; null for that of the format.</param>
    /// <returns>The scene, and a sentence on what was made up. The model's own notes are reported when the scene is built.</returns>
    public static (SceneDescription Scene, IReadOnlyList<string> Notes) Of(ImportedModel model, string file, Vector3? up = null)
    {
        ImportedModel complete = DefaultView.Complete(model, up);
        SceneDescription scene = complete.Scene with
        {
            Textures = new Dictionary<string, TextureDescription>(),
            Materials = new Dictionary<string, MaterialDescription>(),
            Objects = new Dictionary<string, ShapeDescription>(),
            Shapes = [new ModelDescription { File = file }, .. complete.Scene.Shapes.Skip(model.Scene.Shapes.Count)],
            Lights = model.Scene.Lights.Count == 0 ? complete.Scene.Lights : [],
        };
        return (scene, [.. complete.Notes.Skip(model.Notes.Count)]);
    }

    /// <summary>Reads the scene of a model.</summary>
    /// <param name="path">The file's path, by which diagnostics call it.</param>
    /// <param name="folder">Loads the model, by its file name.</param>
    /// <param name="settings">Values to put in the place of the scene's later; with another <c>camera.up</c>, the whole view is another.</param>
    internal static SceneReadResult Read(string path, ModelFolder folder, IReadOnlyList<SceneSetting>? settings = null)
    {
        SourceText source = new(path, "");
        string name = Path.GetFileName(path);
        try
        {
            (SceneDescription scene, IReadOnlyList<string> notes) = Of(folder.Load(name), name, Up(settings));
            return new(source, null, scene, new(), notes.Select(n => new Diagnostic(path, 0, 0, Severity.Note, n)));
        }
        catch (ModelException e)
        {
            return new(source, null, null, new(), [new(path, 0, 0, Severity.Error, e.Message)]);
        }
    }

    private static Vector3? Up(IReadOnlyList<SceneSetting>? settings)
    {
        string[] parts = settings?.LastOrDefault(s => s.Path == "camera.up")?.Value.Trim('[', ']').Split(',') ?? [];
        float[] numbers = [.. parts.Select(p => float.TryParse(p, CultureInfo.InvariantCulture, out float number) ? number : float.NaN)];
        return numbers is [var x, var y, var z] && new Vector3(x, y, z) is var up && up.Norm() is > 0 and < float.PositiveInfinity ? up : null;
    }
}
