namespace RayTracer.Session;

/// <summary>Where a document is at home.</summary>
/// <param name="Name">What it is called: a file's name without its folder.</param>
/// <param name="Path">The whole path of its file; null where it has none yet.</param>
/// <param name="Folder">The folder from which the files that it names are looked for.</param>
public sealed record DocumentPlace(string Name, string? Path, string Folder)
{
    /// <summary>What ends a line of the file; the document itself has \n.</summary>
    public string LineEnd { get; init; } = "\n";

    /// <summary>The place of a file.</summary>
    public static DocumentPlace Of(string path) => new(System.IO.Path.GetFileName(path), path, System.IO.Path.GetDirectoryName(path) ?? "");
}
