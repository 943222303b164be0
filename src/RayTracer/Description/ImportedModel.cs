namespace RayTracer.Description;

/// <summary>What a model file holds, in the terms of scenes.</summary>
/// <param name="Scene">Shapes (groups, meshes, instances) with their materials, and lights as shapes that shine.</param>
/// <param name="Notes">What could not be represented exactly, one sentence each without a final stop: shown as warnings, once a file.</param>
public sealed record ImportedModel(SceneDescription Scene, IReadOnlyList<string> Notes)
{
    /// <summary>The file's first camera; null where there is none.</summary>
    public CameraDescription? Camera { get; init; }
}

/// <summary>A model file that cannot be read; the message says what is wrong and where (line or byte offset), for the user.</summary>
public sealed class ModelException : Exception
{
    /// <summary>Says what is wrong.</summary>
    public ModelException(string message) : base(message)
    {
    }

    /// <summary>Says what is wrong, and what caused it.</summary>
    public ModelException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>An unnamed fault.</summary>
    public ModelException()
    {
    }
}
