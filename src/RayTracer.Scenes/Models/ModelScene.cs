using RayTracer.Description;
using RayTracer.Shapes;

namespace RayTracer.Scenes;

/// <summary>Makes a scene of a model file alone: what it lacks to be seen, a camera or light, is made up, and said.</summary>
internal static class ModelScene
{
    /// <summary>The scene of a model.</summary>
    /// <param name="path">The file's path, by which diagnostics call it.</param>
    /// <param name="folder">Loads the model, by its file name.</param>
    public static SceneReadResult Read(string path, ModelFolder folder)
    {
        SourceText source = new(path, "");
        string name = Path.GetFileName(path);
        try
        {
            // The model's own notes are told when it is built, as for a model within a scene.
            ImportedModel model = folder.Load(name);
            ImportedModel complete = DefaultView.Complete(model);
            SceneDescription scene = complete.Scene with
            {
                Shapes = [new ModelDescription { File = name }],
                Lights = model.Scene.Lights.Count == 0 ? complete.Scene.Lights : [],
            };
            return new(source, null, scene, new(), complete.Notes.Skip(model.Notes.Count).Select(n => new Diagnostic(path, 0, 0, Severity.Warning, n)));
        }
        catch (ModelException e)
        {
            return new(source, null, null, new(), [new(path, 0, 0, Severity.Error, e.Message)]);
        }
    }
}
