namespace RayTracer.Session.Tests;

/// <summary>The scenes that come with the program.</summary>
internal static class ShippedScenes
{
    public static string Folder => Path.Combine(ProjectFolder.Root, "scenes");

    /// <summary>All whole scenes, by their paths within the folder.</summary>
    public static IEnumerable<string> Paths => Directory.EnumerateFiles(Folder, "*.json", SearchOption.AllDirectories)
        .Select(p => Path.GetRelativePath(Folder, p).Replace('\\', '/'))
        .Where(p => !p.StartsWith("broken/", StringComparison.Ordinal) && !p.EndsWith(".schema.json", StringComparison.Ordinal))
        .Order(StringComparer.Ordinal);

    public static TheoryData<string> All => [.. Paths];

    public static string Text(string path) => File.ReadAllText(Path.Combine(Folder, path)).ReplaceLineEndings("\n");
}
