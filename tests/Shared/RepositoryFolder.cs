namespace RayTracer.Testing;

/// <summary>The files of the repository that tests read, and rewrite where RAYTRACER_UPDATE is 1.</summary>
internal static class RepositoryFolder
{
    private const string Regenerate = "Run the tests with the environment variable RAYTRACER_UPDATE=1 to write it anew, then read what changed.";

    public static void AssertHolds(string path, string expected)
    {
        if (Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1")
        {
            File.WriteAllText(path, expected);
        }

        string actual = File.Exists(path) ? File.ReadAllText(path).ReplaceLineEndings("\n") : "(no file)";
        Assert.True(expected == actual, $"{Path.GetRelativePath(ProjectFolder.Root, path)} is out of date. {Regenerate}\nexpected:\n{expected}\nfound:\n{actual}");
    }
}
