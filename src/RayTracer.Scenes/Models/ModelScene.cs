using RayTracer.Description;
using RayTracer.Shapes;

namespace RayTracer.Scenes;

/// <summary>Makes a scene of a model file alone: what it lacks to be seen, a camera or light, is made up, and said.</summary>
internal static class ModelScene
{
    /// <summary>The scene that shows a model, which it names by its file.</summary>
    /// <param name="model">What the file holds.</param>
    /// <param name="file">The file, as a scene names it.</param>
    /// <returns>The scene, and a sentence for each thing that was made up. The model's own notes are reported when the scene is built.</returns>
    public static (SceneDescription Scene, IReadOnlyList<string> Notes) Of(ImportedModel model, string file)
    {
        ImportedModel complete = DefaultView.Complete(model);
        SceneDescription scene = complete.Scene with
        {
            Textures = new Dictionary<string, TextureDescription>(),
            Materials = new Dictionary<string, MaterialDescription>(),
            Objects = new Dictionary<string, ShapeDescription>(),
            Shapes = [new ModelDescription { File = file }],
            Lights = model.Scene.Lights.Count == 0 ? complete.Scene.Lights : [],
        };
        return (scene, [.. complete.Notes.Skip(model.Notes.Count)]);
    }

    /// <summary>Reads the scene of a model.</summary>
    /// <param name="path">The file's path, by which diagnostics call it.</param>
    /// <param name="folder">Loads the model, by its file name.</param>
    internal static SceneReadResult Read(string path, ModelFolder folder)
    {
        SourceText source = new(path, "");
        string name = Path.GetFileName(path);
        try
        {
            (SceneDescription scene, IReadOnlyList<string> notes) = Of(folder.Load(name), name);
            return new(source, null, scene, new(), notes.Select(n => new Diagnostic(path, 0, 0, Severity.Warning, n)));
        }
        catch (ModelException e)
        {
            return new(source, null, null, new(), [new(path, 0, 0, Severity.Error, e.Message)]);
        }
    }
}
