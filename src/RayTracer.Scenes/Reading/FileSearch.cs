using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Says why a file cannot be opened.</summary>
internal static class FileSearch
{
    /// <summary>The reason why there is no file at a path, with the most similar name beside it; null where there is one.</summary>
    /// <param name="path">The file's path.</param>
    public static string? Complaint(string path)
    {
        if (File.Exists(path))
        {
            return null;
        }

        if (path.Length == 0 || path.Contains('\0', StringComparison.Ordinal))
        {
            return "file not found";
        }

        if (Directory.Exists(path))
        {
            return "it is a folder, not a file";
        }

        string folder = Path.GetDirectoryName(Path.GetFullPath(path)) ?? path;
        if (!Directory.Exists(folder))
        {
            return "file not found: its folder does not exist";
        }

        return "file not found" + Spelling.DidYouMean(Path.GetFileName(path), Names(folder));
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
