namespace RayTracer.Scenes;

/// <summary>The folder that scenes, and the files that they name, must be in. A program that reads other people's scenes sets it before the first one.</summary>
public static class SceneFolder
{
    /// <summary>The folder; null where scenes may name any file.</summary>
    public static string? Root { get; set; }

    /// <summary>Returns whether a file is in a folder or below it, wherever links lead.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="path">The file; it need not exist.</param>
    public static bool IsWithin(string folder, string path)
    {
        string root = Path.TrimEndingDirectorySeparator(Real(Path.GetFullPath(folder))) + Path.DirectorySeparatorChar;
        return Real(Path.GetFullPath(path)).StartsWith(root, OperatingSystem.IsWindows() ? StringComparison.OrdinalIgnoreCase : StringComparison.Ordinal);
    }

    // A whole path with each of its links followed.
    private static string Real(string path)
    {
        if (Path.GetDirectoryName(path) is not { } parent)
        {
            return path;
        }

        string real = Path.Combine(Real(parent), Path.GetFileName(path));
        FileSystemInfo entry = Directory.Exists(real) ? new DirectoryInfo(real) : new FileInfo(real);
        return entry.LinkTarget is null ? real : entry.ResolveLinkTarget(returnFinalTarget: true) is { } target ? Real(target.FullName) : real;
    }
}
