namespace RayTracer.Testing;

/// <summary>Where the project lies, and what lies beside it.</summary>
public static class ProjectFolder
{
    /// <summary>The folder that holds RayTracer.sln; null where the tests are another project's.</summary>
    public static string? Found { get; } = FindRoot();

    /// <summary>The folder that holds RayTracer.sln.</summary>
    /// <exception cref="DirectoryNotFoundException">The tests do not run within it.</exception>
    public static string Root => Found ?? throw new DirectoryNotFoundException("The tests must run within the project's folder.");

    /// <summary>A file or folder of the project.</summary>
    public static string PathOf(params string[] parts) => Path.Combine([Root, .. parts]);

    /// <summary>A file or folder of <c>shared</c> beside the project, or null where there is none; then tests that need it are skipped.</summary>
    public static string? Shared(params string[] parts)
    {
        string path = Path.GetFullPath(Path.Combine([Root, "..", "shared", .. parts]));
        return Path.Exists(path) ? path : null;
    }

    private static string? FindRoot()
    {
        for (string? folder = AppContext.BaseDirectory; folder is not null; folder = Path.GetDirectoryName(folder))
        {
            if (File.Exists(Path.Combine(folder, "RayTracer.sln")))
            {
                return folder;
            }
        }

        return null;
    }
}
