namespace RayTracer.Tests.Scenes;

/// <summary>The files of the repository that tests read, and rewrite where RAYTRACER_UPDATE is 1.</summary>
internal static class RepositoryFolder
{
    private const string Regenerate = "Run the tests with the environment variable RAYTRACER_UPDATE=1 to write it anew, then read what changed.";

    public static string Root { get; } = FindRoot();

    public static string PathOf(params string[] parts) => Path.Combine([Root, .. parts]);

    public static void AssertHolds(string path, string expected)
    {
        if (Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1")
        {
            File.WriteAllText(path, expected);
        }

        string actual = File.Exists(path) ? File.ReadAllText(path).ReplaceLineEndings("\n") : "(no file)";
        Assert.True(expected == actual, $"{Path.GetRelativePath(Root, path)} is out of date. {Regenerate}\nexpected:\n{expected}\nfound:\n{actual}");
    }

    private static string FindRoot()
    {
        for (string? folder = AppContext.BaseDirectory; folder is not null; folder = Path.GetDirectoryName(folder))
        {
            if (File.Exists(Path.Combine(folder, "RayTracer.sln")))
            {
                return folder;
            }
        }

        throw new DirectoryNotFoundException("The tests must run within the repository.");
    }
}
