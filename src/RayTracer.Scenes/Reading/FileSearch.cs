using RayTracer.Description;
using RayTracer.Imaging;

namespace RayTracer.Scenes;

/// <summary>The gate that every file of a scene passes: says why one cannot be opened, and keeps what is read from being written over.</summary>
internal static class FileSearch
{
    private const string NotFound = "file not found";

    /// <summary>Returns whether a scene may read a file, but there is none.</summary>
    public static bool IsMissing(string path) => Complaint(path)?.StartsWith(NotFound, StringComparison.Ordinal) == true;

    /// <summary>The reason why a scene cannot read a file: there is none, with the most similar name beside it, or it is none that ends; else null.</summary>
    /// <param name="path">The file's path.</param>
    /// <param name="isStream">True where a pipe or a device will do.</param>
    public static string? Complaint(string path, bool isStream = false)
    {
        if (SceneFolder.Root is { } root && !SceneFolder.IsWithin(root, path))
        {
            return "it is outside of the folder that scenes may read";
        }

        if (File.Exists(path))
        {
            InputFiles.Add(path);
            return isStream || Length(path) > 0 ? null : "it is empty, or a pipe or a device: only ordinary files are read";
        }

        if (path.Length == 0 || path.Contains('\0', StringComparison.Ordinal))
        {
            return NotFound;
        }

        if (Directory.Exists(path))
        {
            return "it is a folder, not a file";
        }

        string folder = Path.GetDirectoryName(Path.GetFullPath(path)) ?? path;
        if (!Directory.Exists(folder))
        {
            return $"{NotFound}: its folder does not exist";
        }

        return NotFound + Spelling.DidYouMean(Path.GetFileName(path), Names(folder));
    }

    // Pipes and devices have none.
    private static long Length(string path)
    {
        FileInfo file = new(path);
        return file.LinkTarget is null ? file.Length : (file.ResolveLinkTarget(returnFinalTarget: true) as FileInfo)?.Length ?? 0;
    }

    private static IEnumerable<string> Names(string folder)
    {
        try
        {
            return [.. Directory.EnumerateFiles(folder).Take(Spelling.MostCandidates).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal)];
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }
}
