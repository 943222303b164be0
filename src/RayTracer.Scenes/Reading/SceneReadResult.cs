using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>The result of reading a scene file.</summary>
public sealed class SceneReadResult
{
    internal SceneReadResult(SourceText? source, JsonNode? root, SceneDescription? partial, SourceMap map, IEnumerable<Diagnostic> diagnostics)
    {
        Source = source;
        Root = root;
        Partial = partial;
        SourceMap = map;
        Diagnostics = Diagnostic.Sort(diagnostics);
        Description = Diagnostics.Any(d => d.Severity == Severity.Error) ? null : partial;
    }

    /// <summary>The scene; null where any diagnostic is an error.</summary>
    public SceneDescription? Description { get; }

    /// <summary>The diagnostics, by position.</summary>
    public IReadOnlyList<Diagnostic> Diagnostics { get; }

    /// <summary>The place of each record of the scene in the file.</summary>
    public SourceMap SourceMap { get; }

    /// <summary>The file's JSON, for editors; null after an error of syntax.</summary>
    public JsonNode? Root { get; }

    /// <summary>The file's text, which the offsets of <see cref="Root"/> count in; null where it could not be read.</summary>
    public SourceText? Source { get; }

    // What could be read in spite of errors, with defaults in place of what could not.
    internal SceneDescription? Partial { get; }
}
