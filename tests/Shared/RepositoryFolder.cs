namespace RayTracer.Testing;

/// <summary>The files of the repository that tests read, and rewrite where RAYTRACER_UPDATE is 1.</summary>
internal static class RepositoryFolder
{
    private const int MostLines = 6;
    private const string Regenerate = "Run the tests with the environment variable RAYTRACER_UPDATE=1 to write it again, then read what changed.";

    public static void AssertHolds(string path, string expected)
    {
        if (Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1")
        {
            File.WriteAllText(path, expected);
        }

        string actual = File.Exists(path) ? File.ReadAllText(path).ReplaceLineEndings("\n") : "";
        Assert.True(expected == actual, $"{Path.GetRelativePath(ProjectFolder.Root, path)} is out of date. {Regenerate}\n{FirstDifference(expected, actual)}");
    }

    /// <summary>The first lines that differ, with their numbers: as they should be after a "+", as they are in the file after a "-".</summary>
    public static string FirstDifference(string expected, string actual)
    {
        string[] wanted = expected.Split('\n');
        string[] found = actual.Split('\n');
        int first = wanted.Zip(found).TakeWhile(l => l.First == l.Second).Count();
        int last = wanted[first..].Reverse().Zip(found[first..].Reverse()).TakeWhile(l => l.First == l.Second).Count();
        return string.Join('\n', [.. Part(found, '-'), .. Part(wanted, '+')]);

        IEnumerable<string> Part(string[] lines, char mark)
        {
            string[] part = lines[first..^last];
            IEnumerable<string> shown = part.Take(MostLines).Select((l, i) => $"{first + i + 1,6} {mark} {l}");
            return part.Length > MostLines ? shown.Append($"       {mark} … and {part.Length - MostLines} lines more") : shown;
        }
    }
}
