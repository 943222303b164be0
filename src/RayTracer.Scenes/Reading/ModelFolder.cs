using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Loads models by paths relative to a folder, each only once.</summary>
internal sealed class ModelFolder(string folder, Func<string, ImportedModel>? read = null)
{
    private readonly Dictionary<string, ImportedModel> _models = new(StringComparer.Ordinal);

    /// <summary>Loads a model.</summary>
    /// <param name="path">The path as it is written in the scene file.</param>
    /// <exception cref="ModelException">It cannot be read.</exception>
    public ImportedModel Load(string path)
    {
        // Whole, so that the paths of pictures beside the model do not depend on the scene's folder.
        string full = Path.GetFullPath(Path.Combine(folder, path));
        if (_models.TryGetValue(full, out ImportedModel? model))
        {
            return model;
        }

        try
        {
            if (FileSearch.Complaint(full) is { } complaint)
            {
                throw new ModelException(complaint);
            }

            model = (read ?? ModelFile.Read)(full);
        }
        catch (Exception e) when (e is ModelException or IOException or UnauthorizedAccessException or ArgumentException)
        {
            throw new ModelException($"cannot read {Quotation.Of(path)}: {e.Message.TrimEnd('.')}", e);
        }

        _models.Add(full, model);
        return model;
    }
}
