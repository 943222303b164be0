namespace RayTracer.Scenes;

/// <summary>A place in a file, as messages name it.</summary>
/// <param name="File">The file, as its user named it.</param>
/// <param name="Line">The line, from 1; 0 where it is the file as a whole.</param>
/// <param name="Column">The column, from 1, in UTF-16 units; 0 where there is no line.</param>
public readonly record struct SourcePlace(string File, int Line, int Column)
{
    /// <summary>Says something about the place.</summary>
    public Diagnostic At(Severity severity, string message) => new(File, Line, Column, severity, message);
}
