namespace RayTracer.Session;

/// <summary>Finds the folder of the scenes that come with the program.</summary>
public static class ScenesFolder
{
    // What no other folder of that name has.
    private const string Mark = "raytracer.schema.json";

    /// <summary>The folder "scenes" beside or above the program, or else the current folder; null where there is none.</summary>
    public static string? Find() => new[] { AppContext.BaseDirectory, Environment.CurrentDirectory }
        .SelectMany(Upwards)
        .Select(f => Path.Combine(f, "scenes"))
        .FirstOrDefault(f => File.Exists(Path.Combine(f, Mark)));

    private static IEnumerable<string> Upwards(string folder)
    {
        for (DirectoryInfo? at = new(folder); at is not null; at = at.Parent)
        {
            yield return at.FullName;
        }
    }
}
