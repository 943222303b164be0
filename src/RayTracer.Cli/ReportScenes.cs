namespace RayTracer.Cli;

/// <summary>Finds the scenes of the report that the project follows.</summary>
internal static class ReportScenes
{
    /// <summary>Their folder, within the repository.</summary>
    public const string Folder = "scenes/report";

    /// <summary>Their files, and the Cornell box, where it lies beside their folder: what is measured unless other scenes are named.</summary>
    /// <exception cref="CommandException">There are none.</exception>
    public static IReadOnlyList<string> FindMeasured()
    {
        IReadOnlyList<string> scenes = Find();
        string box = Path.Combine(Path.GetDirectoryName(scenes[0])!, "..", "cornell.json");
        return File.Exists(box) ? [.. scenes, box] : scenes;
    }

    /// <summary>Their files, in order of their names: of the current folder, or of one above the program.</summary>
    /// <exception cref="CommandException">There are none.</exception>
    public static IReadOnlyList<string> Find()
    {
        List<string> folders = ["."];
        for (DirectoryInfo? folder = new(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            folders.Add(folder.FullName);
        }

        foreach (string folder in folders)
        {
            string scenes = folder == "." ? Folder : Path.Combine(folder, Folder);
            string[] found = Directory.Exists(scenes) ? Directory.GetFiles(scenes, "*.json") : [];
            if (found.Length > 0)
            {
                return [.. found.Order(StringComparer.Ordinal)];
            }
        }

        throw new CommandException(ExitStatus.InputOutput, $"there are no scenes in {Folder}, neither here nor above the program");
    }
}
