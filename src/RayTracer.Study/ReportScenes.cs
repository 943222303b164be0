using RayTracer.Jobs;

namespace RayTracer.Study;

/// <summary>Finds the scenes of the report that the project follows.</summary>
internal static class ReportScenes
{
    /// <summary>Their folder, within the repository.</summary>
    public const string Folder = "scenes/report";

    /// <summary>
    /// Their files, and the Cornell box, where it lies beside their folder: what is measured unless other scenes are named.
    /// </summary>
    /// <exception cref="JobException">There are none.</exception>
    public static IReadOnlyList<string> FindMeasured()
    {
        IReadOnlyList<string> scenes = Find();
        string box = Path.Combine(Path.GetDirectoryName(scenes[0])!, "..", "cornell.json");
        return File.Exists(box) ? [.. scenes, box] : scenes;
    }

    /// <summary>Their files, in order of their names: of the current folder, or of one above the program.</summary>
    /// <exception cref="JobException">There are none.</exception>
    public static IReadOnlyList<string> Find()
    {
        List<string> folders = [Folder];
        for (DirectoryInfo? folder = new(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            folders.Add(Path.Combine(folder.FullName, Folder));
        }

        return folders.Where(Directory.Exists).Select(f => Directory.GetFiles(f, "*.json")).FirstOrDefault(f => f.Length > 0) is { } found
            ? [.. found.Order(StringComparer.Ordinal)]
            : throw new JobException($"there are no scenes in {Folder}, neither here nor above the program");
    }

    /// <summary>The file of one of them.</summary>
    /// <exception cref="JobException">It is not there.</exception>
    public static string PathOf(ReportScene scene) =>
        Find().FirstOrDefault(p => Path.GetFileName(p) == scene.File) ?? throw new JobException($"{scene.File} is missing in {Folder}");
}
