using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Reads a model file as if it were a scene file: with a camera and light made up where it has none.</summary>
internal static class ModelScene
{
    /// <summary>Reads a file. What is wrong with it becomes a diagnostic; what could not be shown or was made up, warnings.</summary>
    /// <param name="path">The model file's path, by which diagnostics call it too.</param>
    public static SceneReadResult Read(string path)
    {
        SourceText nothing = new(path, "");
        try
        {
            if (FileSearch.Complaint(path) is { } complaint)
            {
                throw new ModelException(complaint);
            }

            ImportedModel model = DefaultView.Complete(ModelFile.Read(path));
            return new(nothing, null, model.Scene, new(), model.Notes.Select(n => new Diagnostic(path, 0, 0, Severity.Warning, n)));
        }
        catch (Exception e) when (e is ModelException or IOException or UnauthorizedAccessException or ArgumentException)
        {
            return new(nothing, null, null, new(), [new(path, 0, 0, Severity.Error, e.Message.ReplaceLineEndings(" ").TrimEnd('.'))]);
        }
    }
}
